//! The contributions of one tile: its energy, and its sheet eliminated from the Newton step.
//!
//! In: a tile, its sheet and the segments near it. Out: energy; gradient and Hessian with the nodes' rows solved by the
//! sheet's [`Stiffness`], including the columns B that couple nodes to segments.

use super::bed::{Bed, Tile};
use super::beside::Meeting;
use super::increment::Increment;
use super::link::{Link, links};
use super::lone::Lone;
use super::rub::Rub;
use super::scene::Scene;
use super::state::State;
use super::stiffness::Stiffness;
use super::touch::{self, Pull, Touch};
use crate::body::{Body, lever};
use crate::pose::Pose;
use crate::sheet::air::Collapsed;
use crate::sheet::membrane;
use crate::tissue::Line;
use smartbed_runtime::vec3::{Vec3, add, dot, scale, sub};

/// A tile with its sheet and the segments near it.
#[derive(Clone, Copy)]
pub struct Patch<'a> {
    bed: &'a Bed,
    body: &'a Body,
    index: usize,
    increment: Option<&'a Increment<'a>>,
    tile: &'a Tile,
    sheet: &'a [Vec3<f64>],
    anchors: &'a [Option<touch::Anchor>],
    poses: &'a [Pose],
    sheets: &'a [Vec<Vec3<f64>>],
    met: &'a [Meeting],
    rubs: &'a [Rub],
    /// True: exact Hessians, as needed for stiffnesses. False: without terms that may make them indefinite.
    is_exact: bool,
}

/// A contact or friction force between a node and a segment.
pub struct Bond {
    pub node: usize,
    pub segment: usize,
    /// From the segment's origin to the node.
    pub arm: Vec3<f64>,
    pub pull: Pull,
}

/// Coupling of the sheet to one segment.
pub struct Coupling {
    pub segment: usize,
    /// B: six entries per row, for displacement and rotation.
    pub columns: Vec<[f64; 6]>,
    /// (K + c g g')^-1 B.
    pub solved: Vec<[f64; 6]>,
}

/// A spring between this sheet and a neighbouring one.
pub struct Crossing {
    /// Its number among those of all links.
    pub number: usize,
    /// Stiffness (N/m).
    pub stiffness: f64,
    /// W: derivative of its length with respect to the free nodes, with their indices.
    column: Vec<(usize, Vec3<f64>)>,
    /// (K + c g g')^-1 W.
    pub solved: Vec<f64>,
}

impl Crossing {
    /// W' times a vector over the nodes.
    pub fn along(&self, x: &[f64]) -> f64 {
        self.column.iter().map(|(free, w)| dot(*w, [x[3 * free], x[3 * free + 1], x[3 * free + 2]])).sum()
    }
}

/// The contributions of a tile to the segments' rows, and the data to find its nodes' step afterwards.
pub struct Eliminated {
    /// (K + c g g')^-1 times the nodes' gradient.
    pub solved: Vec<f64>,
    /// Gradient with respect to the nodes.
    pub gradient: Vec<f64>,
    /// Couplings to the segments in contact.
    pub couplings: Vec<Coupling>,
    /// Forces on segments.
    pub bonds: Vec<Bond>,
    /// Springs to neighbouring sheets.
    pub crossings: Vec<Crossing>,
}

