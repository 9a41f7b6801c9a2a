//! Modes: eigenvalues and shapes of small motions about an equilibrium, dx' = A dx.
//!
//! In: A, and directions Z in which the state can change (orthonormal columns: across Euler parameters, which keep their
//! unit length). Out: one mode per real eigenvalue of Z'AZ or complex pair, the fastest first. A shape is Z v, with v the
//! vector of (Z'AZ - lambda) v = 0, found as the right singular vector for the smallest singular value.

use super::search::Slopes;
use nalgebra::linalg::{Schur, balancing};
use nalgebra::{Complex, ComplexField, DMatrix};

/// Most iterations for the eigenvalues.
const SWEEPS: usize = 10_000;
/// Eigenvalues below this fraction of the largest are 0: rounding splits a double zero by the square root of epsilon.
const NEUTRAL: f64 = 1e-6;
/// A real part below this fraction of the eigenvalue is rounding.
const UNDAMPED: f64 = 1e-9;
/// Entries of a shape below this fraction of its largest are left out.
const SMALL: f64 = 1e-6;

/// The behaviour of a small motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fate {
    /// It decays.
    Decays,
    /// It neither decays nor grows.
    Persists,
    /// It grows.
    Grows,
}

/// One mode.
#[derive(Clone, Debug)]
pub(super) struct Mode {
    /// lambda (1/s); of a pair the one with positive imaginary part.
    pub eigenvalue: Complex<f64>,
    /// Its fate.
    pub fate: Fate,
    /// Entries of the state that take part: name, size relative to the largest, phase (rad). Empty for an eigenvalue 0,
    /// whose motions often form a space of more than one dimension.
    pub shape: Vec<(String, f64, f64)>,
}

impl Mode {
    /// Is the eigenvalue 0?
    pub fn is_neutral(&self) -> bool {
        self.eigenvalue == Complex::new(0.0, 0.0)
    }

    /// Frequency (Hz); 0 without oscillation.
    pub fn frequency(&self) -> f64 {
        self.eigenvalue.im / std::f64::consts::TAU
    }

    /// zeta = -Re/|lambda|.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.eigenvalue.modulus();
        if size > 0.0 && self.fate != Fate::Persists { -self.eigenvalue.re / size } else { 0.0 }
    }
}

/// The modes of a system; `None` if the iteration does not converge.
pub(super) fn of(slopes: &Slopes, names: &[String]) -> Option<Vec<Mode>> {
    let z = &slopes.directions;
    let a = z.transpose() * &slopes.a * z;
    let mut balanced = a.clone();
    if balanced.is_empty() {
        return Some(Vec::new());
    }
    balancing::balance_parlett_reinsch(&mut balanced);
    let schur = Schur::try_new(balanced, f64::EPSILON, SWEEPS)?;
    let eigenvalues = schur.complex_eigenvalues();
    let largest = eigenvalues.iter().fold(0.0_f64, |most, l| most.max(l.modulus()));
    let mut modes: Vec<Mode> = Vec::new();
    for value in eigenvalues.iter() {
        let is_zero = value.modulus() <= NEUTRAL * largest;
        if value.im < 0.0 && !is_zero {
            continue;
        }
        let eigenvalue = if is_zero { Complex::new(0.0, 0.0) } else { *value };
        let fate = match eigenvalue.re {
            re if re.abs() <= UNDAMPED * largest => Fate::Persists,
            re if re < 0.0 => Fate::Decays,
            _ => Fate::Grows,
        };
        let shape = if is_zero { Vec::new() } else { shape(&a, z, eigenvalue, names) };
        modes.push(Mode { eigenvalue, fate, shape });
    }
    modes.sort_by(|a, b| b.eigenvalue.modulus().total_cmp(&a.eigenvalue.modulus()));
    Some(modes)
}

fn shape(
    a: &DMatrix<f64>,
    z: &DMatrix<f64>,
    eigenvalue: Complex<f64>,
    names: &[String],
) -> Vec<(String, f64, f64)> {
    let n = a.nrows();
    let shifted = a.map(|x| Complex::new(x, 0.0)) - DMatrix::identity(n, n) * eigenvalue;
    let svd = shifted.svd(false, true);
    let Some(rows) = svd.v_t else { return Vec::new() };
    let (least, _) = svd.singular_values.argmin();
    let vector = z.map(|x| Complex::new(x, 0.0)) * rows.row(least).adjoint();
    let largest =
        vector.iter().copied().max_by(|x, y| x.modulus().total_cmp(&y.modulus())).unwrap_or_default();
    let relative = vector.iter().zip(names).map(|(x, name)| (name.clone(), x / largest));
    let parts = relative.map(|(name, x)| {
        (name, x.modulus(), if x.im == 0.0 && x.re < 0.0 { std::f64::consts::PI } else { x.argument() })
    });
    parts.filter(|(_, size, _)| *size > SMALL).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn system(rows: &[f64], n: usize) -> Slopes {
        Slopes {
            a: DMatrix::from_row_slice(n, n, rows),
            b: DMatrix::zeros(n, 0),
            directions: DMatrix::identity(n, n),
        }
    }

    fn names(n: usize) -> Vec<String> {
        (0..n).map(|i| format!("x{i}")).collect()
    }

    #[test]
    fn a_damped_oscillator_has_its_frequency_and_damping() {
        // x'' + 2 zeta w x' + w^2 x = 0 with w = 3, zeta = 0.1.
        let modes = of(&system(&[0.0, 1.0, -9.0, -0.6], 2), &names(2)).expect("modes");
        let [mode] = modes.as_slice() else { panic!("{modes:?}") };
        assert!((mode.eigenvalue.re + 0.3).abs() < 1e-14, "{mode:?}");
        assert!((mode.frequency() - (9.0_f64 - 0.09).sqrt() / std::f64::consts::TAU).abs() < 1e-14);
        assert!((mode.damping_ratio() - 0.1).abs() < 1e-14);
        assert_eq!(mode.fate, Fate::Decays);
        // v = (1, lambda): the speed is |lambda| times the displacement.
        let size = |name: &str| mode.shape.iter().find(|part| part.0 == name).map(|part| part.1);
        assert!((size("x0").expect("x0") - 1.0 / 3.0).abs() < 1e-12, "{mode:?}");
        assert_eq!(size("x1"), Some(1.0));
    }

    #[test]
    fn what_nothing_brings_back_is_neutral() {
        // A double zero and a growing motion.
        let modes = of(&system(&[0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0], 3), &names(3)).expect("modes");
        let fates: Vec<Fate> = modes.iter().map(|mode| mode.fate).collect();
        assert_eq!(fates, [Fate::Grows, Fate::Persists, Fate::Persists]);
    }
}
