//! DOP853 with dense output: y' = f(t, y) to any tolerance, and y at every time within a step.
//!
//! In: f as a function on slices, a tolerance (absolute and relative). Out: steps with dense output, on which events
//! are located without further evaluations. It allocates memory: it is the host's tool for reference trajectories; the
//! runtime steps bodies with the same tableau. Source: Hairer, Norsett & Wanner, Solving Ordinary Differential
//! Equations I, 2nd ed. (1993), II.5, II.6, II.10.

use smartbed_runtime::ode::tableau::DOP853;

const STAGES: usize = 12;
/// Smallest and largest change of the step from one to the next, and the safety factor before it.
const SHRINK: f64 = 0.2;
const GROW: f64 = 5.0;
const SAFETY: f64 = 0.9;
/// Most attempts at one step: each failure shortens it at least by [`SAFETY`].
const TRIES: usize = 200;

/// Weights of the three additional stages of the dense output, at 0.1, 0.2 and 7/9 of the step.
#[rustfmt::skip]
const EXTRA: [[f64; 16]; 3] = [
    [
        0.056167502283047954, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25350021021662483, -0.2462390374708025,
        -0.12419142326381637, 0.15329179827876568, 0.00820105229563469, 0.007567897660545699,
        -0.008298, 0.0, 0.0, 0.0,
    ],
    [
        0.03183464816350214, 0.0, 0.0, 0.0, 0.0, 0.028300909672366776, 0.053541988307438566,
        -0.05492374857139099, 0.0, 0.0, -0.00010834732869724932, 0.0003825710908356584,
        -0.00034046500868740456, 0.1413124436746325, 0.0, 0.0,
    ],
    [
        -0.42889630158379194, 0.0, 0.0, 0.0, 0.0, -4.697621415361164, 7.683421196062599,
        4.06898981839711, 0.3567271874552811, 0.0, 0.0, 0.0, -0.0013990241651590145,
        2.9475147891527724, -9.15095847217987, 0.0,
    ],
];
/// Weights of the higher coefficients of the dense output.
#[rustfmt::skip]
const DENSE: [[f64; 16]; 4] = [
    [
        -8.428938276109013, 0.0, 0.0, 0.0, 0.0, 0.5667149535193777, -3.0689499459498917,
        2.38466765651207, 2.117034582445028, -0.871391583777973, 2.2404374302607883,
        0.6315787787694688, -0.08899033645133331, 18.148505520854727, -9.194632392478356,
        -4.436036387594894,
    ],
    [
        10.427508642579134, 0.0, 0.0, 0.0, 0.0, 242.28349177525817, 165.20045171727028,
        -374.5467547226902, -22.113666853125306, 7.733432668472264, -30.674084731089398,
        -9.332130526430229, 15.697238121770845, -31.139403219565178, -9.35292435884448,
        35.81684148639408,
    ],
    [
        19.985053242002433, 0.0, 0.0, 0.0, 0.0, -387.0373087493518, -189.17813819516758,
        527.8081592054236, -11.57390253995963, 6.8812326946963, -1.0006050966910838,
        0.7777137798053443, -2.778205752353508, -60.19669523126412, 84.32040550667716,
        11.99229113618279,
    ],
    [
        -25.69393346270375, 0.0, 0.0, 0.0, 0.0, -154.18974869023643, -231.5293791760455,
        357.6391179106141, 93.40532418362432, -37.45832313645163, 104.0996495089623,
        29.8402934266605, -43.53345659001114, 96.32455395918828, -39.17726167561544,
        -149.72683625798564,
    ],
];

/// One accepted step; dense output of order 7.
#[derive(Clone, Debug)]
pub struct Dense {
    /// Time at its start (s).
    pub t: f64,
    /// Its length (s).
    pub h: f64,
    start: Vec<f64>,
    coefficients: [Vec<f64>; 7],
}

impl Dense {
    /// y at time t + theta h, 0 <= theta <= 1.
    #[must_use]
    pub fn at(&self, theta: f64) -> Vec<f64> {
        let mut y = vec![0.0; self.start.len()];
        for (i, coefficient) in self.coefficients.iter().enumerate().rev() {
            let factor = if i % 2 == 0 { theta } else { 1.0 - theta };
            y.iter_mut().zip(coefficient).for_each(|(y, c)| *y = (*y + c) * factor);
        }
        y.iter_mut().zip(&self.start).for_each(|(y, s)| *y += s);
        y
    }
}

/// The integrator: its state and the length of the next step.
#[derive(Clone, Debug)]
pub struct Dop853<F> {
    f: F,
    tolerance: f64,
    /// Time (s).
    pub t: f64,
    /// State.
    pub y: Vec<f64>,
    slope: Vec<f64>,
    step: f64,
    /// The longest step (s): infinite at first. Where f depends on time, a longer one may miss a pulse.
    pub longest: f64,
    /// Evaluations of f so far.
    pub evaluations: usize,
}

