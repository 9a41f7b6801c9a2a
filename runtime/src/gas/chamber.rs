//! A chamber of gas: state, pressure at a volume, lines, and energy accounts.

use super::ideal::{self, Gas};
use super::nozzle::{Nozzle, Source};
use crate::real::Scalar;

/// Most parts of a step in [`Chamber::flow`].
pub const PARTS: u16 = 4096;

/// Constants of a chamber.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chamber<S> {
    /// The gas.
    pub gas: Gas<S>,
    /// n, from 1 (isothermal) to gamma (adiabatic).
    pub exponent: S,
    /// V_r (m^3), > 0: the volume to which the state refers.
    pub reference_volume: S,
    /// Absolute ambient pressure (Pa).
    pub ambient: S,
}

/// State of the gas.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GasState<S> {
    /// s = p (V/V_r)^n (Pa), absolute.
    pub reference_pressure: S,
    /// m (kg).
    pub mass: S,
}

/// A line to a reservoir of constant pressure: a supply, or the ambient. Gas flows towards the lower pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<S> {
    /// The valve when fully open.
    pub nozzle: Nozzle<S>,
    /// Opening of the valve, 0 to 1: share of the conductance.
    pub opening: S,
    /// State of the reservoir.
    pub reservoir: Source<S>,
}

/// Energy accounts of a gas (J), or their rates (W).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Account<S> {
    /// Enthalpy that flowed in.
    pub enthalpy_in: S,
    /// Enthalpy that flowed out.
    pub enthalpy_out: S,
    /// Heat absorbed through the walls.
    pub heat: S,
    /// Work on the walls, including that against the ambient: integral of p dV, p absolute.
    pub work: S,
}

/// Rates of the gas state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates<S> {
    /// s' (Pa/s).
    pub reference_pressure: S,
    /// m' (kg/s).
    pub mass: S,
    /// Powers (W).
    pub power: Account<S>,
}

/// Why a gas state is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GasFault<S> {
    /// The volume (m^3) is not positive: the walls have passed through one another.
    Collapsed(S),
    /// The mass (kg) is not positive: more flowed out in one step than there was; take a shorter step.
    Empty(S),
    /// Pressures equalise this many times faster than a step can follow; take a shorter step, or a narrower line.
    TooFast(S),
}

impl<S: Scalar> Account<S> {
    /// All zero.
    #[must_use]
    pub fn empty() -> Account<S> {
        Account { enthalpy_in: S::ZERO, enthalpy_out: S::ZERO, heat: S::ZERO, work: S::ZERO }
    }

    /// self + h * other.
    #[must_use]
    pub fn plus(&self, h: S, other: &Account<S>) -> Account<S> {
        Account {
            enthalpy_in: self.enthalpy_in + h * other.enthalpy_in,
            enthalpy_out: self.enthalpy_out + h * other.enthalpy_out,
            heat: self.heat + h * other.heat,
            work: self.work + h * other.work,
        }
    }

    /// Gain of internal energy: enthalpy in - out + heat - work.
    #[must_use]
    pub fn gain(&self) -> S {
        self.enthalpy_in - self.enthalpy_out + self.heat - self.work
    }
}

impl<S: Scalar> Line<S> {
    /// Mass flow (kg/s) into and out of a chamber at this state; one of the two is 0.
    fn flows(&self, inside: Source<S>) -> (S, S) {
        let into = self.nozzle.mass_flow(self.reservoir, inside.pressure);
        let out = self.nozzle.mass_flow(inside, self.reservoir.pressure);
        (self.opening * into, self.opening * out)
    }
}

impl<S: Scalar> Chamber<S> {
    /// The state at an absolute pressure (Pa), temperature (K) and volume (m^3).
    #[must_use]
    pub fn filled(&self, with: Source<S>, volume: S) -> GasState<S> {
        let mass = with.pressure * volume / (self.gas.gas_constant * with.temperature);
        GasState { reference_pressure: with.pressure * self.expansion(volume), mass }
    }

