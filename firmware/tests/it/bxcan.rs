//! A model of bxCAN's registers, written from the manual (RM0090, 32.7 and 32.9): it panics at a write that the manual
//! forbids, and acts on the bus as its registers are set.

use crate::can_bus::OnBus;
use embedded_can::Frame;
use smartbed_firmware::link::bxcan::{Bxcan, Registers};
use smartbed_firmware::link::can::{Classic, Controller, STOP, frame, raw};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Frames that a receive queue holds.
const DEPTH: usize = 3;
/// Looks until the controller has followed into initialisation.
const LOOKS: u32 = 20;
/// Milliseconds until a controller that has been off is on the bus again: 128 times 11 bits.
const RECOVERY: u32 = 3;

/// The controller's registers and queues.
#[derive(Default)]
pub struct Model {
    mcr: u32,
    btr: u32,
    /// Looks that are left until initialisation is acknowledged, if it was asked for.
    entering: Option<u32>,
    /// Milliseconds until it is on the bus.
    leaving: u32,
    pub is_off: bool,
    pub restarts: u32,
    /// Words of a mailbox, and the number of its request.
    mailboxes: [([u32; 4], Option<u32>); 3],
    requests: u32,
    queues: [VecDeque<[u32; 4]>; 2],
    overrun: [bool; 2],
    fmr: u32,
    lists: u32,
    wide: u32,
    queue_of: u32,
    active: u32,
    banks: [[u32; 2]; 14],
}

/// A handle of the model.
#[derive(Clone)]
pub struct Chip(pub Rc<RefCell<Model>>);

impl Default for Chip {
    /// As after a reset: asleep, filters being set.
    fn default() -> Self {
        let model = Model { mcr: 0x0001_0002, btr: 0x0123_0000, fmr: 0x2A1C_0E01, ..Model::default() };
        Self(Rc::new(RefCell::new(model)))
    }
}

impl Model {
    fn is_initialising(&self) -> bool {
        self.entering == Some(0)
    }

    fn is_on(&self) -> bool {
        self.mcr & 0b11 == 0 && self.leaving == 0 && !self.is_off
    }

    /// The mailbox that is sent next: by request, or by identifier where the master control says so.
    fn next(&self) -> Option<usize> {
        let by_request = self.mcr & 1 << 2 != 0;
        let asked = (0..3).filter(|n| self.mailboxes[*n].1.is_some());
        asked.min_by_key(
            |n| if by_request { self.mailboxes[*n].1 } else { Some(self.mailboxes[*n].0[0] >> 21) },
        )
    }

    /// The queue of a data frame with this identifier.
    fn queue(&self, id: u16) -> Option<usize> {
        let banks = (0..14).filter(|bank| self.active >> bank & 1 == 1);
        let hit = banks.clone().find(|bank| {
            assert!(
                self.wide >> bank & 1 == 0 && self.lists >> bank & 1 == 1,
                "lists of 16 bits alone are modelled"
            );
            let words = self.banks[*bank].into_iter().flat_map(|word| [word & 0xFFFF, word >> 16]);
            words.into_iter().any(|entry| entry == u32::from(id) << 5)
        });
        hit.map(|bank| (self.queue_of >> bank & 1) as usize)
    }

    /// Bits a second from 42 MHz, and where in a bit it is sampled.
    fn timing(&self) -> (u32, f64) {
        let field = |at: u32, bits: u32| (self.btr >> at & ((1 << bits) - 1)) + 1;
        let (prescaler, before, after) = (field(0, 10), 1 + field(16, 4), field(20, 3));
        assert_eq!(self.btr >> 30, 0, "neither silent nor in a loop");
        (42_000_000 / prescaler / (before + after), f64::from(before) / f64::from(before + after))
    }
}

