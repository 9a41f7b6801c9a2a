//! Clocks, pins and peripherals of the board, as in the table of `docs/controller.md`.

use super::inputs::{Converters, Inputs};
use super::outputs::Pwm;
use super::sectors::Sectors;
use super::watchdog::Watchdog;
use crate::bus::{self, Bus};
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use smartbed_firmware::tile::board::Lines;
use stm32f4xx_hal::gpio::{AnyPin, Output, PB6, PB7, PB8, PB9};
use stm32f4xx_hal::pac::{CAN1, DMA2, Peripherals, USART1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::qei::Qei;
use stm32f4xx_hal::rcc::Config;

/// Clock of the core (Hz), from a crystal of 8 MHz.
const CLOCK: u32 = 168_000_000;
/// PWM frequency of both bridges' inputs (Hz).
const PWM: u32 = 20_000;
/// Position of the reset cause in RCC_CSR: the highest byte (RM0090, 7.3.21).
const REASON: u32 = 24;

/// Hardware that the board's program uses.
pub struct Board {
    /// Reads the hardware.
    pub sensors: Inputs,
    /// Sets the hardware.
    pub actuators: Lines<Pwm, AnyPin<Output>>,
    /// The bus.
    pub bus: Bus,
    /// Pages of the store.
    pub flash: Sectors,
    /// Resets the chip if a tick is 50 ms late.
    pub watchdog: Watchdog,
    /// Toggles each tick, for a watchdog outside the chip.
    pub alive: AnyPin<Output>,
    /// The tile's number: the sum of 1, 2, 4, 8 and 16 for each strap that is missing.
    pub number: u8,
    /// Cause of the reset.
    pub reason: u8,
    /// The timer of ticks, ready but not running.
    pub clock: SYST,
}

/// Hardware that a bus may need; each image has one bus.
#[expect(dead_code, reason = "an image uses what its own bus needs")]
pub struct Wires {
    /// The serial line's controller.
    pub usart: USART1,
    /// Its pins: to send, to receive.
    pub serial: (PB6, PB7),
    /// The CAN bus's controller.
    pub can: CAN1,
    /// Its pins: to receive, to send.
    pub pair: (PB8, PB9),
    /// DMA for bytes.
    pub dma: DMA2,
    /// The tile's number.
    pub number: u8,
}

/// Sets everything up; None if it has been taken before.
// Not inlined: only then is all of the clocks' set-up inlined into it, which leaves no panic.
#[inline(never)]
pub fn take() -> Option<Board> {
    let (chip, core) = (Peripherals::take()?, cortex_m::Peripherals::take()?);
    let reason = (chip.RCC.csr().read().bits() >> REASON) as u8;
    chip.RCC.csr().modify(|_, w| w.rmvf().set_bit());
    let config = Config::hse(8.MHz()).sysclk(168.MHz()).pclk1(42.MHz()).pclk2(84.MHz());
    let mut rcc = chip.RCC.freeze(config);

    let (a, b) = (chip.GPIOA.split(&mut rcc), chip.GPIOB.split(&mut rcc));
    let (c, d) = (chip.GPIOC.split(&mut rcc), chip.GPIOD.split(&mut rcc));
    // Outputs first, all low: nothing is powered during the rest of the set-up.
    let enable = b.pb5.into_push_pull_output().erase();
    let (supply, vent) = (c.pc8.into_push_pull_output().erase(), c.pc9.into_push_pull_output().erase());
    let alive = b.pb10.into_push_pull_output().erase();

    let (_, (up_a, down_a, up_b, down_b)) = chip.TIM1.pwm_hz(PWM.Hz(), &mut rcc);
    let (_, (up_c, down_c, ..)) = chip.TIM8.pwm_hz(PWM.Hz(), &mut rcc);
    let drives = [
        (Pwm::one(up_a.with(a.pa8).erase()), Pwm::one(down_a.with(a.pa9).erase())),
        (Pwm::one(up_b.with(a.pa10).erase()), Pwm::one(down_b.with(a.pa11).erase())),
        (Pwm::eight(up_c.with(c.pc6).erase()), Pwm::eight(down_c.with(c.pc7).erase())),
    ];

    // Analog pins: displacements and two currents on ports B and C, the rest on C, pressures on A.
    (b.pb0.into_analog(), b.pb1.into_analog(), a.pa4.into_analog(), a.pa5.into_analog());
    (c.pc0.into_analog(), c.pc1.into_analog(), c.pc2.into_analog(), c.pc3.into_analog(), c.pc4.into_analog());
    let converters = Converters::start(chip.ADC1, &chip.ADC_COMMON, &chip.DMA2, &mut rcc);
    let sensors = Inputs {
        encoders: (
            Qei::new(chip.TIM2, (a.pa0, a.pa1), &mut rcc),
            Qei::new(chip.TIM3, (a.pa6, a.pa7), &mut rcc),
            Qei::new(chip.TIM4, (d.pd12, d.pd13), &mut rcc),
        ),
        counts: Default::default(),
        converters,
        low: [
            d.pd0.into_pull_up_input().erase(),
            d.pd1.into_pull_up_input().erase(),
            d.pd2.into_pull_up_input().erase(),
        ],
        high: [
            d.pd3.into_pull_up_input().erase(),
            d.pd4.into_pull_up_input().erase(),
            d.pd5.into_pull_up_input().erase(),
        ],
        faults: [
            b.pb12.into_pull_up_input().erase(),
            b.pb13.into_pull_up_input().erase(),
            b.pb14.into_pull_up_input().erase(),
        ],
    };
    let straps = [
        d.pd8.into_pull_up_input().erase(),
        d.pd9.into_pull_up_input().erase(),
        d.pd10.into_pull_up_input().erase(),
        d.pd11.into_pull_up_input().erase(),
        d.pd15.into_pull_up_input().erase(),
    ];
    let number = straps.iter().rev().fold(0, |number, strap| number << 1 | u8::from(strap.is_high()));

    let (usart, can, dma) = (chip.USART1, chip.CAN1, chip.DMA2);
    let wires = Wires { usart, serial: (b.pb6, b.pb7), can, pair: (b.pb8, b.pb9), dma, number };
    let bus = bus::start(wires, &mut rcc)?;

    let mut clock = core.SYST;
    clock.set_clock_source(SystClkSource::Core);
    clock.set_reload(CLOCK / 1000 - 1);
    clock.clear_current();
    let actuators = Lines { drives, enable, supply, vent };
    let (flash, watchdog) = (Sectors::new(chip.FLASH), Watchdog::new(chip.IWDG));
    Some(Board { sensors, actuators, bus, flash, watchdog, alive, number, reason, clock })
}
