//! Coordinates that a constraint ties to unit length: Euler parameters, components of a unit vector.
//!
//! In: the residuals of the constraints. Out: which coordinates these are, whatever frame they turn, and random ones,
//! uniform on the sphere within their ranges. A residual states unit length if it is c (sum of squares - 1).

use super::random::Random;
use crate::expr::{Dag, ExprId, SymbolId};

/// Numbers drawn to find out whether a residual states unit length.
const TRIALS: usize = 3;
/// A residual that differs by less than this share of its terms is the same.
const SAME: f64 = 1e-12;
/// Most draws of one vector whose components are within their ranges.
const DRAWS: usize = 1000;
/// Vectors shorter than this are drawn again: their directions are rounded coarsely.
const SHORT: f64 = 1e-3;

/// The places of the coordinates of each unit vector.
#[derive(Clone, Debug, Default)]
pub(super) struct UnitVectors(Vec<Vec<usize>>);

impl UnitVectors {
    /// Those that the residuals state, disjoint; `coordinates` are the symbols in the order of the places.
    pub fn find(dag: &Dag, residuals: &[ExprId], coordinates: &[SymbolId]) -> Self {
        let mut found = Self::default();
        for &residual in residuals {
            let symbols = dag.symbols_of(residual);
            let places = symbols.iter().map(|s| coordinates.iter().position(|c| c == s));
            let Some(places) = places.collect::<Option<Vec<usize>>>() else { continue };
            let is_new = places.iter().all(|&place| !found.contain(place));
            if places.len() > 1 && is_new && states_unit_length(dag, residual, &symbols) {
                found.0.push(places);
            }
        }
        found
    }

    /// Those for whose places this holds.
    pub fn of(mut self, wanted: impl Fn(&[usize]) -> bool) -> Self {
        self.0.retain(|places| wanted(places));
        self
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The places of the components of each.
    pub fn places(&self) -> &[Vec<usize>] {
        &self.0
    }

    /// Is the coordinate a component of one of them?
    pub fn contain(&self, place: usize) -> bool {
        self.0.iter().any(|places| places.contains(&place))
    }

    /// Scales the components that are not given so that the length is 1; leaves them where no scale does it.
    pub fn complete(&self, q: &mut [f64], is_given: impl Fn(usize) -> bool) {
        for places in &self.0 {
            let squares = |given: bool, q: &[f64]| -> f64 {
                places.iter().filter(|&&i| is_given(i) == given).map(|&i| q[i] * q[i]).sum()
            };
            let scale = ((1.0 - squares(true, q)) / squares(false, q)).sqrt();
            if scale.is_finite() && scale != 1.0 {
                places.iter().filter(|&&i| !is_given(i)).for_each(|&i| q[i] *= scale);
            }
        }
    }

    /// Sets the independent components in `target` to those of random unit vectors within their ranges (`ranges`: by
    /// coordinate, whether it is independent, and its range); to nominal ones if none is found. If some components
    /// depend on the others, their sign is the nominal one: they cannot pass through 0.
    pub fn draw(
        &self,
        random: &mut Random,
        ranges: &[(bool, (f64, f64))],
        nominal: &[f64],
        target: &mut [f64],
    ) {
        for places in &self.0 {
            let depends = places.iter().any(|&i| !ranges[i].0);
            let drawn = (0..DRAWS).find_map(|_| {
                let vector = unit(random, places.iter().map(|&i| ranges[i].1))?;
                let along: f64 = places.iter().zip(&vector).map(|(&i, x)| nominal[i] * x).sum();
                let sign = if depends && along < 0.0 { -1.0 } else { 1.0 };
                let vector: Vec<f64> = vector.iter().map(|x| sign * x).collect();
                let fits = |(&i, x): (&usize, &f64)| (ranges[i].1.0..=ranges[i].1.1).contains(x);
                places.iter().zip(&vector).all(fits).then_some(vector)
            });
            let drawn = drawn.unwrap_or_else(|| places.iter().map(|&i| nominal[i]).collect());
            places.iter().zip(drawn).filter(|(i, _)| ranges[**i].0).for_each(|(&i, x)| target[i] = x);
        }
    }

    /// Moves the independent components in `target` half the way to the nominal ones.
    pub fn halve(&self, ranges: &[(bool, (f64, f64))], nominal: &[f64], target: &mut [f64]) {
        for places in &self.0 {
            let own = || places.iter().copied().filter(|&i| ranges[i].0);
            own().for_each(|i| target[i] = 0.5 * (nominal[i] + target[i]));
            if own().count() == places.len() {
                let length = places.iter().map(|&i| target[i] * target[i]).sum::<f64>().sqrt();
                own().for_each(|i| target[i] /= length);
            }
        }
    }
}

/// A random unit vector near the box of these ranges: uniform on the sphere if they contain [-1, 1]. `None` if the draw
/// is outside the ball.
fn unit(random: &mut Random, ranges: impl Iterator<Item = (f64, f64)>) -> Option<Vec<f64>> {
    let vector: Vec<f64> =
        ranges.map(|(low, high)| random.between((low.clamp(-1.0, 1.0), high.clamp(-1.0, 1.0)))).collect();
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    (SHORT < length && length <= 1.0).then(|| vector.iter().map(|x| x / length).collect())
}

/// Is the residual a multiple of the sum of the squares less 1? Tried with numbers.
fn states_unit_length(dag: &Dag, residual: ExprId, symbols: &[SymbolId]) -> bool {
    let value = |numbers: &[f64]| {
        let of = |s: SymbolId| symbols.iter().position(|own| *own == s).map_or(f64::NAN, |i| numbers[i]);
        dag.evaluate(&[residual], &of)[0]
    };
    let factor = -value(&vec![0.0; symbols.len()]);
    let mut random = Random(0x0E0E_1234_5678);
    factor != 0.0
        && (0..TRIALS).all(|_| {
            let numbers: Vec<f64> = symbols.iter().map(|_| random.between((-1.0, 1.0))).collect();
            let squares = numbers.iter().map(|x| x * x).sum::<f64>();
            (value(&numbers) - factor * (squares - 1.0)).abs() <= SAME * factor.abs() * (squares + 1.0)
        })
}

#[cfg(test)]
mod tests {
    use super::{Random, UnitVectors};

