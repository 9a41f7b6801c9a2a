//! Forces between neighbouring sheets, contact and friction alike: a force along D, and springs along directions of D.
//!
//! In: contacts and rubs of a state. Out: the [`Link`]s of a tile, each with the ends of D, the energy's gradient with
//! respect to D, and the directions in which it has a stiffness, numbered alike for both tiles.

use super::bed::Bed;
use super::beside::Meeting;
use super::rub::{Ends, Rub};
use smartbed_runtime::vec3::{Vec3, scale};

/// A force between the sheets of two tiles.
pub struct Link {
    /// Tile, node and weight of each end of D.
    pub ends: Ends,
    /// Gradient with respect to D (N), in the bed's frame.
    pub force: Vec3<f64>,
    /// Springs: number, direction and stiffness (N/m).
    pub ways: Vec<(usize, Vec3<f64>, f64)>,
}

/// The links of a tile that exert a force.
pub fn links(bed: &Bed, sheets: &[Vec<Vec3<f64>>], met: &[Meeting], rubs: &[Rub], tile: usize) -> Vec<Link> {
    let pressed = met.iter().enumerate().filter(|(_, m)| m.is_of(tile)).filter_map(|(index, m)| {
        let force = m.force(bed, sheets);
        let ways = vec![(3 * index, m.normal, m.stiffness)];
        (force > 0.0).then(|| Link { ends: m.ends, force: scale(m.normal, force), ways })
    });
    let rubbed =
        rubs.iter().enumerate().filter(|(_, rub)| rub.is_of(tile) && rub.limit > 0.0).map(|(index, rub)| {
            let numbered = |(k, (direction, stiffness))| (3 * (met.len() + index) + k, direction, stiffness);
            let ways = rub.ways(bed, sheets).into_iter().enumerate().map(numbered);
            let ways = ways.filter(|(.., stiffness)| *stiffness > 0.0).collect();
            Link { ends: rub.ends, force: rub.drag(bed, sheets), ways }
        });
    pressed.chain(rubbed).collect()
}
