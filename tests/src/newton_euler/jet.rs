//! Second-order jets in time: a quantity with its first and second time derivative.
//!
//! A constraint written once over jets gives its residual, its Jacobian (by unit twists) and its
//! bias acceleration (by zero accelerations); nothing is differentiated by hand except the vector
//! fixed in a body. Products follow Leibniz: (a b)'' = a'' b + 2 a' b' + a b''.

use nalgebra::Vector3;
use std::ops::{Add, Mul, Sub};

/// A scalar with two time derivatives.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Jet {
    /// The value.
    pub value: f64,
    /// Its first time derivative.
    pub rate: f64,
    /// Its second time derivative.
    pub second: f64,
}

/// A vector expressed in the inertial frame, with two time derivatives.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct JetVector {
    /// The value.
    pub value: Vector3<f64>,
    /// Its first time derivative.
    pub rate: Vector3<f64>,
    /// Its second time derivative.
    pub second: Vector3<f64>,
}

impl Jet {
    /// A quantity that does not change.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self { value, rate: 0.0, second: 0.0 }
    }

    /// A quantity with its derivatives.
    #[must_use]
    pub fn new(value: f64, rate: f64, second: f64) -> Self {
        Self { value, rate, second }
    }

    /// The rate as a quantity of its own (its `second` is not known: 0).
    #[must_use]
    pub fn derivative(self) -> Self {
        Self::new(self.rate, self.second, 0.0)
    }

    /// f(x) from f, f' and f'' at the value (chain rule).
    #[must_use]
    pub fn chain(self, f: f64, df: f64, ddf: f64) -> Self {
        Self::new(f, df * self.rate, df * self.second + ddf * self.rate * self.rate)
    }

    /// Reciprocal square root of a positive quantity.
    #[must_use]
    pub fn rsqrt(self) -> Self {
        let f = 1.0 / self.value.sqrt();
        self.chain(f, -0.5 * f / self.value, 0.75 * f / (self.value * self.value))
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.value + o.value, self.rate + o.rate, self.second + o.second)
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.value - o.value, self.rate - o.rate, self.second - o.second)
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(
            self.value * o.value,
            self.rate * o.value + self.value * o.rate,
            self.second * o.value + 2.0 * self.rate * o.rate + self.value * o.second,
        )
    }
}

impl JetVector {
    /// A vector that does not change.
    #[must_use]
    pub fn constant(value: Vector3<f64>) -> Self {
        Self { value, rate: Vector3::zeros(), second: Vector3::zeros() }
    }

    /// Scalar product.
    #[must_use]
    pub fn dot(&self, o: &Self) -> Jet {
        Jet::new(
            self.value.dot(&o.value),
            self.rate.dot(&o.value) + self.value.dot(&o.rate),
            self.second.dot(&o.value) + 2.0 * self.rate.dot(&o.rate) + self.value.dot(&o.second),
        )
    }

    /// Vector product.
    #[must_use]
    pub fn cross(&self, o: &Self) -> Self {
        Self {
            value: self.value.cross(&o.value),
            rate: self.rate.cross(&o.value) + self.value.cross(&o.rate),
            second: self.second.cross(&o.value)
                + 2.0 * self.rate.cross(&o.rate)
                + self.value.cross(&o.second),
        }
    }

    /// The vector times a scalar.
    #[must_use]
    pub fn scale(&self, s: Jet) -> Self {
        Self {
            value: self.value * s.value,
            rate: self.rate * s.value + self.value * s.rate,
            second: self.second * s.value + 2.0 * self.rate * s.rate + self.value * s.second,
        }
    }

    /// The rate as a vector of its own (its `second` is not known: 0).
    #[must_use]
    pub fn derivative(&self) -> Self {
        Self { value: self.rate, rate: self.second, second: Vector3::zeros() }
    }

    /// The unit vector along a vector that is not zero.
    #[must_use]
    pub fn unit(&self) -> Self {
        self.scale(self.dot(self).rsqrt())
    }

    /// Component 0, 1 or 2.
    #[must_use]
    pub fn component(&self, axis: usize) -> Jet {
        Jet::new(self.value[axis], self.rate[axis], self.second[axis])
    }

    /// The three components.
    #[must_use]
    pub fn components(&self) -> [Jet; 3] {
        [self.component(0), self.component(1), self.component(2)]
    }
}

impl Add for JetVector {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, rate: self.rate + o.rate, second: self.second + o.second }
    }
}

impl Sub for JetVector {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, rate: self.rate - o.rate, second: self.second - o.second }
    }
}
