//! The serial line: DMA moves bytes both ways, so no byte is lost while a tick computes.

use crate::chip::pins::Wires;
use core::sync::atomic::{AtomicU8, Ordering};
use smartbed_firmware::link::serial::{Line, Serial};
use stm32f4xx_hal::gpio::{PB6, PB7};
use stm32f4xx_hal::pac::{DMA2, USART1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Rcc;
use stm32f4xx_hal::serial::config::{Config, DmaConfig};

/// The node's bus.
pub type Bus = Serial<Uart>;

/// Ring of received bytes: 22 ms of a full line.
static RECEIVED: [AtomicU8; 256] = [const { AtomicU8::new(0) }; 256];
/// Bytes being sent.
static SENT: [AtomicU8; 128] = [const { AtomicU8::new(0) }; 128];
/// Streams of DMA 2 that USART 1 uses, and their channel (RM0090, table 43).
const RECEIVE: usize = 2;
const SEND: usize = 7;
const CHANNEL: u32 = 4 << 25;
/// Bits of a stream's control register: memory increment, circular, from memory, enable.
const ADVANCE: u32 = 1 << 10;
const ROUND: u32 = 1 << 8;
const FROM_MEMORY: u32 = 1 << 6;
const ON: u32 = 1;

/// USART 1 with its two streams.
pub struct Uart {
    dma: DMA2,
    /// Number of bytes read, modulo the ring's length.
    read: u8,
    /// Number of bytes waiting for [`Line::flush`].
    filled: usize,
}

/// The line with its two streams.
pub fn start(wires: Wires, rcc: &mut Rcc) -> Option<Bus> {
    Uart::start(wires.usart, wires.serial, wires.dma, rcc).map(Serial::new)
}

impl Uart {
    /// 115,200 baud; None if that cannot be set.
    fn start(usart: USART1, pins: (PB6, PB7), dma: DMA2, rcc: &mut Rcc) -> Option<Self> {
        let data = usart.dr().as_ptr().addr() as u32;
        let config = Config::default().baudrate(115_200.bps()).dma(DmaConfig::TxRx);
        let _line = usart.serial::<u8>(pins, config, rcc).ok()?;
        let (receive, send) = (dma.st(RECEIVE), dma.st(SEND));
        // SAFETY: values of the reference manual; addresses and lengths are those of two statics.
        unsafe {
            receive.par().write(|w| w.bits(data));
            receive.m0ar().write(|w| w.bits(RECEIVED.as_ptr().addr() as u32));
            receive.ndtr().write(|w| w.bits(RECEIVED.len() as u32));
            receive.cr().write(|w| w.bits(CHANNEL | ADVANCE | ROUND | ON));
            send.par().write(|w| w.bits(data));
            send.m0ar().write(|w| w.bits(SENT.as_ptr().addr() as u32));
        }
        Some(Self { dma, read: 0, filled: 0 })
    }

    fn is_sending(&self) -> bool {
        self.dma.st(SEND).cr().read().bits() & ON != 0
    }
}

impl Line for Uart {
    fn read(&mut self) -> Option<u8> {
        // The stream counts down the bytes left of the ring.
        let left = self.dma.st(RECEIVE).ndtr().read().bits();
        let written = 0_u8.wrapping_sub(left as u8);
        if self.read == written {
            return None;
        }
        let byte = RECEIVED.get(usize::from(self.read))?.load(Ordering::Relaxed);
        self.read = self.read.wrapping_add(1);
        Some(byte)
    }

    fn write(&mut self, byte: u8) -> bool {
        if self.is_sending() {
            return false;
        }
        let Some(place) = SENT.get(self.filled) else { return false };
        place.store(byte, Ordering::Relaxed);
        self.filled += 1;
        true
    }

    /// Sends the bytes written since the last call.
    fn flush(&mut self) {
        if self.filled == 0 || self.is_sending() {
            return;
        }
        let send = self.dma.st(SEND);
        // SAFETY: as above; flags of the last transfer are cleared before the next.
        unsafe {
            self.dma.hifcr().write(|w| w.bits(0x0F40_0000));
            send.ndtr().write(|w| w.bits(self.filled as u32));
            send.cr().write(|w| w.bits(CHANNEL | ADVANCE | FROM_MEMORY | ON));
        }
        self.filled = 0;
    }
}
