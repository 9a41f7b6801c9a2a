//! Facets of bladders that a port holds: they turn as a whole, so that no step sums over them.
//!
//! In: the lists of a world with all its attachments. Out: the [`Wall`] of each cell whose last facets one port holds,
//! and what gas pushes the corners with, in the port's frame.

use smartbed_runtime::flexible::pressure::{corner_shares, corners, enclosed_volume};
use smartbed_runtime::vec3;
use smartbed_runtime::world::Wall;

use super::{CarriedWorld, Fixed};

impl CarriedWorld<f64> {
    /// Finds the walls of all cells.
    pub(super) fn find_walls(&mut self) {
        let fixed = &mut self.fixed;
        // By node: the attachment that holds it.
        let mut holds = vec![None; fixed.mass.len()];
        for (number, held) in fixed.attachments.iter().enumerate() {
            holds[held.node] = Some(number);
        }
        for cell in 0..fixed.cells.len() {
            fixed.cells[cell].wall = fixed.wall(cell, &holds);
        }
    }
}

impl Fixed<f64> {
    /// The wall of a cell, if it has one; gives its corners their pushes.
    fn wall(&mut self, cell: usize, holds: &[Option<usize>]) -> Option<Wall<f64>> {
        let ([first, end], form) = (self.cells[cell].facets, self.cells[cell].form);
        let port = |node: usize| holds[node].map(|number| self.attachments[number].port);
        let port = port(self.facets[first..end].last()?[0])?;
        let attachment = |node: usize| holds[node].filter(|held| self.attachments[*held].port == port);
        let is_held = |facet: &&[usize; 4]| facet.iter().all(|node| attachment(*node).is_some());
        let in_grids = self.grids.iter().map(|grid| grid.view().facets[1]).filter(|last| *last <= end);
        let loose = in_grids.fold(first, usize::max);
        let first = end - self.facets[loose..end].iter().rev().take_while(is_held).count();

        let places: Vec<_> = (0..holds.len())
            .map(|node| attachment(node).map_or(vec3::zero(), |held| self.attachments[held].place))
            .collect();
        let facets = &self.facets[first..end];
        let held: Vec<[usize; 4]> =
            facets.iter().map(|facet| facet.map(|node| attachment(node).unwrap_or(0))).collect();
        let (volume, mut area) = (enclosed_volume(facets, &places), vec3::zero());
        let attachments = [*held.as_flattened().iter().min()?, *held.as_flattened().iter().max()? + 1];
        for (facet, held) in facets.iter().zip(&held) {
            for (number, share) in held.iter().zip(corner_shares(form, corners(&places, facet))) {
                let push = &mut self.attachments[*number].push;
                *push = vec3::add(*push, share);
                area = vec3::add(area, share);
            }
        }
        Some(Wall { first, port, attachments, volume, area })
    }
}
