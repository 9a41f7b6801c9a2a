//! An equilibrium and the quantities derived from it: contact forces, pressures, and the friction that may act from
//! there on.

use super::bed::{Bed, GRAVITY};
use super::beside::{self, Meeting};
use super::scene::Scene;
use super::state::State;
use super::tile::Patch;
use super::touch::{Anchor, Touch};
use crate::sheet::membrane;
use smartbed_runtime::vec3::{Vec3, norm};

/// A node in contact with tissue, in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Depth and normal of the contact.
    pub touch: Touch,
    /// Area of the stretched sheet that belongs to the node (m^2).
    pub area: f64,
    /// Position of the node in the bed (m).
    pub place: Vec3<f64>,
    /// Friction force on the tissue (N).
    pub drag: Vec3<f64>,
}

/// An equilibrium.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Positions.
    pub state: State,
    /// Contacts of nodes with tissue, by tile.
    pub contacts: Vec<Vec<Contact>>,
    /// Contacts between neighbouring sheets.
    pub met: Vec<Meeting>,
    /// Gauge pressures (Pa), by tile.
    pub gauges: Vec<f64>,
    /// Number of nodes on the plate, by tile.
    pub bottomed: Vec<usize>,
    /// Number of Newton steps.
    pub steps: usize,
    /// Force that contacts must carry (N): the weight of all free segments, in motion sum m (a - g).
    pub carried: f64,
    /// Difference between the contact forces on those segments and that, relative to the weight.
    pub imbalance: f64,
}

impl Contact {
    /// Pressure (Pa).
    #[must_use]
    pub fn pressure(&self) -> f64 {
        self.touch.force() / self.area
    }

    /// Force on the tissue (N).
    #[must_use]
    pub fn force(&self) -> Vec3<f64> {
        let n = self.touch.force();
        [0, 1, 2].map(|i| self.drag[i] - n * self.touch.normal[i])
    }
}

/// The solution at a state as it is, without a search.
pub fn read(scene: &Scene, state: State) -> Solution {
    finish(scene, state, 0)
}

/// The solution at a state of equilibrium, with friction anchored there.
pub(super) fn finish(scene: &Scene, mut state: State, steps: usize) -> Solution {
    let (bed, body) = (scene.bed, scene.body);
    let (mut contacts, mut gauges, mut bottomed) = (Vec::new(), Vec::new(), Vec::new());
    for tile in 0..bed.tiles.len() {
        let patch = Patch::new(scene, &state, tile);
        bottomed.push(patch.bottomed());
        gauges.push(bed.tiles[tile].air.gauge(bed.volume(&state.sheets[tile])).unwrap_or(0.0));
        let areas = membrane::areas(&bed.lattice, &state.sheets[tile]);
        let one = |(touch, place): (Touch, Vec3<f64>)| {
            let anchor = state.anchors[tile][touch.node].as_ref().filter(|a| a.segment == touch.segment);
            let drag = anchor.map_or([0.0; 3], |a| a.drag(place, &state.segments[touch.segment]));
            Contact { touch, area: norm(areas[touch.node]), place, drag }
        };
        let mut found: Vec<Contact> = patch.touches().into_iter().map(one).collect();
        // In motion friction may hold a node until the end of the stage in which contact was lost.
        found.extend(patch.held_off().map(|(touch, place, drag)| Contact {
            touch,
            area: norm(areas[touch.node]),
            place,
            drag,
        }));
        contacts.push(found);
    }
    let is_free = |segment: usize| body.segments[segment].free[2];
    let up: f64 = contacts.iter().flatten().filter(|c| is_free(c.touch.segment)).map(|c| c.force()[2]).sum();
    let weight: f64 = body.segments.iter().filter(|s| s.free[2]).map(|s| s.mass * GRAVITY).sum();
    let carried = weight;
    let imbalance = if weight > 0.0 { (up - weight).abs() / weight } else { 0.0 };
    for (own, contacts) in state.anchors.iter_mut().zip(&contacts) {
        *own = anchors(bed, contacts, &state.segments);
    }
    state.rubs = if bed.rubbing > 0.0 { beside::anchored(bed, &state, scene.met) } else { Vec::new() };
    let met = scene.met.to_vec();
    Solution { state, contacts, met, gauges, bottomed, steps, carried, imbalance }
}

/// Friction anchors by node; a node in two segments belongs to the one in which it is deeper.
fn anchors(bed: &Bed, contacts: &[Contact], poses: &[crate::pose::Pose]) -> Vec<Option<Anchor>> {
    let mut anchors: Vec<Option<Anchor>> = vec![None; bed.lattice.nodes()];
    if bed.friction > 0.0 {
        for Contact { touch, place, drag, .. } in contacts.iter().filter(|c| c.touch.force() > 0.0) {
            let anchor = touch.anchor(*place, &poses[touch.segment], *drag, bed.friction);
            let own = &mut anchors[touch.node];
            if own.as_ref().is_none_or(|a| a.limit < anchor.limit) {
                *own = Some(anchor);
            }
        }
    }
    anchors
}
