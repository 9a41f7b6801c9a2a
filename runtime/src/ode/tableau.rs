//! Coefficients of the explicit methods, each beside its source: for x' = f(t, x) and for x'' = a(x, v).
//!
//! Written as fractions in f64 and rounded to every scalar at compile time ([`Tableau::rounded()`]): a machine
//! without double precision never converts them.
//! A Runge-Kutta method (a, b) of the first-order system becomes abar = a a, bbar = b a in Nystrom's form, which needs
//! stage velocities only where forces depend on speeds. `error` and `coarse` are weights of error estimates (0: none).

use crate::real::Constant;

/// An explicit method with N stages, in Runge and Kutta's form and in Nystrom's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tableau<T, const N: usize> {
    /// Times of the stages.
    pub c: [T; N],
    /// Weights of the starting velocity in the stage positions: sums of the rows of `a`, as rounded.
    pub drift: [T; N],
    /// Weights of the stage accelerations in the stage velocities.
    pub a: [[T; N]; N],
    /// Weights of the stage accelerations in the stage positions.
    pub abar: [[T; N]; N],
    /// Weights of the stage accelerations in the new velocity.
    pub b: [T; N],
    /// Weights of the stage accelerations in the new position.
    pub bbar: [T; N],
    /// Weights of the error estimate.
    pub error: Weights<T, N>,
    /// Weights of a second, coarser estimate.
    pub coarse: Weights<T, N>,
}

/// Weights of one combination of the stages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights<T, const N: usize> {
    /// In the velocity.
    pub b: [T; N],
    /// In the position.
    pub bbar: [T; N],
}

impl<const N: usize> Tableau<f64, N> {
    /// Every coefficient rounded to every scalar.
    #[must_use]
    pub const fn rounded(self) -> Tableau<Constant, N> {
        Tableau {
            c: row(self.c),
            drift: row(self.drift),
            a: rows(self.a),
            abar: rows(self.abar),
            b: row(self.b),
            bbar: row(self.bbar),
            error: Weights { b: row(self.error.b), bbar: row(self.error.bbar) },
            coarse: Weights { b: row(self.coarse.b), bbar: row(self.coarse.bbar) },
        }
    }
}

/// Numbers rounded to every scalar.
pub(crate) const fn row<const N: usize>(numbers: [f64; N]) -> [Constant; N] {
    let mut rounded = [Constant::new(0.0); N];
    let mut i = 0;
    while i < N {
        rounded[i] = Constant::new(numbers[i]);
        i += 1;
    }
    rounded
}

const fn rows<const N: usize>(numbers: [[f64; N]; N]) -> [[Constant; N]; N] {
    let mut rounded = [[Constant::new(0.0); N]; N];
    let mut i = 0;
    while i < N {
        rounded[i] = row(numbers[i]);
        i += 1;
    }
    rounded
}

/// x a, for a strictly lower triangular a.
const fn times<const N: usize>(x: &[f64; N], a: &[[f64; N]; N]) -> [f64; N] {
    let mut product = [0.0; N];
    let mut j = 0;
    while j < N {
        let mut l = 0;
        while l < j {
            product[l] += x[j] * a[j][l];
            l += 1;
        }
        j += 1;
    }
    product
}

/// Nystrom form of the Runge-Kutta method (a, b) with error weights.
const fn from_runge_kutta<const N: usize>(
    a: [[f64; N]; N],
    b: [f64; N],
    error: [f64; N],
    coarse: [f64; N],
) -> Tableau<f64, N> {
    let mut drift = [0.0; N];
    let mut abar = [[0.0; N]; N];
    let mut i = 0;
    while i < N {
        abar[i] = times(&a[i], &a);
        let mut j = 0;
        while j < i {
            drift[i] += a[i][j];
            j += 1;
        }
        i += 1;
    }
    Tableau {
        c: drift,
        drift,
        a,
        abar,
        b,
        bbar: times(&b, &a),
        error: Weights { b: error, bbar: times(&error, &a) },
        coarse: Weights { b: coarse, bbar: times(&coarse, &a) },
    }
}

/// Nystrom form of a splitting kick b_1 drift a_1 kick b_2 ... kick b_N.
const fn from_splitting<const N: usize>(b: [f64; N], drift: [f64; N]) -> Tableau<f64, N> {
    let mut c = [0.0; N];
    let mut a = [[0.0; N]; N];
    let mut abar = [[0.0; N]; N];
    let mut bbar = [0.0; N];
    let mut i = 1;
    while i < N {
        c[i] = c[i - 1] + drift[i - 1];
        let mut j = 0;
        while j < i {
            a[i][j] = b[j];
            abar[i][j] = b[j] * (c[i] - c[j]);
            j += 1;
        }
        i += 1;
    }
    let mut j = 0;
    while j < N {
        bbar[j] = b[j] * (1.0 - c[j]);
        j += 1;
    }
    let none = Weights { b: [0.0; N], bbar: [0.0; N] };
    Tableau { c, drift: c, a, abar, b, bbar, error: none, coarse: none }
}

const BM_A1: f64 = 0.245298957184271;
const BM_A2: f64 = 0.604872665711080;
const BM_A3: f64 = 0.5 - (BM_A1 + BM_A2);
const BM_B1: f64 = 0.0829844064174052;
const BM_B2: f64 = 0.396309801498368;
const BM_B3: f64 = -0.0390563049223486;
const BM_B4: f64 = 1.0 - 2.0 * (BM_B1 + BM_B2 + BM_B3);

