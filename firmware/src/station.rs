//! What runs on every board, once a millisecond: bus and node.
//!
//! In: readings. Out: what is to be set. Boards differ in their [`Bus`] and their flash alone.

use crate::link::bus::{Arrival, Bus};
use crate::node::Node;
use crate::tile::board::{Outputs, Readings};
use crate::tile::integrity::{Integrity, Program};
use embedded_storage::nor_flash::NorFlash;

/// A node on its bus.
#[derive(Clone, Debug)]
pub struct Station<F, B> {
    node: Node<F>,
    integrity: Integrity,
    /// The bus.
    pub bus: B,
}

impl<F: NorFlash, B: Bus> Station<F, B> {
    /// This node on this bus; `program` is checked against the checksum that it was built with.
    pub fn new(node: Node<F>, bus: B, program: Program, checksum: u32) -> Self {
        Self { node, integrity: Integrity::new(program, checksum), bus }
    }

    /// The node.
    #[must_use]
    pub fn node(&self) -> &Node<F> {
        &self.node
    }

    /// Takes what has come, does a tick, and sends what is to be sent; `program` is checked on the way.
    // A function of its own: its tables of jumps stay short enough for the checks of an image to follow.
    #[inline(never)]
    pub fn tick(&mut self, readings: &Readings, program: Program) -> Outputs {
        let Self { node, integrity, bus } = self;
        if !integrity.take(program) {
            node.report_damage();
        }
        let now = node.now();
        bus.receive(now, |arrival| match arrival {
            Arrival::Body(body) => {
                node.deliver(body);
            }
            Arrival::Stop => node.halt(),
        });
        node.count_lost(bus.lost());
        let outputs = *node.tick(readings);
        bus.transmit(now, || node.collect());
        outputs
    }
}
