//! Gas inside a closed part of a body's facets: forces and potential energy.
//!
//! In: a range of facets, a regulated or a sealed gas, positions. Out: forces p dV/dx at the corners, potential. The
//! volume is the one that the facets enclose, independent of the origin because the surface is closed. Facets that a
//! port holds make a [`Wall`], which turns as a whole and costs no sum over facets.

use super::attachment::Attachment;
use crate::flexible::block::Pushes;
use crate::flexible::grid::{CellVolume, ElasticForces, Grid};
use crate::flexible::pressure::{PressureForm, Volume, enclosed_volume};
use crate::flexible::{Body, mean};
use crate::gas::{Chamber, GasFault, GasState, Regulated};
use crate::kernel;
use crate::mechanism::Fault;
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

/// A closed volume of gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell<S> {
    /// First of its facets among those of the body, and the one after its last.
    pub facets: [usize; 2],
    /// The gas.
    pub content: Content<S>,
    /// How a facet's force is shared by its corners.
    pub form: PressureForm,
    /// Those of its facets that a port holds.
    pub wall: Option<Wall<S>>,
}

/// The last facets of a cell, where one port holds all their corners: their volume and vector area in its frame. What
/// gas pushes each corner with is [`Attachment::push`] times its pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall<S> {
    /// First of the facets among those of the body; the last is the cell's.
    pub first: usize,
    /// The port.
    pub port: usize,
    /// First of the attachments of the corners, and the one after the last.
    pub attachments: [usize; 2],
    /// Volume (m^3) between the facets and the frame's origin.
    pub volume: S,
    /// Vector area (m^2), outwards: the sum of the pushes.
    pub area: Vec3<S>,
}

impl<S: Scalar> Wall<S> {
    /// Volume (m^3) between the facets and the origin of N: V + r . A/3, with the frame's origin r.
    fn volume_at(&self, frame: &Frame<S>) -> S {
        self.volume + vec3::dot(frame.origin, frame.to_inertial(self.area)) * S::from_f64(1.0 / 3.0)
    }
}

/// What holds the nodes of an island.
#[derive(Clone, Copy)]
pub(super) struct Holds<'a, S> {
    pub(super) attachments: &'a [Attachment<S>],
    /// Frames of the ports, as placed last.
    pub(super) frames: &'a [Frame<S>],
}

/// Gas at constant pressure or of constant mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Content<S> {
    /// Constant pressure.
    Regulated(Regulated<S>),
    /// All valves shut: p V^n is constant.
    Sealed {
        /// Exponent, reference volume and air outside.
        chamber: Chamber<S>,
        /// State of the gas that was filled in.
        state: GasState<S>,
    },
}

impl<S: Scalar> Content<S> {
    /// Pressure above ambient (Pa) at a volume (m^3).
    ///
    /// # Errors
    /// [`GasFault::Collapsed`] for a sealed gas without volume.
    pub fn gauge_pressure(&self, volume: S) -> Result<S, GasFault<S>> {
        match self {
            Content::Regulated(gas) => Ok(gas.gauge),
            Content::Sealed { chamber, state } => chamber.gauge_pressure(state, volume),
        }
    }

    /// Energy (J) that the gas can return to the walls.
    ///
    /// # Errors
    /// As for [`Content::gauge_pressure`].
    pub fn potential(&self, volume: S) -> Result<S, GasFault<S>> {
        match self {
            Content::Regulated(gas) => Ok(gas.potential(volume)),
            Content::Sealed { chamber, state } => chamber.potential(state, volume),
        }
    }
}

