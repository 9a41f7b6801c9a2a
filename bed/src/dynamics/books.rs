//! Energy accounting of a motion: present energies, dissipated energy, and the work of drives and regulators.
//!
//! In: a motion at the end of a stage. Out: its [`Ledger`](super::ledger::Ledger).

use super::ledger::Ledger;
use super::motion::{Motion, spin};
use crate::equilibrium::{Anchor, Bed, GRAVITY, Meeting, Rub, Solution, State};
use crate::method::{Formula, Track};
use crate::sheet::membrane;
use smartbed_runtime::vec3::{Vec3, add, dot, norm, scale, sub, tangential};

impl Motion {
    /// Computes the present energies.
    pub(super) fn weigh(&mut self) {
        let (lattice, state) = (&self.bed.lattice, &self.now.state);
        let of_node = 0.5 * self.node_mass();
        let mut ledger = Ledger { kinetic: 0.0, sheets: 0.0, air: 0.0, tissue: 0.0, ..self.ledger };
        for (tile, sheet) in state.sheets.iter().enumerate() {
            let free = self.nodes[tile].iter().enumerate().filter(|(node, _)| lattice.free(*node).is_some());
            ledger.kinetic += free.map(|(_, t)| of_node * dot(t.velocity, t.velocity)).sum::<f64>();
            ledger.sheets += membrane::energy(lattice, sheet) + self.bed.plate_energy(sheet);
            ledger.sheets += self.bed.cover_energy(&self.bed.tiles[tile], sheet);
            // A bladder without air has already ended the step with an error.
            ledger.air += self.bed.tiles[tile].air.energy(self.bed.volume(sheet)).unwrap_or(f64::NAN);
            ledger.tissue += state.anchors[tile].iter().flatten().map(Anchor::held).sum::<f64>();
            let pressed = self.layers[tile].iter();
            ledger.tissue +=
                pressed.map(|((_, s), layer)| self.layer(*s) * self.matter.tissue.energy(layer)).sum::<f64>();
        }
        ledger.sheets += state.rubs.iter().map(Rub::held).sum::<f64>();
        ledger.sheets += self.now.met.iter().map(|m| m.energy(&self.bed, &state.sheets)).sum::<f64>();
        for (segment, tracks) in self.body.segments.iter().zip(&self.segments) {
            ledger.kinetic +=
                tracks.iter().map(|t| segment.mass / 12.0 * dot(t.velocity, t.velocity)).sum::<f64>();
        }
        ledger.body = self.body.energy(&state.segments, GRAVITY);
        self.ledger = ledger;
    }

    /// Stiffness of a node's layer in a segment (N/m).
    fn layer(&self, segment: usize) -> f64 {
        self.body.segments[segment].foundation * self.bed.lattice.cell()
    }

    /// Energy (J) dissipated by the sheets' dampers in a stage, from their `pulls` at its end: mean power times time.
    /// Next to the rim, whose motion is prescribed and whose velocity may jump, mean force times change of length.
    pub(super) fn damped(&self, formula: &Formula, pulls: &[[f64; 3]]) -> f64 {
        let [before, after] = formula.means();
        let lattice = &self.bed.lattice;
        let is_led =
            |spring: &crate::sheet::Spring| spring.ends.iter().any(|end| lattice.free(*end).is_none());
        let springs = lattice.springs.iter().cycle();
        let one = |((old, new), spring): ((&[f64; 3], &[f64; 3]), &crate::sheet::Spring)| {
            if is_led(spring) {
                (before * old[2] + after * new[2]) * (new[0] - old[0])
            } else {
                formula.seconds * (before * old[1] * old[2] + after * new[1] * new[2])
            }
        };
        self.pulls.iter().zip(pulls).zip(springs).map(one).sum()
    }

    /// Energy (J) dissipated where a rim starts suddenly: dampers give the nodes beside it its velocity within
    /// microseconds, so that of the drives' work m v^2 only half becomes kinetic energy.
    pub(super) fn snatched(&self, formula: &Formula) -> f64 {
        if !formula.is_anew {
            return 0.0;
        }
        let lost = 0.5 * self.node_mass() * (1.0 - self.lasting(formula.seconds));
        let free = |tracks: &Vec<Track>| -> f64 {
            let own = tracks.iter().enumerate().filter(|(node, _)| self.bed.lattice.free(*node).is_some());
            own.map(|(_, t)| dot(t.change[1], t.change[1])).sum()
        };
        lost * self.nodes.iter().map(free).sum::<f64>()
    }

    /// For each spring of all sheets at present: length (m), its rate (m/s), and the damper's force (N).
    pub(super) fn pulls(&self) -> Vec<[f64; 3]> {
        let one = |(tracks, spring): (&Vec<Track>, &crate::sheet::Spring)| {
            let [a, b] = spring.ends.map(|end| &tracks[end]);
            let along = sub(b.place, a.place);
            let length = norm(along);
            let speed = dot(along, sub(b.velocity, a.velocity)) / length;
            [length, speed, self.matter.sheet_loss * spring.stiffness * speed]
        };
        let all =
            self.nodes.iter().flat_map(|tracks| self.bed.lattice.springs.iter().map(move |s| (tracks, s)));
        all.map(one).collect()
    }

