//! Expressions of a drawn mechanism: a tree that is written as text and evaluated over jets.
//!
//! Names are places in the description's lists. A jet of level 1 (a velocity) has no second derivative.

use super::posture::Posture;
use crate::newton_euler::jet::{Jet, JetVector};
use nalgebra::Vector3;
use std::ops::{Add, Mul, Sub};

/// Functions of one number: name in the language.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Square root.
    Sqrt,
    /// Exponential function.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value.
    Abs,
    /// -1, 0 or 1.
    Sign,
}

/// Functions of two numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Pair {
    /// Angle of the point (second, first).
    Atan2,
    /// The smaller.
    Min,
    /// The larger.
    Max,
    /// 0 below -width, 1 above width, cubic between.
    SmoothStep,
}

/// A number.
#[derive(Clone, PartialEq, Debug)]
pub enum Scalar {
    /// A literal with its unit, which may be empty.
    Literal(f64, &'static str),
    /// A parameter.
    Parameter(usize),
    /// An input.
    Input(usize),
    /// A coordinate.
    Coordinate(usize),
    /// A speed by its name.
    Speed(usize),
    /// The rate of a coordinate: `q_dot(q)`.
    Rate(usize),
    /// A definition of a number.
    Definition(usize),
    /// Time.
    Time,
    /// a + b.
    Sum(Box<Self>, Box<Self>),
    /// a - b.
    Difference(Box<Self>, Box<Self>),
    /// a b.
    Product(Box<Self>, Box<Self>),
    /// a / b.
    Quotient(Box<Self>, Box<Self>),
    /// f(a).
    Call(Function, Box<Self>),
    /// f(a, b).
    CallTwo(Pair, Box<Self>, Box<Self>),
    /// Integer power.
    Power(Box<Self>, i32),
    /// Scalar product.
    Dot(Box<Vector>, Box<Vector>),
    /// Length.
    Norm(Box<Vector>),
}

/// A vector.
#[derive(Clone, PartialEq, Debug)]
pub enum Vector {
    /// Unit vector 0, 1, 2 of a frame.
    Axis(usize, usize),
    /// A point's place.
    Point(usize),
    /// A definition of a vector.
    Definition(usize),
    /// Velocity of a point.
    Velocity(usize),
    /// Angular velocity of a frame.
    AngularVelocity(usize),
    /// a + b.
    Sum(Box<Self>, Box<Self>),
    /// a - b.
    Difference(Box<Self>, Box<Self>),
    /// s a.
    Scaled(Box<Scalar>, Box<Self>),
    /// Vector product.
    Cross(Box<Self>, Box<Self>),
}

/// A number or a vector.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// A number.
    Scalar(Scalar),
    /// A vector.
    Vector(Vector),
}

impl Scalar {
    /// A literal without unit.
    #[must_use]
    pub fn number(value: f64) -> Self {
        Self::Literal(value, "")
    }

    /// f(self).
    #[must_use]
    pub fn call(self, function: Function) -> Self {
        Self::Call(function, Box::new(self))
    }

    /// The number and its rates.
    #[must_use]
    pub fn at(&self, posture: &Posture<'_>) -> Jet {
        match self {
            Self::Literal(value, unit) => Jet::constant(value * si(unit)),
            Self::Parameter(i) => Jet::constant(posture.parameters[*i]),
            Self::Input(i) => Jet::constant(posture.inputs[*i]),
            Self::Coordinate(i) => posture.q[*i],
            Self::Rate(i) => posture.q[*i].derivative(),
            Self::Speed(i) => posture.description.speeds[*i].value.at(posture),
            Self::Definition(i) => posture.scalars[*i],
            Self::Time => posture.t,
            Self::Sum(a, b) => a.at(posture) + b.at(posture),
            Self::Difference(a, b) => a.at(posture) - b.at(posture),
            Self::Product(a, b) => a.at(posture) * b.at(posture),
            Self::Quotient(a, b) => a.at(posture) * power(b.at(posture), -1),
            Self::Call(function, a) => function.of(a.at(posture)),
            Self::CallTwo(pair, a, b) => pair.of(a.at(posture), b.at(posture)),
            Self::Power(a, n) => power(a.at(posture), *n),
            Self::Dot(a, b) => a.at(posture).dot(&b.at(posture)),
            Self::Norm(a) => {
                let vector = a.at(posture);
                Function::Sqrt.of(vector.dot(&vector))
            }
        }
    }
}

impl Vector {
    /// s self.
    #[must_use]
    pub fn scaled(self, by: Scalar) -> Self {
        Self::Scaled(Box::new(by), Box::new(self))
    }