impl Registers for Chip {
    fn read(&self, register: usize) -> u32 {
        let mut model = self.0.borrow_mut();
        match register {
            0x000 => model.mcr,
            0x004 => {
                if let Some(looks) = model.entering.as_mut() {
                    *looks = looks.saturating_sub(1);
                }
                u32::from(model.is_initialising()) | model.mcr & 2
            }
            0x008 => {
                (0..3).filter(|n| model.mailboxes[*n].1.is_none()).fold(0, |bits, n| bits | 1 << (26 + n))
            }
            0x00C | 0x010 => {
                let queue = (register - 0x00C) / 4;
                let count = model.queues[queue].len();
                count as u32 | u32::from(count == DEPTH) << 3 | u32::from(model.overrun[queue]) << 4
            }
            0x018 => u32::from(model.is_off) << 2,
            0x01C => model.btr,
            0x1B0..=0x1CC => {
                let (queue, word) = ((register - 0x1B0) / 0x10, (register - 0x1B0) % 0x10 / 4);
                model.queues[queue].front().expect("no frame is there")[word]
            }
            0x200 => model.fmr,
            _ => panic!("{register:#x} is read"),
        }
    }

    fn write(&mut self, register: usize, bits: u32) {
        let mut model = self.0.borrow_mut();
        let sets_filters = model.fmr & 1 == 1;
        match register {
            0x000 => {
                if bits & 1 == 1 {
                    model.entering = Some(LOOKS);
                } else if model.entering.take().is_some() {
                    model.leaving = if model.is_off { RECOVERY } else { 1 };
                    model.restarts += 1;
                }
                model.mcr = bits;
            }
            // Abort.
            0x008 => {
                (0..3).filter(|n| bits >> (7 + 8 * n) & 1 == 1).for_each(|n| model.mailboxes[n].1 = None)
            }
            0x00C | 0x010 => {
                let queue = (register - 0x00C) / 4;
                model.overrun[queue] &= bits >> 4 & 1 == 0;
                if bits >> 5 & 1 == 1 {
                    model.queues[queue].pop_front();
                }
            }
            0x01C => {
                assert!(model.is_initialising(), "timing is set in initialisation alone");
                model.btr = bits;
            }
            0x180..=0x1AC => {
                let (mailbox, word) = ((register - 0x180) / 0x10, (register - 0x180) % 0x10 / 4);
                assert!(model.mailboxes[mailbox].1.is_none(), "the mailbox waits to be sent");
                model.mailboxes[mailbox].0[word] = bits;
                if word == 0 && bits & 1 == 1 {
                    model.requests += 1;
                    model.mailboxes[mailbox].1 = Some(model.requests);
                }
            }
            0x200 => model.fmr = bits,
            0x204 | 0x20C | 0x214 | 0x21C => {
                assert!(sets_filters, "filters are not being set");
                match register {
                    0x204 => model.lists = bits,
                    0x20C => model.wide = bits,
                    0x214 => model.queue_of = bits,
                    _ => model.active = bits,
                }
            }
            0x240..=0x2AC => {
                let (bank, word) = ((register - 0x240) / 8, (register - 0x240) % 8 / 4);
                assert!(sets_filters || model.active >> bank & 1 == 0, "the filter is active");
                model.banks[bank][word] = bits;
            }
            _ => panic!("{register:#x} is written"),
        }
    }
}

impl OnBus for Chip {
    fn first(&self) -> Option<u16> {
        let model = self.0.borrow();
        let mailbox = model.next().filter(|_| model.is_on())?;
        Some((model.mailboxes[mailbox].0[0] >> 21) as u16)
    }

    fn take(&self) -> Option<Classic> {
        let mut model = self.0.borrow_mut();
        let mailbox = model.next()?;
        model.mailboxes[mailbox].1 = None;
        let [id, length, low, high] = model.mailboxes[mailbox].0;
        let data = (u64::from(high) << 32 | u64::from(low)).to_le_bytes();
        frame((id >> 21) as u16, &data[..(length & 15) as usize])
    }

