//! Controller and simulated tile, a tick at a time, for a host that takes [`turns`](crate::turns).
//!
//! In: the host's bytes. Out: ours. The same code on host and chip, so the same bytes.
//! [`controller_tick`] is a symbol of the image, so that the emulator can count it: line, node and nothing of the plant.

use crate::link::serial::{BYTES, Line, Serial};
use crate::node::Node;
use crate::plant::flash::{Flash, provided};
use crate::plant::{Defect, Tile};
use crate::tile::board::{Outputs, Readings, Sensors};
use crate::tile::drive::DRIVE;
use crate::turns::{BREAK, END, FAULT, HELLO, TICKS};
use heapless::{Deque, Vec};

/// Where the simulated tile stands when it starts (m), and what lies on it (kg, m).
const START: ([f32; 3], f32, [f32; 2]) = ([-0.02; 3], 20.0, [0.02, 0.0]);
/// The key of every simulated tile; a real one gets its own from its maker.
pub const KEY: [u8; 16] = *b"an example's key";

/// The host's end.
pub trait Host {
    /// The next byte; waits for it. None if there is no host any more.
    fn read(&mut self) -> Option<u8>;
    /// Sends a byte.
    fn write(&mut self, byte: u8);
}

/// How a session ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Last {
    /// The host has ended it, or is gone.
    End,
    /// The host asks for an undefined instruction.
    Fault,
    /// The simulated tile refused a step.
    Refused,
}

/// What runs on a board: line and node.
#[derive(Clone, Debug)]
pub struct Controls {
    node: Node<Flash>,
    serial: Serial,
    ends: Ends,
}

/// The line between the turns and the node.
#[derive(Clone, Debug, Default)]
struct Ends {
    down: Deque<u8, 256>,
    up: Vec<u8, BYTES>,
}

impl Line for Ends {
    fn read(&mut self) -> Option<u8> {
        self.down.pop_front()
    }
    fn write(&mut self, byte: u8) -> bool {
        self.up.push(byte).is_ok()
    }
}

/// One tick of line and node.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn controller_tick(controls: &mut Controls, readings: &Readings) -> Outputs {
    let Controls { node, serial, ends } = controls;
    serial.receive(ends, |body| {
        node.deliver(body);
    });
    let losses = serial.losses();
    node.count_lost(losses.cut.saturating_add(losses.long).saturating_add(losses.corrupt));
    let outputs = *node.tick(readings);
    serial.transmit(ends, || node.collect());
    outputs
}

/// Takes turns until the host ends it.
pub fn serve(host: &mut impl Host) -> Last {
    host.write(HELLO);
    let Some(number) = host.read() else { return Last::End };
    let margin = DRIVE.with_friction(true).locking_margin() * 1000.0;
    (margin as u16).to_le_bytes().into_iter().for_each(|byte| host.write(byte));
    let (heights, mass, offset) = START;
    let Ok(mut tile) = Tile::loaded(mass, offset, heights, DRIVE) else { return Last::Refused };
    let node = Node::new(number, provided(KEY), 0);
    let mut controls = Controls { node, serial: Serial::default(), ends: Ends::default() };
    loop {
        let ticks = match host.read() {
            None | Some(END) => return Last::End,
            Some(FAULT) => return Last::Fault,
            Some(BREAK) => {
                tile.set_defect(host.read().and_then(defect));
                0
            }
            Some(turn @ 0..=TICKS) => {
                for _ in 0..turn {
                    let Some(byte) = host.read() else { return Last::End };
                    // A line that is never read loses what comes.
                    let _ = controls.ends.down.push_back(byte);
                }
                1
            }
            Some(turn) => turn - TICKS,
        };
        for _ in 0..ticks {
            let outputs = controller_tick(&mut controls, &tile.read());
            if tile.advance(&outputs).is_err() {
                return Last::Refused;
            }
            host.write(controls.ends.up.len() as u8);
            controls.ends.up.iter().for_each(|byte| host.write(*byte));
            controls.ends.up.clear();
        }
    }
}

/// The defect of this number: see `turns::DEFECTS`.
fn defect(number: u8) -> Option<Defect> {
    Some(match number {
        1 => Defect::Motor(0, 1.0),
        2 => Defect::MotorDead(1),
        3 => Defect::Enable,
        4 => Defect::ValveOpen { vent: false },
        5 => Defect::ValveOpen { vent: true },
        6 => Defect::ValveShut { vent: false },
        7 => Defect::ValveShut { vent: true },
        8 => Defect::EncoderStuck(1),
        9 => Defect::EncoderDrift(2, 5),
        10 => Defect::DisplacementStuck(0),
        11 => Defect::DisplacementOpen(0),
        12 => Defect::SwitchOpen { leg: 2, high: true },
        13 => Defect::PressureBias(0, 1.2),
        14 => Defect::Block { leg: 1, height: 0.0, above: true },
        _ => return None,
    })
}
