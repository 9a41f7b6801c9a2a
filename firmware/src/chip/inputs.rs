//! Readings: encoders by timers, voltages by a continuously running converter, switches by pins.

use core::sync::atomic::{AtomicU16, Ordering};
use smartbed_firmware::tile::board::{Readings, Sensors};
use stm32f4xx_hal::gpio::{AnyPin, Input};
use stm32f4xx_hal::hal_02::Qei as _;
use stm32f4xx_hal::pac::{ADC_COMMON, ADC1, DMA2, TIM2, TIM3, TIM4};
use stm32f4xx_hal::qei::Qei;
use stm32f4xx_hal::rcc::{Enable, Rcc, Reset};

/// Channels of the converter in this order: three displacements, three currents, the supply, two pressures.
const CHANNELS: [u32; 9] = [8, 9, 10, 11, 12, 13, 14, 4, 5];
/// Latest sample of each channel; DMA writes here, a whole round in 41 us.
static SAMPLES: [AtomicU16; CHANNELS.len()] = [const { AtomicU16::new(0) }; CHANNELS.len()];

/// The running converter.
pub struct Converters(());

impl Converters {
    /// Starts it: all channels in a continuous round, 84 cycles of sampling each at 21 MHz (RM0090, 13.13 and 10.5).
    pub fn start(adc: ADC1, common: &ADC_COMMON, dma: &DMA2, rcc: &mut Rcc) -> Self {
        ADC1::enable(rcc);
        ADC1::reset(rcc);
        DMA2::enable(rcc);
        let stream = dma.st(0);
        // SAFETY: values of the reference manual; the address is that of a static with room for all samples.
        unsafe {
            stream.par().write(|w| w.bits(adc.dr().as_ptr().addr() as u32));
            stream.m0ar().write(|w| w.bits(SAMPLES.as_ptr().addr() as u32));
            stream.ndtr().write(|w| w.bits(CHANNELS.len() as u32));
            // Channel 0, halfwords on both sides, memory increment, circular, enabled.
            stream.cr().write(|w| w.bits(1 << 13 | 1 << 11 | 1 << 10 | 1 << 8 | 1));
            // Clock: a quarter of 84 MHz.
            common.ccr().write(|w| w.bits(1 << 16));
            let (first, rest) = (order(0), order(6));
            adc.sqr3().write(|w| w.bits(first));
            adc.sqr2().write(|w| w.bits(rest));
            adc.sqr1().write(|w| w.bits((CHANNELS.len() as u32 - 1) << 20));
            // 84 cycles for every channel.
            adc.smpr1().write(|w| w.bits(0x0492_4924));
            adc.smpr2().write(|w| w.bits(0x2492_4924));
            // Scan mode; then continuous DMA, continuous conversion, on.
            adc.cr1().write(|w| w.bits(1 << 8));
            adc.cr2().write(|w| w.bits(1 << 9 | 1 << 8 | 1 << 1 | 1));
            // The converter needs 3 us to stabilise.
            cortex_m::asm::delay(1000);
            adc.cr2().modify(|r, w| w.bits(r.bits() | 1 << 30));
        }
        Self(())
    }

    fn samples<const N: usize>(&self, from: usize) -> [u16; N] {
        let mut samples = [0; N];
        for (to, sample) in samples.iter_mut().zip(SAMPLES.iter().skip(from)) {
            *to = sample.load(Ordering::Relaxed);
        }
        samples
    }
}

/// Up to six channels starting with this one, five bits each.
fn order(from: usize) -> u32 {
    let some = CHANNELS.iter().skip(from).take(6);
    some.zip((0..).step_by(5)).fold(0, |bits, (channel, shift)| bits | channel << shift)
}

/// All of the board's inputs.
pub struct Inputs {
    /// Counters of the encoders: the first of 32 bits, the others of 16.
    pub encoders: (Qei<TIM2>, Qei<TIM3>, Qei<TIM4>),
    /// Counts so far.
    pub counts: [i32; 3],
    /// Voltages.
    pub converters: Converters,
    /// Lower end switches: closed to ground.
    pub low: [AnyPin<Input>; 3],
    /// Upper end switches.
    pub high: [AnyPin<Input>; 3],
    /// Drives' faults: low is a fault.
    pub faults: [AnyPin<Input>; 3],
}

impl Sensors for Inputs {
    fn read(&mut self) -> Readings {
        let [a, b, c] = &mut self.counts;
        *a = self.encoders.0.count().cast_signed();
        // 16-bit counters wrap around; in a millisecond an encoder turns by a few hundred counts at most.
        for (count, now) in [(b, self.encoders.1.count()), (c, self.encoders.2.count())] {
            *count = count.wrapping_add(i32::from(now.wrapping_sub(*count as u16).cast_signed()));
        }
        let [supply] = self.converters.samples(6);
        Readings {
            encoder: self.counts,
            displacement: self.converters.samples(0),
            low_closed: [&self.low[0], &self.low[1], &self.low[2]].map(|pin| pin.is_low()),
            high_closed: [&self.high[0], &self.high[1], &self.high[2]].map(|pin| pin.is_low()),
            pressure: self.converters.samples(7),
            current: self.converters.samples(3),
            supply,
            drive_fault: [&self.faults[0], &self.faults[1], &self.faults[2]].map(|pin| pin.is_low()),
            overrun: false,
        }
    }
}