/// Kicks of Blanes & Moan (2002), six-stage symplectic splitting of order 4 for x'' = a(x), in parts of a step.
pub const BLANES_MOAN_KICKS: [f64; 7] = [BM_B1, BM_B2, BM_B3, BM_B4, BM_B3, BM_B2, BM_B1];
/// Its drifts, each behind the kick of the same number.
pub const BLANES_MOAN_DRIFTS: [f64; 7] = [BM_A1, BM_A2, BM_A3, BM_A3, BM_A2, BM_A1, 0.0];
/// The same in Nystrom's form.
pub const BLANES_MOAN_4: Tableau<f64, 7> = from_splitting(BLANES_MOAN_KICKS, BLANES_MOAN_DRIFTS);

/// Nystrom (1925), order 4 for x'' = a(x); where forces depend on speeds, its stage velocities are of order 2 only.
pub const NYSTROM_4: Tableau<f64, 3> = Tableau {
    c: [0.0, 0.5, 1.0],
    drift: [0.0, 0.5, 1.0],
    a: [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 1.0, 0.0]],
    abar: [[0.0; 3], [0.125, 0.0, 0.0], [0.0, 0.5, 0.0]],
    b: [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0],
    bbar: [1.0 / 6.0, 2.0 / 6.0, 0.0],
    error: Weights { b: [0.0; 3], bbar: [0.0; 3] },
    coarse: Weights { b: [0.0; 3], bbar: [0.0; 3] },
};

/// Kutta (1901), order 4.
pub const RK4: Tableau<f64, 4> = from_runge_kutta(
    [[0.0; 4], [0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
    [1.0 / 6.0, 2.0 / 6.0, 2.0 / 6.0, 1.0 / 6.0],
    [0.0; 4],
    [0.0; 4],
);

/// Dormand & Prince (1980), order 5 with embedded order 4.
pub const DORMAND_PRINCE: Tableau<f64, 7> = Tableau {
    c: [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
    ..from_runge_kutta(
        [
            [0.0; 7],
            [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
            [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0, 0.0],
            [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0, 0.0],
            [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0],
        ],
        [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0],
        [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0],
        [0.0; 7],
    )
};

/// Weights of the last term of the continuous extension of order 4 of [`DORMAND_PRINCE`]: Hairer, Norsett & Wanner,
/// Solving Ordinary Differential Equations I, 2nd ed. (1993), II.6 (code DOPRI5).
pub const DORMAND_PRINCE_DENSE: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. (1993), II.5 and II.10:
/// Dormand & Prince 8(5,3); `error` is theirs of order 5, `coarse` of order 3.
pub const DOP853: Tableau<f64, 12> = from_runge_kutta(
    [
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.05260015195876773, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0197250569845379, 0.0591751709536137, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.02958758547680685, 0.0, 0.08876275643042054, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [
            0.2413651341592667,
            0.0,
            -0.8845494793282861,
            0.924834003261792,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.037037037037037035,
            0.0,
            0.0,
            0.17082860872947386,
            0.12546768756682242,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.037109375,
            0.0,
            0.0,
            0.17025221101954405,
            0.06021653898045596,
            -0.017578125,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.03709200011850479,
            0.0,
            0.0,
            0.17038392571223998,
            0.10726203044637328,
            -0.015319437748624402,
            0.008273789163814023,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.6241109587160757,
            0.0,
            0.0,
            -3.3608926294469414,
            -0.868219346841726,
            27.59209969944671,
            20.154067550477894,
            -43.48988418106996,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
        [
            0.47766253643826434,
            0.0,
            0.0,
            -2.4881146199716677,
            -0.590290826836843,
            21.230051448181193,
            15.279233632882423,
            -33.28821096898486,
            -0.020331201708508627,
            0.0,
            0.0,
            0.0,
        ],
        [
            -0.9371424300859873,
            0.0,
            0.0,
            5.186372428844064,
            1.0914373489967295,
            -8.149787010746927,
            -18.52006565999696,
            22.739487099350505,
            2.4936055526796523,
            -3.0467644718982196,
            0.0,
            0.0,
        ],
        [
            2.273310147516538,
            0.0,
            0.0,
            -10.53449546673725,
            -2.0008720582248625,
            -17.9589318631188,
            27.94888452941996,
            -2.8589982771350235,
            -8.87285693353063,
            12.360567175794303,
            0.6433927460157636,
            0.0,
        ],
    ],
    [
        0.054293734116568765,
        0.0,
        0.0,
        0.0,
        0.0,
        4.450312892752409,
        1.8915178993145003,
        -5.801203960010585,
        0.3111643669578199,
        -0.1521609496625161,
        0.20136540080403034,
        0.04471061572777259,
    ],
    [
        0.01312004499419488,
        0.0,
        0.0,
        0.0,
        0.0,
        -1.2251564463762044,
        -0.4957589496572502,
        1.6643771824549864,
        -0.35032884874997366,
        0.3341791187130175,
        0.08192320648511571,
        -0.022355307863886294,
    ],
    [
        -0.18980075407240762,
        0.0,
        0.0,
        0.0,
        0.0,
        4.450312892752409,
        1.8915178993145003,
        -5.801203960010585,
        -0.4226823213237919,
        -0.1521609496625161,
        0.20136540080403034,
        0.02265179219836082,
    ],
);
