//! The Hessian of a sheet's free nodes, factored: a band, and one rank more where gas is sealed.
//!
//! In: the band's factor K, the volume's gradient g and c = -dp/dV. Out: solutions by
//! (K + c g g')^-1 b = K^-1 b - K^-1 g c (g . K^-1 b)/(1 + c g . K^-1 g).

use crate::band::Factor;

/// K + c g g'.
#[derive(Clone, Debug)]
pub struct Stiffness {
    band: Factor,
    gas: Option<Gas>,
}

#[derive(Clone, Debug)]
struct Gas {
    /// g.
    volume: Vec<f64>,
    /// K^-1 g c/(1 + c g . K^-1 g).
    share: Vec<f64>,
}

impl Stiffness {
    /// From K, g and c; gas that keeps its pressure has c = 0.
    pub fn new(band: Factor, volume: Vec<f64>, c: f64) -> Stiffness {
        let gas = (c != 0.0).then(|| {
            let mut share = volume.clone();
            band.solve(&mut share);
            let factor = c / (1.0 + c * product(&volume, &share));
            share.iter_mut().for_each(|x| *x *= factor);
            Gas { volume, share }
        });
        Stiffness { band, gas }
    }

    /// Solves for one right side in place.
    pub fn solve(&self, b: &mut [f64]) {
        self.band.solve(b);
        if let Some(gas) = &self.gas {
            let along = product(&gas.volume, b);
            b.iter_mut().zip(&gas.share).for_each(|(x, z)| *x -= along * z);
        }
    }

    /// Solves for several right sides in place.
    pub fn solve_all<const N: usize>(&self, b: &mut [[f64; N]]) {
        self.band.solve_all(b);
        if let Some(gas) = &self.gas {
            for k in 0..N {
                let along: f64 = gas.volume.iter().zip(&*b).map(|(g, x)| g * x[k]).sum();
                b.iter_mut().zip(&gas.share).for_each(|(x, z)| x[k] -= along * z);
            }
        }
    }
}

/// Dot product.
pub fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