    /// self . other.
    #[must_use]
    pub fn dot(self, other: Self) -> Scalar {
        Scalar::Dot(Box::new(self), Box::new(other))
    }

    /// self x other.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::Cross(Box::new(self), Box::new(other))
    }

    /// |self|.
    #[must_use]
    pub fn norm(self) -> Scalar {
        Scalar::Norm(Box::new(self))
    }

    /// The vector and its rates.
    #[must_use]
    pub fn at(&self, posture: &Posture<'_>) -> JetVector {
        match self {
            Self::Axis(frame, axis) => posture.frames[*frame][*axis],
            Self::Point(i) => posture.points[*i],
            Self::Definition(i) => posture.vectors[*i],
            Self::Velocity(i) => posture.points[*i].derivative(),
            Self::AngularVelocity(i) => posture.angular_velocity(*i),
            Self::Sum(a, b) => a.at(posture) + b.at(posture),
            Self::Difference(a, b) => a.at(posture) - b.at(posture),
            Self::Scaled(s, a) => a.at(posture).scale(s.at(posture)),
            Self::Cross(a, b) => a.at(posture).cross(&b.at(posture)),
        }
    }
}

impl Value {
    /// One number, or three components along N.
    #[must_use]
    pub fn rows(&self, posture: &Posture<'_>) -> Vec<Jet> {
        match self {
            Self::Scalar(scalar) => vec![scalar.at(posture)],
            Self::Vector(vector) => vector.at(posture).components().to_vec(),
        }
    }
}

/// What one of a unit is in SI; only those that are not coherent need a line.
pub(super) fn si(unit: &str) -> f64 {
    match unit {
        "deg" => std::f64::consts::PI / 180.0,
        "mm" => 1e-3,
        _ => 1.0,
    }
}

/// x^n with its rates.
fn power(x: Jet, n: i32) -> Jet {
    let (v, order) = (x.value, f64::from(n));
    x.chain(v.powi(n), order * v.powi(n - 1), order * (order - 1.0) * v.powi(n - 2))
}

impl Function {
    /// f, f' and f'' at a value, chained.
    fn of(self, x: Jet) -> Jet {
        let v = x.value;
        let root = (1.0 - v * v).max(0.0).sqrt();
        let [f, df, ddf] = match self {
            Self::Sin => [v.sin(), v.cos(), -v.sin()],
            Self::Cos => [v.cos(), -v.sin(), -v.cos()],
            Self::Tan => [v.tan(), 1.0 + v.tan().powi(2), 2.0 * v.tan() * (1.0 + v.tan().powi(2))],
            Self::Asin => [v.asin(), 1.0 / root, v / root.powi(3)],
            Self::Acos => [v.acos(), -1.0 / root, -v / root.powi(3)],
            Self::Sqrt => [v.sqrt(), 0.5 / v.sqrt(), -0.25 / (v * v.sqrt())],
            Self::Exp => [v.exp(); 3],
            Self::Ln => [v.ln(), 1.0 / v, -1.0 / (v * v)],
            Self::Tanh => {
                let slope = 1.0 - v.tanh().powi(2);
                [v.tanh(), slope, -2.0 * v.tanh() * slope]
            }
            Self::Abs => [v.abs(), v.signum(), 0.0],
            Self::Sign => [v.signum(), 0.0, 0.0],
        };
        x.chain(f, df, ddf)
    }
}

impl Pair {
    /// The value with its rates where it has some.
    fn of(self, a: Jet, b: Jet) -> Jet {
        match self {
            // Loads and outputs alone read it: its rates are not asked for.
            Self::Atan2 => Jet::constant(a.value.atan2(b.value)),
            Self::Min => {
                if a.value <= b.value {
                    a
                } else {
                    b
                }
            }
            Self::Max => {
                if a.value >= b.value {
                    a
                } else {
                    b
                }
            }
            Self::SmoothStep => {
                let s = ((a.value + b.value) / (2.0 * b.value)).clamp(0.0, 1.0);
                Jet::constant(s * s * (3.0 - 2.0 * s))
            }
        }
    }
}

macro_rules! operators {
    ($kind:ident) => {
        impl Add for $kind {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Self::Sum(Box::new(self), Box::new(other))
            }
        }
        impl Sub for $kind {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                Self::Difference(Box::new(self), Box::new(other))
            }
        }
    };
}
operators!(Scalar);
operators!(Vector);

impl Mul for Scalar {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::Product(Box::new(self), Box::new(other))
    }
}

/// Unit vectors of N.
#[must_use]
pub fn inertial() -> [JetVector; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()].map(JetVector::constant)
}
