//! The chip's CAN controller, bxCAN 1: its clock, pins and registers; the library uses them.

use crate::chip::pins::Wires;
use smartbed_firmware::link::bxcan::{Bxcan, Registers};
use smartbed_firmware::link::can::End;
use stm32f4xx_hal::pac::CAN1;
use stm32f4xx_hal::rcc::{Enable, Rcc, Reset};

/// The node's bus.
pub type Bus = End<Bxcan<Can1>>;

/// Registers of the controller, by exclusive ownership.
pub struct Can1(CAN1);

/// The bus of a tile; its set-up cannot fail.
pub fn start(wires: Wires, rcc: &mut Rcc) -> Option<Bus> {
    let Wires { can, pair: (receive, send), number, .. } = wires;
    (receive.into_alternate::<9>(), send.into_alternate::<9>());
    CAN1::enable(rcc);
    CAN1::reset(rcc);
    Some(End::of_tile(Bxcan::of_tile(Can1(can), number), number))
}

impl Registers for Can1 {
    fn read(&self, register: usize) -> u32 {
        // SAFETY: the library names only registers of this controller, which `self` owns.
        unsafe { CAN1::ptr().cast::<u32>().byte_add(register).read_volatile() }
    }

    fn write(&mut self, register: usize, bits: u32) {
        // SAFETY: as above; the values are the reference manual's.
        unsafe { CAN1::ptr().cast::<u32>().cast_mut().byte_add(register).write_volatile(bits) }
    }
}