    fn hear(&self, frame: &Classic) {
        let mut model = self.0.borrow_mut();
        let queue = raw(frame).and_then(|id| model.queue(id));
        let Some(queue) = queue.filter(|_| model.is_on() && model.fmr & 1 == 0) else { return };
        let mut data = [0; 8];
        data[..frame.dlc()].copy_from_slice(frame.data());
        let word = |at: usize| u32::from_le_bytes(data[at..at + 4].try_into().expect("four bytes"));
        let id = u32::from(raw(frame).expect("eleven bits")) << 21;
        let arrived = [id, frame.dlc() as u32, word(0), word(4)];
        if model.queues[queue].len() == DEPTH {
            // The last one is overwritten.
            model.overrun[queue] = true;
            model.queues[queue].pop_back();
        }
        model.queues[queue].push_back(arrived);
    }

    fn pass(&self) {
        let mut model = self.0.borrow_mut();
        if model.leaving == 1 {
            model.is_off = false;
        }
        model.leaving = model.leaving.saturating_sub(1);
    }
}

/// A frame of this identifier with one byte.
fn one(id: u16, byte: u8) -> Classic {
    frame(id, &[byte]).expect("a frame")
}

/// A tile's controller on the bus.
fn ready(number: u8) -> (Chip, Bxcan<Chip>) {
    let chip = Chip::default();
    let controller = Bxcan::of_tile(chip.clone(), number);
    chip.pass();
    (chip, controller)
}

#[test]
fn bits_are_timed_for_half_a_megabit() {
    let (rate, sampled) = ready(3).0.0.borrow().timing();
    assert!(rate == 500_000 && (0.80..0.88).contains(&sampled), "{rate} {sampled}");
}

#[test]
fn the_filters_let_its_commands_and_stops_through_and_stops_go_first() {
    use embedded_can::nb::Can;
    let (chip, mut controller) = ready(3);
    for (n, id) in [0x103, 0x104, 0x203, 0x010, 0x7FF, 0x103].into_iter().enumerate() {
        chip.hear(&one(id, n as u8));
    }
    let come: Vec<_> = std::iter::from_fn(|| controller.receive().ok()).collect();
    assert_eq!(come, [one(STOP, 3), one(0x103, 0), one(0x103, 5)]);
    // More than the queue holds: one error, and the first two are there.
    (0..6).for_each(|n| chip.hear(&one(0x103, n)));
    assert!(matches!(controller.receive(), Err(nb::Error::Other(_))));
    let come: Vec<_> = std::iter::from_fn(|| controller.receive().ok()).collect();
    assert_eq!(come, [one(0x103, 0), one(0x103, 1), one(0x103, 5)]);
}

#[test]
fn frames_go_in_the_order_in_which_they_were_asked_for() {
    use embedded_can::nb::Can;
    let (chip, mut controller) = ready(3);
    let frames = [frame(0x203, &[1, 2, 3, 4, 5, 6, 7, 8]).expect("a frame"), one(0x103, 9), one(0x203, 7)];
    for frame in &frames {
        assert!(matches!(controller.transmit(frame), Ok(None)));
    }
    assert!(matches!(controller.transmit(&frames[0]), Err(nb::Error::WouldBlock)), "three mailboxes");
    assert_eq!([(); 3].map(|()| chip.take().expect("a frame")), frames);
    // Off the bus nothing goes; back on it what waited has been given up.
    assert!(matches!(controller.transmit(&frames[0]), Ok(None)));
    chip.0.borrow_mut().is_off = true;
    assert!(controller.is_off() && chip.first().is_none());
    controller.restart();
    (0..RECOVERY).for_each(|_| chip.pass());
    assert!(!controller.is_off() && chip.first().is_none());
    assert!(matches!(controller.transmit(&frames[1]), Ok(None)));
    assert_eq!(chip.first(), Some(0x103));
}
