//! Tissue as a layer of springs with a memory: depth presses, losses retard it, a branch relaxes.
//!
//! In: a layer at the start of a stage and the formula w' = b (w - w~) of its end. Out: a line f = slope (depth - rest),
//! f >= 0, per stiffness of the layer: f = w + tau w' + q, q' + q/theta = (r - 1) w', with w the depth, tau the retardation
//! (Kelvin and Voigt) and r the stiffness at once over that at last (standard linear solid; Zener). With p = (r - 1) w - q,
//! p' = q/theta. Where nothing presses the layer comes back by itself: f = 0 gives its depth.

use crate::method::Formula;
use std::collections::BTreeMap;

/// What tissue does besides being a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tissue {
    /// Retardation (s).
    pub loss: f64,
    /// Stiffness at once over that at last, >= 1.
    pub at_once: f64,
    /// Time in which the branch relaxes (s).
    pub relaxation: f64,
}

impl Tissue {
    /// Retarded as by a loss factor of 0.3 at 2.4 Hz; the branch is off.
    pub const DEFAULT: Tissue = Tissue { loss: 0.02, at_once: 1.0, relaxation: 30.0 };
}

/// A number over time, with its rate and its change in the last stage.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Course {
    /// Now.
    pub value: f64,
    /// Per second.
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

/// Where a layer stands.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Layer {
    /// w (m).
    pub depth: Course,
    /// p (m).
    pub relaxed: Course,
}

/// Force per stiffness of the layer: `slope` (depth - `rest`) where that is > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Stiffness over the layer's own.
    pub slope: f64,
    /// Depth (m) that nothing presses on.
    pub rest: f64,
}

impl Line {
    /// The layer without memory.
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

    /// The layer as long pressing to a depth (m) leaves it.
    #[must_use]
    pub fn rested(&self, depth: f64) -> Layer {
        let at = |value: f64| Course { value, ..Course::default() };
        Layer { depth: at(depth), relaxed: at((self.at_once - 1.0) * depth) }
    }

    fn kept(&self, formula: &Formula) -> f64 {
        formula.rate / (formula.rate + 1.0 / self.relaxation)
    }

    /// The layer at the end of the stage, under a sheet at a depth.
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

    /// Energy (J per N/m) that spring and branch hold.
    #[must_use]
    pub fn energy(&self, layer: &Layer) -> f64 {
        let q = self.branch(layer);
        let branch = if self.at_once > 1.0 { q * q / (self.at_once - 1.0) } else { 0.0 };
        0.5 * (layer.depth.value * layer.depth.value + branch)
    }

    /// Power (W per N/m) that is lost.
    #[must_use]
    pub fn power(&self, layer: &Layer) -> f64 {
        let q = self.branch(layer);
        let branch = if self.at_once > 1.0 { q * q / ((self.at_once - 1.0) * self.relaxation) } else { 0.0 };
        self.loss * layer.depth.rate * layer.depth.rate + branch
    }
}

/// Layers of a tile's nodes in segments, where they differ from untouched tissue.
pub type Layers = BTreeMap<(usize, usize), Layer>;

/// What a tile's nodes meet in the segments in a stage.
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
    /// What a node meets in a segment.
    #[must_use]
    pub fn line(&self, node: usize, segment: usize) -> Line {
        let layer = self.layers.get(&(node, segment)).copied().unwrap_or_default();
        self.tissue.line(&layer, &self.formula)
    }
}