    /// Absolute pressure (Pa) and temperature (K) at a volume (m^3).
    ///
    /// # Errors
    /// [`GasFault`] if volume or mass is not positive.
    pub fn inside(&self, state: &GasState<S>, volume: S) -> Result<Source<S>, GasFault<S>> {
        let pressure = self.pressure(state, volume)?;
        if state.mass > S::ZERO {
            Ok(Source { pressure, temperature: pressure * volume / (state.mass * self.gas.gas_constant) })
        } else {
            Err(GasFault::Empty(state.mass))
        }
    }

    /// Absolute pressure (Pa).
    ///
    /// # Errors
    /// [`GasFault::Collapsed`] if the volume is not positive.
    pub fn pressure(&self, state: &GasState<S>, volume: S) -> Result<S, GasFault<S>> {
        if volume > S::ZERO {
            Ok(state.reference_pressure / self.expansion(volume))
        } else {
            Err(GasFault::Collapsed(volume))
        }
    }

    /// Pressure above ambient (Pa), which pushes the walls outwards.
    ///
    /// # Errors
    /// As for [`Chamber::pressure`].
    pub fn gauge_pressure(&self, state: &GasState<S>, volume: S) -> Result<S, GasFault<S>> {
        Ok(self.pressure(state, volume)? - self.ambient)
    }

    /// -dp/dV (Pa/m^3) with the lines shut: n p/V, the stiffness of the gas.
    ///
    /// # Errors
    /// As for [`Chamber::pressure`].
    pub fn stiffness(&self, state: &GasState<S>, volume: S) -> Result<S, GasFault<S>> {
        Ok(self.exponent * self.pressure(state, volume)? / volume)
    }

    /// Internal energy (J): p V/(gamma - 1).
    ///
    /// # Errors
    /// As for [`Chamber::pressure`].
    pub fn internal_energy(&self, state: &GasState<S>, volume: S) -> Result<S, GasFault<S>> {
        Ok(self.pressure(state, volume)? * volume / (self.gas.heat_capacity_ratio - S::ONE))
    }

    /// Energy (J) that the sealed gas and the ambient can return to the walls: minus the integral of the gauge
    /// pressure from V_r. Heat through the walls is not included.
    ///
    /// # Errors
    /// As for [`Chamber::pressure`].
    pub fn potential(&self, state: &GasState<S>, volume: S) -> Result<S, GasFault<S>> {
        self.pressure(state, volume)?;
        let outside = self.ambient * (volume - self.reference_volume);
        Ok(outside - state.reference_pressure * self.reference_volume * self.length(volume))
    }

    /// Rates at a volume (m^3) and its rate (m^3/s), with these lines.
    ///
    /// # Errors
    /// [`GasFault`] if volume or mass is not positive.
    pub fn rates(
        &self,
        state: &GasState<S>,
        volume: S,
        volume_rate: S,
        lines: &[Line<S>],
    ) -> Result<Rates<S>, GasFault<S>> {
        let inside = self.inside(state, volume)?;
        let (mut mass, mut hot_in, mut mass_out) = (S::ZERO, S::ZERO, S::ZERO);
        for line in lines {
            let (into, out) = line.flows(inside);
            mass = mass + into - out;
            hot_in = hot_in + into * line.reservoir.temperature;
            mass_out = mass_out + out;
        }
        let (gas, ratio) = (self.gas.gas_constant, self.gas.heat_capacity_ratio);
        let carried = gas * (hot_in - inside.temperature * mass_out);
        let work = inside.pressure * volume_rate;
        let over = S::ONE / (ratio - S::ONE);
        let power = Account {
            enthalpy_in: ratio * over * gas * hot_in,
            enthalpy_out: ratio * over * gas * inside.temperature * mass_out,
            heat: (self.exponent - ratio) * over * (carried - work),
            work,
        };
        let reference_pressure = self.exponent * self.expansion(volume) * carried / volume;
        Ok(Rates { reference_pressure, mass, power })
    }