    /// Ranges of four coordinates, all independent.
    fn free(range: (f64, f64)) -> Vec<(bool, (f64, f64))> {
        vec![(true, range); 4]
    }

    fn drawn(ranges: &[(bool, (f64, f64))], count: usize) -> Vec<Vec<f64>> {
        let vectors = UnitVectors(vec![vec![0, 1, 2, 3]]);
        let mut random = Random(1);
        let nominal = [1.0, 0.0, 0.0, 0.0];
        let mut one = || {
            let mut target = nominal.to_vec();
            vectors.draw(&mut random, ranges, &nominal, &mut target);
            target
        };
        (0..count).map(|_| one()).collect()
    }

    #[test]
    fn attitudes_are_uniform() {
        const COUNT: usize = 20_000;
        let all = drawn(&free((-3.0, 3.0)), COUNT);
        for i in 0..4 {
            // On the sphere in four dimensions the mean of x^2 is 1/4, that of x^4 is 1/8.
            let mean = |power| all.iter().map(|e| e[i].powi(power)).sum::<f64>() / COUNT as f64;
            assert!(
                mean(1).abs() < 0.01 && (mean(2) - 0.25).abs() < 0.005 && (mean(4) - 0.125).abs() < 0.005
            );
        }
    }

    #[test]
    fn ranges_are_kept() {
        let mut ranges = free((-0.2, 0.3));
        ranges[0].1 = (0.0, 1.0);
        for e in drawn(&ranges, 200) {
            assert!((e.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
            assert!(e[1..].iter().all(|x| (-0.2..=0.3).contains(x)) && e[0] > 0.8);
        }
        // No unit vector is within these ranges: the nominal one remains.
        assert_eq!(drawn(&free((-0.1, 0.1)), 1), [[1.0, 0.0, 0.0, 0.0]]);
    }

    #[test]
    fn what_is_left_out_completes_the_length() {
        let vectors = UnitVectors(vec![vec![0, 1, 2, 3]]);
        let mut q = [1.0, 0.6, 0.0, 0.0];
        vectors.complete(&mut q, |i| i == 1);
        assert_eq!(q, [0.8, 0.6, 0.0, 0.0]);
        // Nothing is left out, or no scale does it: as given.
        for given in [[true; 4], [false, true, true, true]] {
            let mut q = [0.0, 2.0, 0.0, 0.0];
            vectors.complete(&mut q, |i| given[i]);
            assert_eq!(q, [0.0, 2.0, 0.0, 0.0]);
        }
    }
}
