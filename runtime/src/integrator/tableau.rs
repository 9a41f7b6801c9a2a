//! Coefficients of the integrators as data, each with its citation.
//!
//! Written as fractions in f64, rounded to the scalar at compile time: a microcontroller without
//! double precision never converts them.

use crate::real::Scalar;

/// Nodes and weights of a Runge-Kutta method whose stage i uses the rates of stage i - 1 only.
#[derive(Clone, Copy, Debug)]
pub struct Chain<S> {
    /// c: stage i is at t + c h, with x + c h k of the stage before.
    pub c: [S; 4],
    /// b: weights of the stages.
    pub b: [S; 4],
}

/// An explicit embedded pair of 7 stages, the last at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct Pair<S> {
    /// a: row i holds the weights of the earlier stages in stage i; the last row is also b.
    pub a: [[S; 7]; 7],
    /// c: nodes.
    pub c: [S; 7],
    /// b - b_hat: weights of the error estimate.
    pub e: [S; 7],
    /// d: weights of the last term of the continuous extension.
    pub d: [S; 7],
}

/// The classical method of order 4: Kutta (1901).
const KUTTA: Chain<f64> =
    Chain { c: [0.0, 1.0 / 2.0, 1.0 / 2.0, 1.0], b: [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0] };

/// Dormand & Prince (1980), RK5(4)7M; d from Hairer, Norsett & Wanner, Solving Ordinary Differential
/// Equations I (1993), II.6, continuous extension of order 4 (code DOPRI5).
const DORMAND_PRINCE: Pair<f64> = Pair {
    a: [
        [0.0; 7],
        [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
        [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0, 0.0],
        [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0, 0.0],
        [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0],
    ],
    c: [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
    e: [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0],
    d: [
        -12_715_105_075.0 / 11_282_082_432.0,
        0.0,
        87_487_479_700.0 / 32_700_410_799.0,
        -10_690_763_975.0 / 1_880_347_072.0,
        701_980_252_875.0 / 199_316_789_632.0,
        -1_453_857_185.0 / 822_651_844.0,
        69_997_945.0 / 29_380_423.0,
    ],
};

/// A scalar that the coefficients have been rounded to.
pub trait Tabulated: Scalar {
    /// Kutta's classical method.
    const KUTTA: Chain<Self>;
    /// Dormand and Prince's pair.
    const DORMAND_PRINCE: Pair<Self>;
}

impl Tabulated for f64 {
    const KUTTA: Chain<f64> = KUTTA;
    const DORMAND_PRINCE: Pair<f64> = DORMAND_PRINCE;
}

impl Tabulated for f32 {
    const KUTTA: Chain<f32> = Chain { c: rounded(KUTTA.c), b: rounded(KUTTA.b) };
    const DORMAND_PRINCE: Pair<f32> = {
        let mut a = [[0.0; 7]; 7];
        let mut i = 0;
        while i < 7 {
            a[i] = rounded(DORMAND_PRINCE.a[i]);
            i += 1;
        }
        let Pair { c, e, d, .. } = DORMAND_PRINCE;
        Pair { a, c: rounded(c), e: rounded(e), d: rounded(d) }
    };
}

/// Each number to the nearest f32, at compile time.
const fn rounded<const N: usize>(exact: [f64; N]) -> [f32; N] {
    let mut near = [0.0; N];
    let mut i = 0;
    while i < N {
        near[i] = exact[i] as f32;
        i += 1;
    }
    near
}
