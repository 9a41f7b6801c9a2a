//! Gas inside a closed part of a body's facets: forces and potential energy.
//!
//! In: a range of facets, a regulated or a sealed gas, positions. Out: forces p dV/dx at the corners, potential. The
//! volume is the one that the facets enclose, independent of the origin because the surface is closed.

use crate::flexible::block::Pushes;
use crate::flexible::grid::{CellVolume, ElasticForces, Grid};
use crate::flexible::pressure::{PressureForm, Volume, enclosed_volume};
use crate::flexible::{Body, mean};
use crate::gas::{Chamber, GasFault, GasState, Regulated};
use crate::kernel;
use crate::mechanism::Fault;
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::vec3::Vec3;

/// A closed volume of gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell<S> {
    /// First of its facets among those of the body, and the one after its last.
    pub facets: [usize; 2],
    /// The gas.
    pub content: Content<S>,
    /// How a facet's force is shared by its corners.
    pub form: PressureForm,
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

    /// Volume (m^3).
    #[must_use]
    pub fn volume(&self, facets: &[[usize; 4]], pos: &[Vec3<S>]) -> S {
        enclosed_volume(self.of(facets).unwrap_or_default(), pos)
    }

    /// The same number, with the cells of grids computed row by row. A microcontroller computes one number at a time,
    /// and would fill lanes for nothing.
    pub(super) fn volume_by_rows(&self, body: &Body<S>, grids: &[Grid<S>], pos: &[Vec3<S>]) -> S {
        if cfg!(target_os = "none") {
            return self.volume(body.facets, pos);
        }
        let part = |from: usize, to: usize| body.facets.get(from..to).unwrap_or_default();
        let (mut volume, [mut first, end]) = (Volume::zero(), self.facets);
        for grid in grids.iter().filter(|grid| self.holds(grid)) {
            volume.add(part(first, grid.facets[0]), pos);
            volume.quads = kernel::run(CellVolume { grid, pos, sum: volume.quads });
            first = grid.facets[1];
        }
        volume.add(part(first, end), pos);
        volume.total()
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
        pos: &[Vec3<S>],
        force: &mut [Vec3<S>],
    ) -> Result<(), Fault> {
        let volume = match self.content {
            Content::Regulated(_) => S::ZERO,
            Content::Sealed { .. } => self.volume_by_rows(body, grids, pos),
        };
        let pressure = self.content.gauge_pressure(volume).map_err(|_| Fault::NonFinite)?;
        let (form, gravity, [mut first, end]) = (self.form, body.gravity, self.facets);
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
        Ok(())
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
