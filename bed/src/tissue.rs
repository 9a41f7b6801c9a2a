//! Tissue as a viscoelastic layer: a spring, a damper that retards it, and a branch that relaxes.
//!
//! In: a layer at the start of a stage and the formula w' = b (w - w~) of its end. Out: a line f = slope (depth -
//! rest), f >= 0, with f the force per stiffness of the layer: f = w + tau w' + q, q' + q/theta = (r - 1) w', where w
//! is the depth, tau the retardation time (Kelvin-Voigt) and r the ratio of instantaneous to long-term stiffness
//! (standard linear solid; Zener). With p = (r - 1) w - q, p' = q/theta. An unloaded layer recovers by itself: f = 0
//! gives its depth.

use crate::method::Formula;
use std::collections::BTreeMap;

/// Parameters of the viscoelastic layer, besides its stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tissue {
    /// Retardation time (s).
    pub loss: f64,
    /// Instantaneous stiffness divided by long-term stiffness, >= 1.
    pub at_once: f64,
    /// Relaxation time of the branch (s).
    pub relaxation: f64,
}

impl Tissue {
    /// Retarded by a loss factor of 0.3 at 2.4 Hz; without the relaxing branch.
    pub const DEFAULT: Tissue = Tissue { loss: 0.02, at_once: 1.0, relaxation: 30.0 };
}

/// A scalar in time, with its rate and its change over the last stage.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Course {
    /// Present value.
    pub value: f64,
    /// Rate (1/s).
    pub rate: f64,
    change: f64,
}

impl Course {
    fn resting(&self, formula: &Formula) -> f64 {
        self.value + formula.ahead_of(self.rate, self.change)
    }

    fn after(&self, formula: &Formula, value: f64) -> Course {
        let rate = formula.rate * (value - self.resting(formula));
        Course { value, rate, change: value - self.value }
    }
}

/// State of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Layer {
    /// w (m).
    pub depth: Course,
    /// p (m).
    pub relaxed: Course,
}

/// Force per stiffness of the layer: `slope` (depth - `rest`) if positive, else 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Stiffness divided by the layer's own.
    pub slope: f64,
    /// Depth (m) at which the force is 0.
    pub rest: f64,
}

impl Line {
    /// A layer without memory.
    pub const SPRING: Line = Line { slope: 1.0, rest: 0.0 };
}

impl Tissue {
    /// The line at the end of a stage.
    #[must_use]
    pub fn line(&self, layer: &Layer, formula: &Formula) -> Line {
        let retarded = self.loss * formula.rate;
        // b (p - p~) = ((r - 1) w - p)/theta gives q = kept ((r - 1) w - p~).
        let kept = self.kept(formula);
        let slope = 1.0 + retarded + kept * (self.at_once - 1.0);
        let held = retarded * layer.depth.resting(formula) + kept * layer.relaxed.resting(formula);
        Line { slope, rest: (held / slope).max(0.0) }
    }

    /// The layer after it has been pressed to a depth (m) for a long time.
    #[must_use]
    pub fn rested(&self, depth: f64) -> Layer {
        let at = |value: f64| Course { value, ..Course::default() };
        Layer { depth: at(depth), relaxed: at((self.at_once - 1.0) * depth) }
    }

    fn kept(&self, formula: &Formula) -> f64 {
        formula.rate / (formula.rate + 1.0 / self.relaxation)
    }

    /// The layer at the end of the stage, under a sheet at this depth; deeper if it has not recovered so far.
    #[must_use]
    pub fn after(&self, layer: &Layer, formula: &Formula, depth: f64) -> Layer {
        let depth = depth.max(self.line(layer, formula).rest);
        let kept = self.kept(formula);
        let relaxed = kept * layer.relaxed.resting(formula) + (1.0 - kept) * (self.at_once - 1.0) * depth;
        Layer { depth: layer.depth.after(formula, depth), relaxed: layer.relaxed.after(formula, relaxed) }
    }

    /// q (m).
    fn branch(&self, layer: &Layer) -> f64 {
        (self.at_once - 1.0) * layer.depth.value - layer.relaxed.value
    }

    /// Energy (J per N/m) stored in spring and branch.
    #[must_use]
    pub fn energy(&self, layer: &Layer) -> f64 {
        let q = self.branch(layer);
        let branch = if self.at_once > 1.0 { q * q / (self.at_once - 1.0) } else { 0.0 };
        0.5 * (layer.depth.value * layer.depth.value + branch)
    }

    /// Dissipated power (W per N/m).
    #[must_use]
    pub fn power(&self, layer: &Layer) -> f64 {
        let q = self.branch(layer);
        let branch = if self.at_once > 1.0 { q * q / ((self.at_once - 1.0) * self.relaxation) } else { 0.0 };
        self.loss * layer.depth.rate * layer.depth.rate + branch
    }
}

/// By node and segment: layers that differ from untouched tissue.
pub type Layers = BTreeMap<(usize, usize), Layer>;

/// The layers that a tile's nodes meet in a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Memory<'a> {
    /// What kind of tissue.
    pub tissue: Tissue,
    /// The stage.
    pub formula: Formula,
    /// By node and segment.
    pub layers: &'a Layers,
}

impl Memory<'_> {
    /// The force line that a node meets in a segment.
    #[must_use]
    pub fn line(&self, node: usize, segment: usize) -> Line {
        let layer = self.layers.get(&(node, segment)).copied().unwrap_or_default();
        self.tissue.line(&layer, &self.formula)
    }
}