impl<F: FnMut(f64, &[f64], &mut [f64])> Dop853<F> {
    /// Starts at (t, y); `step` (s) is the length tried first.
    pub fn new(f: F, t: f64, y: Vec<f64>, tolerance: f64, step: f64) -> Dop853<F> {
        let slope = vec![0.0; y.len()];
        let mut solver =
            Dop853 { f, tolerance, t, y: Vec::new(), slope, step, longest: f64::INFINITY, evaluations: 0 };
        solver.restart(t, y, step);
        solver
    }

    /// Continues from another state, as after an event.
    pub fn restart(&mut self, t: f64, y: Vec<f64>, step: f64) {
        (self.t, self.y, self.step) = (t, y, step);
        (self.f)(t, &self.y, &mut self.slope);
        self.evaluations += 1;
    }

    /// The right-hand side, to change its mode at an event; then call [`Dop853::restart`].
    pub fn right_hand_side(&mut self) -> &mut F {
        &mut self.f
    }

    /// One accepted step that does not pass `end`.
    ///
    /// # Errors
    /// The time at which no step was small enough.
    pub fn advance(&mut self, end: f64) -> Result<Dense, f64> {
        for _ in 0..TRIES {
            let step = self.step.min(self.longest);
            let h = if 1.001 * step >= end - self.t { end - self.t } else { step };
            let mut k = vec![self.slope.clone()];
            for s in 1..STAGES {
                let y = self.combine(h, &k, &DOP853.a[s]);
                k.push(self.evaluate(self.t + DOP853.c[s] * h, &y));
            }
            let y = self.combine(h, &k, &DOP853.b);
            let error = self.error(h, &k, &y);
            if !error.is_finite() {
                self.step = SHRINK * h;
                continue;
            }
            let factor = (SAFETY * error.max(1e-14).powf(-1.0 / 8.0)).clamp(SHRINK, GROW);
            if error > 1.0 {
                self.step = h * factor.min(SAFETY);
                continue;
            }
            // A step shortened to end at `end` is no reason to shorten the next one.
            self.step = if h < self.step { self.step.max(h * factor) } else { h * factor };
            return Ok(self.accept(h, k, y));
        }
        Err(self.t)
    }

    fn evaluate(&mut self, t: f64, y: &[f64]) -> Vec<f64> {
        let mut k = vec![0.0; y.len()];
        (self.f)(t, y, &mut k);
        self.evaluations += 1;
        k
    }

    /// y + h sum weight_j k_j.
    fn combine(&self, h: f64, k: &[Vec<f64>], weights: &[f64]) -> Vec<f64> {
        let mut y = self.y.clone();
        for (k, w) in k.iter().zip(weights) {
            y.iter_mut().zip(k).for_each(|(y, k)| *y += h * w * k);
        }
        y
    }

    /// Hairer's combination of the estimates of order 5 and 3, in units of the tolerance.
    fn error(&self, h: f64, k: &[Vec<f64>], y: &[f64]) -> f64 {
        let (mut fine, mut coarse) = (0.0, 0.0);
        for i in 0..y.len() {
            let scale = self.tolerance * (1.0 + self.y[i].abs().max(y[i].abs()));
            let sum = |weights: &[f64]| k.iter().zip(weights).map(|(k, w)| w * k[i]).sum::<f64>() / scale;
            fine += sum(&DOP853.error.b).powi(2);
            coarse += sum(&DOP853.coarse.b).powi(2);
        }
        if fine == 0.0 {
            return 0.0;
        }
        h.abs() * fine / ((fine + 0.01 * coarse) * y.len() as f64).sqrt()
    }

    /// Accepts the step. The dense output takes four more evaluations, one of which is the first of the next step.
    fn accept(&mut self, h: f64, mut k: Vec<Vec<f64>>, y: Vec<f64>) -> Dense {
        let end_slope = self.evaluate(self.t + h, &y);
        k.push(end_slope.clone());
        for (weights, c) in EXTRA.iter().zip([0.1, 0.2, 7.0 / 9.0]) {
            let stage = self.combine(h, &k, weights);
            k.push(self.evaluate(self.t + c * h, &stage));
        }
        let change: Vec<f64> = y.iter().zip(&self.y).map(|(b, a)| b - a).collect();
        let first = change.iter().zip(&self.slope).map(|(d, s)| h * s - d).collect();
        let ends = self.slope.iter().zip(&end_slope);
        let second = change.iter().zip(ends).map(|(d, (a, b))| 2.0 * d - h * (a + b)).collect();
        let higher = |row: usize| -> Vec<f64> {
            let sum = |i: usize| k.iter().zip(&DENSE[row]).map(|(k, w)| w * k[i]).sum::<f64>();
            (0..y.len()).map(|i| h * sum(i)).collect()
        };
        let coefficients = [change, first, second, higher(0), higher(1), higher(2), higher(3)];
        let dense = Dense { t: self.t, h, start: std::mem::replace(&mut self.y, y), coefficients };
        self.t += h;
        self.slope = end_slope;
        dense
    }
}
