//! PWM channels of two timers as one type.

use core::convert::Infallible;
use embedded_hal::pwm::{ErrorType, SetDutyCycle};
use stm32f4xx_hal::pac::{TIM1, TIM8};
use stm32f4xx_hal::timer::pwm::ErasedChannel;

/// A channel that drives one input of a bridge.
pub enum Pwm {
    /// Of timer 1.
    One(ErasedChannel<TIM1>),
    /// Of timer 8.
    Eight(ErasedChannel<TIM8>),
}

impl Pwm {
    /// A channel of timer 1, on, at duty 0.
    pub fn one(mut channel: ErasedChannel<TIM1>) -> Self {
        channel.set_duty(0);
        channel.enable();
        Self::One(channel)
    }

    /// A channel of timer 8, on, at duty 0.
    pub fn eight(mut channel: ErasedChannel<TIM8>) -> Self {
        channel.set_duty(0);
        channel.enable();
        Self::Eight(channel)
    }
}

impl ErrorType for Pwm {
    type Error = Infallible;
}

impl SetDutyCycle for Pwm {
    fn max_duty_cycle(&self) -> u16 {
        match self {
            Self::One(channel) => channel.max_duty_cycle(),
            Self::Eight(channel) => channel.max_duty_cycle(),
        }
    }
    fn set_duty_cycle(&mut self, duty: u16) -> Result<(), Infallible> {
        match self {
            Self::One(channel) => channel.set_duty_cycle(duty),
            Self::Eight(channel) => channel.set_duty_cycle(duty),
        }
    }
}