    pub(super) fn power_of_tissue(&self) -> f64 {
        let layers = self.layers.iter().flatten();
        layers.map(|((_, segment), layer)| self.layer(*segment) * self.matter.tissue.power(layer)).sum()
    }

    pub(super) fn power_of_joints(&self) -> f64 {
        let spin = |s: usize| spin(&self.segments[s]);
        let one = |joint: &crate::body::Joint| {
            let [a, b] = joint.segments.map(spin);
            let relative = sub(b, a);
            self.matter.joint_loss * joint.turning * dot(relative, relative)
        };
        self.body.joints.iter().map(one).sum()
    }

    /// Work (J) of moving a tile from its present pose to that in `bed` against the forces of one state. The rim
    /// carries what the contacts leave of the nodes' inertia; `drag` gives the friction between sheets in that state.
    pub(super) fn moved(
        &self,
        tile: usize,
        bed: &Bed,
        (then, solution): (&Bed, &Solution),
        drag: impl Fn(&Rub) -> Vec3<f64>,
    ) -> f64 {
        let [old, new] = [&self.bed, bed].map(|bed| &bed.tiles[tile]);
        if old.pose == new.pose {
            return 0.0;
        }
        let way = |x: Vec3<f64>| sub(new.pose.outwards(x), old.pose.outwards(x));
        let (sheets, sheet) = (&solution.state.sheets, &solution.state.sheets[tile]);
        let inertia = self.nodes[tile].iter().zip(sheet).enumerate();
        let inertia = inertia.filter(|(node, _)| bed.lattice.free(*node).is_some());
        let inertia: f64 = inertia.map(|(_, (t, x))| self.node_mass() * dot(t.acceleration, way(*x))).sum();
        let pushed = solution.met.iter().map(|m| (&m.ends, scale(m.normal, m.force(then, sheets))));
        let rubbed = self.now.state.rubs.iter().map(|rub| (&rub.ends, drag(rub)));
        let met = pushed.chain(rubbed).map(|(ends, force)| {
            let own = ends.iter().filter(|end| end.0 == tile);
            own.map(|(_, node, share)| share * dot(force, way(sheet[*node]))).sum::<f64>()
        });
        let pressed = solution.contacts[tile].iter().map(|c| dot(c.force(), way(sheet[c.touch.node])));
        let lifted = bed.cover_energy(new, sheet) - bed.cover_energy(old, sheet);
        lifted + inertia + met.sum::<f64>() + pressed.sum::<f64>()
    }

    /// Energy (J) dissipated by slip in a stage: work of friction by the trapezoidal rule, less the increase stored in
    /// its springs.
    pub(super) fn slipped(&self, next: &Solution, bed: &Bed) -> f64 {
        let before = &self.now.state;
        let mut lost: f64 = before.rubs.iter().map(|rub| rub.taken(bed, &next.state.sheets)).sum();
        lost -= next.state.rubs.iter().map(Rub::held).sum::<f64>();
        for (tile, old) in before.anchors.iter().enumerate() {
            for (node, anchor) in old.iter().enumerate() {
                let Some(anchor) = anchor else { continue };
                let pose = &next.state.segments[anchor.segment];
                let own = next.contacts[tile]
                    .iter()
                    .find(|c| c.touch.node == node && c.touch.segment == anchor.segment);
                lost += anchor.held();
                if let Some(contact) = own {
                    let normal = pose.attitude.to_body(contact.touch.normal);
                    let slid = tangential(sub(pose.inwards(contact.place), anchor.place), normal);
                    let drag = pose.attitude.to_body(contact.drag);
                    lost += 0.5 * dot(add(anchor.force, drag), slid);
                }
            }
            lost -= next.state.anchors[tile].iter().flatten().map(Anchor::held).sum::<f64>();
        }
        lost
    }

    /// Energy (J) gained when contacts between neighbouring sheets are found anew in a stage, as the mean of both
    /// states: their feet and normals move along the facets, so that the force is not exactly the derivative of the
    /// energy.
    pub(super) fn turned(&self, next: &Solution, bed: &Bed) -> f64 {
        let gain = |bed: &Bed, state: &State| {
            let of = |met: &[Meeting]| met.iter().map(|m| m.energy(bed, &state.sheets)).sum::<f64>();
            of(&next.met) - of(&self.now.met)
        };
        0.5 * (gain(&self.bed, &self.now.state) + gain(bed, &next.state))
    }

    /// Energy (J) that regulators supply in a stage by changing pressures, at the mean of both volumes.
    pub(super) fn regulated(&self, new: &Bed, after: &State) -> f64 {
        let (old, before) = (&self.bed, &self.now.state);
        let mut given = 0.0;
        for (tile, (a, b)) in old.tiles.iter().zip(&new.tiles).enumerate() {
            if a.air != b.air {
                for state in [before, after] {
                    let volume = old.volume(&state.sheets[tile]);
                    let energy = |air: &crate::sheet::air::Air| air.energy(volume).unwrap_or(f64::NAN);
                    given += 0.5 * (energy(&b.air) - energy(&a.air));
                }
            }
        }
        given
    }
}