impl<S: Scalar> Cell<S> {
    /// Its facets among those of the body; None if the range does not exist.
    pub(super) fn of<'f>(&self, facets: &'f [[usize; 4]]) -> Option<&'f [[usize; 4]]> {
        let [first, end] = self.facets;
        facets.get(first..end)
    }

    /// Its facets without those of the wall: first, and the one after the last.
    pub(super) fn loose(&self) -> [usize; 2] {
        let [first, end] = self.facets;
        [first, self.wall.map_or(end, |wall| wall.first)]
    }

    /// Whether its facets and those of its wall exist, grids have none of the wall's, and what the wall names exists.
    pub(super) fn fits(&self, body: &Body<S>, holds: Holds<'_, S>) -> bool {
        let ([first, loose_end], [_, end]) = (self.loose(), self.facets);
        let beside = |grid: &Grid<S>| !self.holds(grid) || grid.facets[1] <= loose_end;
        let known = self.wall.is_none_or(|wall| {
            let [first, end] = wall.attachments;
            wall.port < holds.frames.len() && holds.attachments.get(first..end).is_some()
        });
        let ordered = first <= loose_end && loose_end <= end;
        ordered && known && self.of(body.facets).is_some() && body.grids.iter().all(beside)
    }

    /// Volume (m^3).
    #[must_use]
    pub fn volume(&self, facets: &[[usize; 4]], pos: &[Vec3<S>]) -> S {
        enclosed_volume(self.of(facets).unwrap_or_default(), pos)
    }

    /// The same number to rounding, the wall as a whole and the cells of grids row by row. A microcontroller computes
    /// one number at a time, and would fill lanes for nothing.
    pub(super) fn volume_held(
        &self,
        body: &Body<S>,
        grids: &[Grid<S>],
        frames: &[Frame<S>],
        pos: &[Vec3<S>],
    ) -> S {
        let grids = if cfg!(target_os = "none") { &[] } else { grids };
        let part = |from: usize, to: usize| body.facets.get(from..to).unwrap_or_default();
        let (mut volume, [mut first, end]) = (Volume::zero(), self.loose());
        for grid in grids.iter().filter(|grid| self.holds(grid)) {
            volume.add(part(first, grid.facets[0]), pos);
            volume.quads = kernel::run(CellVolume { grid, pos, sum: volume.quads });
            first = grid.facets[1];
        }
        volume.add(part(first, end), pos);
        let of_wall = |wall: Wall<S>| frames.get(wall.port).map(|frame| wall.volume_at(frame));
        volume.total() + self.wall.and_then(of_wall).unwrap_or(S::ZERO)
    }

    /// Whether the facets of a grid are among its own.
    pub(super) fn holds(&self, grid: &Grid<S>) -> bool {
        let ([first, end], [own_first, own_end]) = (grid.facets, self.facets);
        first < end && own_first <= first && end <= own_end
    }

    /// Adds the forces on the corners (N). Forces on nodes of grids are overwritten instead, with everything that acts
    /// there.
    pub(super) fn add_force(
        &self,
        body: &Body<S>,
        grids: &[Grid<S>],
        holds: Holds<'_, S>,
        pos: &[Vec3<S>],
        force: &mut [Vec3<S>],
    ) -> Result<(), Fault> {
        let volume = match self.content {
            Content::Regulated(_) => S::ZERO,
            Content::Sealed { .. } => self.volume_held(body, grids, holds.frames, pos),
        };
        let pressure = self.content.gauge_pressure(volume).map_err(|_| Fault::NonFinite)?;
        let (form, gravity, [mut first, end]) = (self.form, body.gravity, self.loose());
        let push = |from: usize, to: usize, force: &mut [Vec3<S>]| {
            let facets = body.facets.get(from..to).unwrap_or_default();
            kernel::run(Pushes { facets, form, pressure, pos, force });
        };
        for grid in grids.iter().filter(|grid| self.holds(grid)) {
            kernel::run(ElasticForces { grid, pressure: Some((form, pressure)), pos, gravity, force });
            push(first, grid.facets[0], force);
            first = grid.facets[1];
        }
        push(first, end, force);
        self.push_wall(holds, pressure, force);
        Ok(())
    }

    /// Adds the forces on the corners of the wall (N).
    fn push_wall(&self, holds: Holds<'_, S>, pressure: S, force: &mut [Vec3<S>]) {
        let Some(wall) = self.wall else { return };
        let [first, end] = wall.attachments;
        let Some(frame) = holds.frames.get(wall.port) else { return };
        for held in holds.attachments.get(first..end).unwrap_or_default() {
            vec3::add_at(force, held.node, vec3::scale(frame.to_inertial(held.push), pressure));
        }
    }

    /// Adds mean forces over a step on the corners (N), whose work is the change of the potential; mean pressure by
    /// Simpson's rule.
    pub(super) fn add_mean_force(
        &self,
        facets: &[[usize; 4]],
        way: &MeanStep<S>,
        force: &mut [Vec3<S>],
    ) -> Result<(), Fault> {
        let pressure = match self.content {
            Content::Regulated(gas) => gas.gauge,
            Content::Sealed { .. } => {
                let gauge = |volume: S| self.content.gauge_pressure(volume).map_err(|_| Fault::NonFinite);
                let [before, _, after] = way.pos.map(|pos| self.volume(facets, pos));
                let between = gauge(S::from_f64(0.5) * (before + after))?;
                (gauge(before)? + S::from_f64(4.0) * between + gauge(after)?) * S::from_f64(1.0 / 6.0)
            }
        };
        mean::add_pressure(self.of(facets).unwrap_or_default(), self.form, pressure, way, force);
        Ok(())
    }

    /// Energy (J) that the gas can return to the walls.
    pub(super) fn potential(&self, facets: &[[usize; 4]], pos: &[Vec3<S>]) -> Result<S, Fault> {
        self.content.potential(self.volume(facets, pos)).map_err(|_| Fault::NonFinite)
    }
}