impl<'a> Patch<'a> {
    pub fn new(scene: &Scene<'a>, state: &'a State, index: usize) -> Patch<'a> {
        Patch {
            bed: scene.bed,
            body: scene.body,
            index,
            increment: scene.increment,
            tile: &scene.bed.tiles[index],
            sheet: &state.sheets[index],
            anchors: &state.anchors[index],
            poses: &state.segments,
            sheets: &state.sheets,
            met: scene.met,
            rubs: &state.rubs,
            is_exact: false,
        }
    }

    /// The same patch with exact Hessians.
    pub fn exact(self) -> Patch<'a> {
        Patch { is_exact: true, ..self }
    }

    /// Can no segment reach the sheet, and does friction hold nothing?
    pub fn is_alone(&self) -> bool {
        let is_free = self.anchors.iter().all(Option::is_none);
        is_free && touch::near(self.bed, self.body, &self.tile.pose, self.poses).is_empty()
    }

    /// All contacts of nodes with tissue, with the nodes' positions in the bed.
    pub fn touches(&self) -> Vec<(Touch, Vec3<f64>)> {
        let near = touch::near(self.bed, self.body, &self.tile.pose, self.poses);
        let mut found = Vec::new();
        for (node, x) in self.sheet.iter().enumerate() {
            if near.is_empty() || self.bed.lattice.free(node).is_none() {
                continue;
            }
            let place = self.tile.pose.outwards(*x);
            for segment in &near {
                let pose = &self.poses[*segment];
                let line = || self.line(node, *segment);
                let touch = touch::touch(self.bed, self.body, node, place, *segment, pose, line);
                found.extend(touch.map(|t| (t, place)));
            }
        }
        found
    }

    /// Friction that still holds nodes without contact: touches without force, positions and friction forces.
    pub fn held_off(&self) -> impl Iterator<Item = (Touch, Vec3<f64>, Vec3<f64>)> {
        let touches = self.touches();
        let one = move |(node, anchor): (usize, &touch::Anchor)| {
            let place = self.tile.pose.outwards(self.sheet[node]);
            let pose = &self.poses[anchor.segment];
            let drag = anchor.drag(place, pose);
            let is_touching = touches.iter().any(|(t, _)| t.node == node && t.segment == anchor.segment);
            (!is_touching && drag != [0.0; 3]).then(|| (anchor.without_touch(node, pose), place, drag))
        };
        let anchors = self.anchors.iter().enumerate().filter_map(|(node, a)| Some((node, a.as_ref()?)));
        anchors.filter_map(one)
    }

    /// The force line of the tissue at a node.
    fn line(&self, node: usize, segment: usize) -> Line {
        self.increment.map_or(Line::SPRING, |i| i.tissue[self.index].line(node, segment))
    }

    /// Energy (J).
    pub fn energy(&self) -> Result<f64, Collapsed> {
        let lattice = &self.bed.lattice;
        let mut energy = membrane::energy(lattice, self.sheet);
        energy += self.increment.map_or(0.0, |i| i.sheets[self.index].energy(lattice, self.sheet));
        energy += self.tile.air.energy(self.bed.volume(self.sheet))?;
        energy += self.bed.plate_energy(self.sheet) + self.bed.cover_energy(self.tile, self.sheet);
        energy += self.touches().iter().map(|(touch, _)| touch.energy()).sum::<f64>();
        let held = self.anchors.iter().zip(self.sheet).filter_map(|(anchor, x)| {
            let anchor = anchor.as_ref()?;
            Some(anchor.energy(self.tile.pose.outwards(*x), &self.poses[anchor.segment]))
        });
        Ok(energy + held.sum::<f64>())
    }

    /// Number of nodes on the plate.
    pub fn bottomed(&self) -> usize {
        self.sheet.iter().filter(|x| self.lone().below(x) > 0.0).count()
    }

    /// All forces between nodes and segments.
    pub fn bonds(&self) -> Vec<Bond> {
        let bond = |node: usize, segment: usize, place: Vec3<f64>, pull: Pull| Bond {
            node,
            segment,
            arm: sub(place, self.poses[segment].place),
            pull,
        };
        let touches = self.touches();
        let mut bonds: Vec<Bond> =
            touches.iter().map(|(t, place)| bond(t.node, t.segment, *place, self.pull(t, *place))).collect();
        for (node, anchor) in self.anchors.iter().enumerate() {
            let Some(anchor) = anchor else { continue };
            let place = self.tile.pose.outwards(self.sheet[node]);
            let pull = anchor.pull(place, &self.poses[anchor.segment]);
            // Touches are sorted by node.
            let first = bonds[..touches.len()].partition_point(|b| b.node < node);
            let mut own = bonds[first..touches.len()].iter_mut().take_while(|b| b.node == node);
            match own.find(|b| b.segment == anchor.segment) {
                Some(there) => there.pull = there.pull.with(&pull),
                None => bonds.push(bond(node, anchor.segment, place, pull)),
            }
        }
        bonds
    }

    /// Gradient and Hessian of a contact; if Hessians are exact, with the curvature of the surface.
    fn pull(&self, touch: &Touch, place: Vec3<f64>) -> Pull {
        let mut pull = touch.pull();
        if self.is_exact {
            let pose = &self.poses[touch.segment];
            let bent = self.body.segments[touch.segment].shape.curvature(pose.inwards(place));
            let columns = bent.map(|row| pose.attitude.to_inertial(row));
            let bed =
                [0, 1, 2].map(|k| pose.attitude.to_inertial([columns[0][k], columns[1][k], columns[2][k]]));
            (0..3).for_each(|i| (0..3).for_each(|j| pull.hessian[i][j] -= touch.tension() * bed[i][j]));
        }
        pull
    }

    /// The sheet's own terms.
    fn lone(&self) -> Lone<'a> {
        let swing = self.increment.map(|i| &i.sheets[self.index]);
        Lone::new(self.bed, self.tile, &self.bed.lattice, swing)
    }

    /// Gradients of energy and volume with respect to the free nodes.
    pub fn gradients(&self, bonds: &[Bond]) -> Result<[Vec<f64>; 2], Collapsed> {
        let lone = self.lone();
        let [mut force, volume] = lone.gradients(self.sheet)?;
        for link in self.links() {
            for (node, share) in self.own(&link) {
                force[node] = add(force[node], self.tile.pose.attitude.to_body(scale(link.force, share)));
            }
        }
        for bond in bonds {
            force[bond.node] = add(force[bond.node], self.tile.pose.attitude.to_body(bond.pull.gradient));
        }
        Ok([&force, &volume].map(|rows| lone.of_free(rows)))
    }

    /// The factored Hessian of the free nodes, given the volume's gradient.
    pub fn stiffness(&self, bonds: &[Bond], by_nodes: Vec<f64>) -> Result<Stiffness, Collapsed> {
        let lone = self.lone();
        let mut band = lone.hessian(self.sheet, self.is_exact)?;
        for bond in bonds {
            if let Some(free) = self.bed.lattice.free(bond.node) {
                band.add_block(free, free, &self.inwards(&bond.pull.hessian));
            }
        }
        lone.factored(self.sheet, &band, by_nodes)
    }

    /// Transforms a matrix from the bed's frame to the tile's.
    fn inwards(&self, h: &[Vec3<f64>; 3]) -> [Vec3<f64>; 3] {
        let axes = self.tile.pose.attitude.axes();
        axes.map(|a| axes.map(|b| dot(a, [dot(h[0], b), dot(h[1], b), dot(h[2], b)])))
    }

    /// Gradient with respect to the free nodes, and forces on segments.
    pub fn gradient(&self) -> Result<(Vec<f64>, Vec<Bond>), Collapsed> {
        let bonds = self.bonds();
        let [gradient, _] = self.gradients(&bonds)?;
        Ok((gradient, bonds))
    }

    /// Eliminates the nodes; `None` if no residual force is left and nothing touches.
    pub fn eliminate(&self, calm: f64) -> Result<Option<Eliminated>, Collapsed> {
        let bonds = self.bonds();
        let [gradient, volume] = self.gradients(&bonds)?;
        if bonds.is_empty() && self.links().is_empty() && gradient.iter().all(|g| g.abs() <= calm) {
            return Ok(None);
        }
        let stiffness = self.stiffness(&bonds, volume)?;
        let mut couplings = self.couplings(&bonds, gradient.len());
        couplings.iter_mut().for_each(|coupling| stiffness.solve_all(&mut coupling.solved));
        let mut solved = gradient.clone();
        stiffness.solve(&mut solved);
        let crossings = self.crossings(&stiffness, gradient.len());
        Ok(Some(Eliminated { solved, gradient, couplings, bonds, crossings }))
    }

    /// Forces between this sheet and neighbouring ones.
    fn links(&self) -> Vec<Link> {
        links(self.bed, self.sheets, self.met, self.rubs, self.index)
    }

    /// The nodes of this sheet among the ends of a link, with their weights.
    fn own<'b>(&self, link: &'b Link) -> impl Iterator<Item = (usize, f64)> + 'b {
        let index = self.index;
        link.ends.iter().filter(move |end| end.0 == index).map(|(_, node, share)| (*node, *share))
    }

    /// The springs of all links, with W solved.
    fn crossings(&self, stiffness: &Stiffness, size: usize) -> Vec<Crossing> {
        let attitude = self.tile.pose.attitude;
        let mut crossings = Vec::new();
        for link in self.links() {
            for (number, direction, spring) in &link.ways {
                let (mut column, mut solved) = (Vec::new(), vec![0.0; size]);
                for (node, share) in self.own(&link) {
                    let Some(free) = self.bed.lattice.free(node) else { continue };
                    let way = attitude.to_body(scale(*direction, share));
                    (0..3).for_each(|k| solved[3 * free + k] += way[k]);
                    column.push((free, way));
                }
                stiffness.solve(&mut solved);
                crossings.push(Crossing { number: *number, stiffness: *spring, column, solved });
            }
        }
        crossings
    }

    /// B for one segment after the other, -H (e_k, e_k x r) in the tile's axes; not solved yet.
    fn couplings(&self, bonds: &[Bond], size: usize) -> Vec<Coupling> {
        let mut touched: Vec<usize> = bonds.iter().map(|b| b.segment).collect();
        touched.sort_unstable();
        touched.dedup();
        touched.retain(|s| !self.body.segments[*s].is_held());
        let one = |segment: usize| {
            let mut columns = vec![[0.0; 6]; size];
            for bond in bonds.iter().filter(|b| b.segment == segment) {
                let Some(free) = self.bed.lattice.free(bond.node) else { continue };
                for (k, way) in lever(bond.arm).into_iter().enumerate() {
                    let push = self.tile.pose.attitude.to_body(bond.pull.hessian.map(|row| -dot(row, way)));
                    (0..3).for_each(|i| columns[3 * free + i][k] += push[i]);
                }
            }
            Coupling { segment, solved: columns.clone(), columns }
        };
        touched.into_iter().map(one).collect()
    }
}
