//! The factored Hessian of a sheet's free nodes: a band, plus a rank-one term if gas is sealed.
//!
//! In: the band's factor K, the volume's gradient g and c = -dp/dV. Out: solutions by Sherman and Morrison's formula,
//! (K + c g g')^-1 b = K^-1 b - K^-1 g c (g . K^-1 b)/(1 + c g . K^-1 g).

use crate::band::Factor;
use smartbed_runtime::real::Scalar;

/// K + c g g', factored.
#[derive(Clone, Debug)]
pub struct Stiffness<T = f64> {
    band: Factor<T>,
    gas: Option<Gas<T>>,
}

#[derive(Clone, Debug)]
struct Gas<T> {
    /// g.
    volume: Vec<T>,
    /// K^-1 g c/(1 + c g . K^-1 g).
    share: Vec<T>,
}

impl<T: Scalar> Stiffness<T> {
    /// From K, g and c; a gas at regulated pressure has c = 0.
    pub fn new(band: Factor<T>, volume: Vec<T>, c: T) -> Self {
        let gas = (c != T::ZERO).then(|| {
            let mut share = volume.clone();
            band.solve(&mut share);
            let factor = c / (T::ONE + c * product(&volume, &share));
            share.iter_mut().for_each(|x| *x = *x * factor);
            Gas { volume, share }
        });
        Stiffness { band, gas }
    }

    /// Solves in place for one right-hand side.
    pub fn solve(&self, b: &mut [T]) {
        self.band.solve(b);
        if let Some(gas) = &self.gas {
            let along = product(&gas.volume, b);
            b.iter_mut().zip(&gas.share).for_each(|(x, z)| *x = *x - along * *z);
        }
    }

    /// Solves in place for several right-hand sides.
    pub fn solve_all<const N: usize>(&self, b: &mut [[T; N]]) {
        self.band.solve_all(b);
        if let Some(gas) = &self.gas {
            for k in 0..N {
                let along = gas.volume.iter().zip(&*b).fold(T::ZERO, |sum, (g, x)| sum + *g * x[k]);
                b.iter_mut().zip(&gas.share).for_each(|(x, z)| x[k] = x[k] - along * *z);
            }
        }
    }
}

/// Dot product.
pub fn product<T: Scalar>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::ZERO, |sum, (x, y)| sum + *x * *y)
}