    /// The state after h (s) of flow through lines at constant volume (m^3), and its energy account (J).
    ///
    /// The explicit trapezoidal rule (order 2), in parts short enough for equalising pressures: near equality p relaxes
    /// at the rate n R T/V sum dm'/dp.
    ///
    /// # Errors
    /// [`GasFault`] if volume or mass is not positive, or if more than `PARTS` parts are needed.
    pub fn flow(
        &self,
        state: &GasState<S>,
        volume: S,
        lines: &[Line<S>],
        h: S,
    ) -> Result<(GasState<S>, Account<S>), GasFault<S>> {
        let inside = self.inside(state, volume)?;
        let steepest = lines.iter().fold(S::ZERO, |sum, line| {
            sum + line.opening * line.nozzle.steepest(inside).max(line.nozzle.steepest(line.reservoir))
        });
        let rate = self.exponent * self.gas.gas_constant * inside.temperature / volume * steepest;
        let wanted = S::from_f64(4.0) * h * rate;
        if wanted > S::from_f64(f64::from(PARTS)) {
            return Err(GasFault::TooFast(wanted));
        }
        let (mut parts, mut length) = (1, h);
        while S::from_f64(f64::from(parts)) < wanted {
            (parts, length) = (2 * parts, S::from_f64(0.5) * length);
        }
        let (mut state, mut account) = (*state, Account::empty());
        let moved = |from: &GasState<S>, by: S, rates: &Rates<S>| GasState {
            reference_pressure: from.reference_pressure + by * rates.reference_pressure,
            mass: from.mass + by * rates.mass,
        };
        let half = S::from_f64(0.5) * length;
        for _ in 0..parts {
            let first = self.rates(&state, volume, S::ZERO, lines)?;
            let last = self.rates(&moved(&state, length, &first), volume, S::ZERO, lines)?;
            state = moved(&moved(&state, half, &first), half, &last);
            account = account.plus(half, &first.power).plus(half, &last.power);
        }
        Ok((state, account))
    }

    /// Energy account (J) of the gas, lines shut, from one volume (m^3) to another: work on the walls W = integral of p
    /// dV, heat (n - gamma)/(gamma - 1) (-W).
    #[must_use]
    pub fn pushed(&self, state: &GasState<S>, from: S, to: S) -> Account<S> {
        let length = self.length(to) - self.length(from);
        let work = state.reference_pressure * self.reference_volume * length;
        let ratio = self.gas.heat_capacity_ratio;
        Account { heat: (self.exponent - ratio) / (ratio - S::ONE) * -work, work, ..Account::empty() }
    }

    /// The integral of (V_r/V)^n dV/V_r from V_r to a volume.
    fn length(&self, volume: S) -> S {
        ideal::work(S::ONE, self.exponent, (volume / self.reference_volume).ln())
    }

    /// (V/V_r)^n.
    fn expansion(&self, volume: S) -> S {
        (self.exponent * (volume / self.reference_volume).ln()).exp()
    }
}

/// A chamber whose regulator is faster than its walls: constant pressure, no state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regulated<S> {
    /// The gas.
    pub gas: Gas<S>,
    /// Pressure above ambient (Pa).
    pub gauge: S,
    /// Absolute ambient pressure (Pa).
    pub ambient: S,
}

impl<S: Scalar> Regulated<S> {
    /// Powers (W) at a rate of volume (m^3/s). The regulator moves gas of the chamber's own temperature,
    /// p V' = R T m', so enthalpy enters at c_p T m' = gamma/(gamma - 1) p V', and no heat does.
    #[must_use]
    pub fn power(&self, volume_rate: S) -> Account<S> {
        let ratio = self.gas.heat_capacity_ratio;
        let work = (self.gauge + self.ambient) * volume_rate;
        let enthalpy = ratio / (ratio - S::ONE) * work;
        let enthalpy_in = enthalpy.max(S::ZERO);
        Account { enthalpy_in, enthalpy_out: enthalpy_in - enthalpy, heat: S::ZERO, work }
    }

    /// Internal energy (J): p V/(gamma - 1).
    #[must_use]
    pub fn internal_energy(&self, volume: S) -> S {
        (self.gauge + self.ambient) * volume / (self.gas.heat_capacity_ratio - S::ONE)
    }

    /// Energy (J) that the gas can return to the walls: -gauge V.
    #[must_use]
    pub fn potential(&self, volume: S) -> S {
        -(self.gauge * volume)
    }
}
