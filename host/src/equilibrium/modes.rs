//! Modes: eigenvalues and shapes of small motions about an equilibrium, dx' = A dx.
//!
//! In: A with bounds of its errors, and directions Z in which the state can change (orthonormal columns: across Euler
//! parameters, which keep their unit length). Out: one mode per real eigenvalue of Z'AZ or complex pair (`spectrum`),
//! the fastest first, with its shape (`shapes`). What is within an eigenvalue's own rounding is 0, however fast others
//! are.

use super::search::Slopes;
use super::shapes;
use super::spectrum::{self, Eigenvalue};
use nalgebra::{Complex, ComplexField, DMatrix};

/// Rounding of the products with Z, in epsilons of their terms.
const PRODUCTS: f64 = 4.0;
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
    /// whose motions often form a space of more than one dimension, and where a repeated eigenvalue has fewer shapes:
    /// the motion is then t times one of these, besides others.
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

/// The modes of a system; `None` if the iteration does not converge. `errors` bounds the rounding errors of A.
pub(super) fn of(slopes: &Slopes, errors: &DMatrix<f64>, names: &[String]) -> Option<Vec<Mode>> {
    let z = &slopes.directions;
    let a = z.transpose() * &slopes.a * z;
    if a.is_empty() {
        return Some(Vec::new());
    }
    let (sizes, along) = (slopes.a.abs() * PRODUCTS * f64::EPSILON, z.abs());
    let errors = along.transpose() * (errors + sizes) * along;
    let mut found = spectrum::of(&a, &errors)?;
    found.iter_mut().for_each(clean);
    found.retain(|eigenvalue| eigenvalue.value.im >= 0.0);
    // Half of the digits: what rounding tells apart counts as equally fast, and what grows comes first.
    let speed = |e: &Eigenvalue| (e.value.modulus() as f32, e.value.re as f32);
    found.sort_by(|a, b| {
        let ((fast, up), (faster, upper)) = (speed(a), speed(b));
        faster.total_cmp(&fast).then(upper.total_cmp(&up))
    });
    let mut modes: Vec<Mode> = found.iter().map(mode).collect();
    for cluster in clusters(&found) {
        let mean = cluster.iter().map(|&i| found[i].value).sum::<Complex<f64>>() / cluster.len() as f64;
        let shapes = shapes::of(&a, z, mean, cluster.len());
        cluster.iter().zip(shapes).for_each(|(&i, shape)| modes[i].shape = named(&shape, names));
    }
    Some(modes)
}

/// Indices of eigenvalues other than 0 that are the same within their bounds.
fn clusters(found: &[Eigenvalue]) -> Vec<Vec<usize>> {
    let mut clusters: Vec<Vec<usize>> = Vec::new();
    for (i, own) in found.iter().enumerate().filter(|(_, own)| own.value.modulus() > 0.0) {
        let same = |cluster: &&mut Vec<usize>| {
            let first = &found[cluster[0]];
            (own.value - first.value).modulus() <= own.bound + first.bound
        };
        match clusters.iter_mut().find(same) {
            Some(cluster) => cluster.push(i),
            None => clusters.push(vec![i]),
        }
    }
    clusters
}

/// Parts of an eigenvalue within its bound are 0.
fn clean(eigenvalue: &mut Eigenvalue) {
    let Eigenvalue { value, bound } = eigenvalue;
    if value.modulus() <= *bound {
        *value = Complex::new(0.0, 0.0);
    }
    if value.im.abs() <= *bound {
        value.im = 0.0;
    }
}

fn mode(eigenvalue: &Eigenvalue) -> Mode {
    let fate = match eigenvalue.value.re {
        re if re.abs() <= eigenvalue.bound => Fate::Persists,
        re if re < 0.0 => Fate::Decays,
        _ => Fate::Grows,
    };
    Mode { eigenvalue: eigenvalue.value, fate, shape: Vec::new() }
}

fn named(shape: &[Complex<f64>], names: &[String]) -> Vec<(String, f64, f64)> {
    let phase = |x: &Complex<f64>| match x.im == 0.0 && x.re < 0.0 {
        true => std::f64::consts::PI,
        false => x.argument(),
    };
    let parts = shape.iter().zip(names).map(|(x, name)| (name.clone(), x.modulus(), phase(x)));
    parts.filter(|(_, size, _)| *size > SMALL).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Modes of a matrix without errors.
    fn exact(rows: &[f64], n: usize) -> Vec<Mode> {
        let slopes = Slopes {
            a: DMatrix::from_row_slice(n, n, rows),
            b: DMatrix::zeros(n, 0),
            directions: DMatrix::identity(n, n),
        };
        let names: Vec<String> = (0..n).map(|i| format!("x{i}")).collect();
        of(&slopes, &DMatrix::zeros(n, n), &names).expect("modes")
    }

    #[test]
    fn a_damped_oscillator_has_its_frequency_and_damping() {
        // x'' + 2 zeta w x' + w^2 x = 0 with w = 3, zeta = 0.1.
        let modes = exact(&[0.0, 1.0, -9.0, -0.6], 2);
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
    fn a_slow_motion_beside_a_fast_one_is_told() {
        // x'' = x/4, driven by what decays at 1e13/s; undamped as it is, the pair 2i stays so.
        let mut rows = [0.0; 25];
        (rows[1], rows[5], rows[9]) = (1.0, 0.25, 3.0);
        (rows[13], rows[17], rows[24]) = (1.0, -4.0, -1e13);
        let modes = exact(&rows, 5);
        let told: Vec<(f64, f64, Fate)> =
            modes.iter().map(|m| (m.eigenvalue.re, m.eigenvalue.im, m.fate)).collect();
        let slow = [(0.0, 2.0, Fate::Persists), (0.5, 0.0, Fate::Grows), (-0.5, 0.0, Fate::Decays)];
        assert_eq!(told[0], (-1e13, 0.0, Fate::Decays));
        for ((re, im, fate), expected) in told[1..].iter().zip(slow) {
            assert!((re - expected.0).abs() < 1e-15 && (im - expected.1).abs() < 1e-15, "{told:?}");
            assert_eq!(*fate, expected.2, "{told:?}");
        }
    }

    #[test]
    fn a_repeated_eigenvalue_has_no_more_shapes_than_directions() {
        let modes = exact(&[-2.0, 1.0, 0.0, -2.0], 2);
        assert_eq!(modes[0].shape, [("x0".to_owned(), 1.0, 0.0)]);
        assert!(modes[1].shape.is_empty(), "{modes:?}");
    }

    #[test]
    fn what_nothing_brings_back_is_neutral() {
        // A double zero and a growing motion.
        let modes = exact(&[0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0], 3);
        let fates: Vec<Fate> = modes.iter().map(|mode| mode.fate).collect();
        assert_eq!(fates, [Fate::Grows, Fate::Persists, Fate::Persists]);
    }
}
