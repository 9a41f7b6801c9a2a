//! The part of the program that every board runs once per millisecond: bus and node.
//!
//! In: readings. Out: outputs for the board. Boards differ only in their [`Bus`] and their flash.

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
    /// A node on a bus; `program` is checked against the checksum that was built in.
    pub fn new(node: Node<F>, bus: B, program: Program, checksum: u32) -> Self {
        Self { node, integrity: Integrity::new(program, checksum), bus }
    }

    /// The node.
    #[must_use]
    pub fn node(&self) -> &Node<F> {
        &self.node
    }

    /// Receives, does a tick, and transmits; checks a slice of `program`.
    // Not inlined, so that its jump tables stay short enough for the image's checks to follow.
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
