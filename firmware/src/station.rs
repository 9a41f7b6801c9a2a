//! What runs on every board, once a millisecond: serial line and node.
//!
//! In: readings. Out: what is to be set. Boards differ in their [`Line`] and their flash alone.

use crate::link::serial::{Line, Serial};
use crate::node::Node;
use crate::tile::board::{Outputs, Readings};
use crate::tile::integrity::Integrity;
use embedded_storage::nor_flash::NorFlash;

/// A node on its line.
#[derive(Clone, Debug)]
pub struct Station<F, L> {
    node: Node<F>,
    serial: Serial,
    integrity: Integrity,
    /// The line.
    pub line: L,
}

impl<F: NorFlash, L: Line> Station<F, L> {
    /// This node on this line.
    pub fn new(node: Node<F>, line: L) -> Self {
        Self { node, serial: Serial::default(), integrity: Integrity::default(), line }
    }

    /// The node.
    #[must_use]
    pub fn node(&self) -> &Node<F> {
        &self.node
    }

    /// Takes what has come, does a tick, and sends what is to be sent; `program` is checked on the way.
    // A function of its own: its tables of jumps stay short enough for the checks of an image to follow.
    #[inline(never)]
    pub fn tick(&mut self, readings: &Readings, program: &[u8]) -> Outputs {
        let Self { node, serial, integrity, line } = self;
        if !integrity.take(program) {
            node.report_damage();
        }
        serial.receive(line, |body| {
            node.deliver(body);
        });
        let losses = serial.losses();
        node.count_lost(losses.cut.saturating_add(losses.long).saturating_add(losses.corrupt));
        let outputs = *node.tick(readings);
        serial.transmit(line, || node.collect());
        outputs
    }
}
