//! A scalar that computes in f64 and counts its operations: run a program on it and read the cost.
//!
//! An operation is one of + - * / sqrt sin cos; negation is free; the other functions, which reference
//! models do not use, are counted apart. The counters are global, so [`count`] admits one caller at
//! a time; arithmetic on [`Counting`] outside it is added to whoever is counting.

use super::{Real, Scalar};
use core::ops::{Add, Div, Mul, Neg, Sub};
use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// A number whose operations are counted.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Counting(
    /// The value.
    pub f64,
);

/// How many operations of each kind were executed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub add: usize,
    /// Multiplications.
    pub mul: usize,
    /// Divisions.
    pub div: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Sines.
    pub sin: usize,
    /// Cosines.
    pub cos: usize,
    /// Every other function; not in [`Operations::total`].
    pub other: usize,
}

impl Operations {
    /// + - * / sqrt sin cos, one each.
    #[must_use]
    pub fn total(&self) -> usize {
        self.add + self.mul + self.div + self.sqrt + self.sin + self.cos
    }
}

static BUSY: AtomicBool = AtomicBool::new(false);
static ADD: AtomicUsize = AtomicUsize::new(0);
static MUL: AtomicUsize = AtomicUsize::new(0);
static DIV: AtomicUsize = AtomicUsize::new(0);
static SQRT: AtomicUsize = AtomicUsize::new(0);
static SIN: AtomicUsize = AtomicUsize::new(0);
static COS: AtomicUsize = AtomicUsize::new(0);
static OTHER: AtomicUsize = AtomicUsize::new(0);

/// Runs `program` and returns its result and what it cost. Waits while another thread counts.
/// Must not be nested: the inner call would wait for ever.
pub fn count<R>(program: impl FnOnce() -> R) -> (R, Operations) {
    while BUSY.compare_exchange_weak(false, true, Ordering::Acquire, Ordering::Relaxed).is_err() {
        core::hint::spin_loop();
    }
    let _release = Release;
    let before = read();
    let result = program();
    let after = read();
    let cost = Operations {
        add: after.add - before.add,
        mul: after.mul - before.mul,
        div: after.div - before.div,
        sqrt: after.sqrt - before.sqrt,
        sin: after.sin - before.sin,
        cos: after.cos - before.cos,
        other: after.other - before.other,
    };
    (result, cost)
}

/// Frees the counters even if the counted program unwinds.
struct Release;

impl Drop for Release {
    fn drop(&mut self) {
        BUSY.store(false, Ordering::Release);
    }
}

fn read() -> Operations {
    let [add, mul, div, sqrt, sin, cos, other] =
        [&ADD, &MUL, &DIV, &SQRT, &SIN, &COS, &OTHER].map(|kind| kind.load(Ordering::Relaxed));
    Operations { add, mul, div, sqrt, sin, cos, other }
}

fn one_more(kind: &AtomicUsize) {
    kind.fetch_add(1, Ordering::Relaxed);
}

fn other(value: f64) -> Counting {
    one_more(&OTHER);
    Counting(value)
}

macro_rules! operator {
    ($trait:ident, $method:ident, $op:tt, $kind:ident) => {
        impl $trait for Counting {
            type Output = Counting;
            fn $method(self, right: Counting) -> Counting {
                one_more(&$kind);
                Counting(self.0 $op right.0)
            }
        }
    };
}

operator!(Add, add, +, ADD);
operator!(Sub, sub, -, ADD);
operator!(Mul, mul, *, MUL);
operator!(Div, div, /, DIV);

impl Neg for Counting {
    type Output = Counting;
    fn neg(self) -> Counting {
        Counting(-self.0)
    }
}

impl Real for Counting {
    const ZERO: Counting = Counting(0.0);
    const ONE: Counting = Counting(1.0);
    fn from_f64(x: f64) -> Counting {
        Counting(x)
    }
    fn sqrt(self) -> Counting {
        one_more(&SQRT);
        Counting(Real::sqrt(self.0))
    }
    fn sin_cos(self) -> (Counting, Counting) {
        one_more(&SIN);
        one_more(&COS);
        let (s, c) = Real::sin_cos(self.0);
        (Counting(s), Counting(c))
    }
    /// Counted as one subtraction, one sine, one cosine; the work that keeps it accurate is not counted.
    fn sin_cos_of_difference(a: Counting, b: Counting) -> (Counting, Counting) {
        for kind in [&ADD, &SIN, &COS] {
            one_more(kind);
        }
        let (s, c) = Real::sin_cos_of_difference(a.0, b.0);
        (Counting(s), Counting(c))
    }
    fn tan(self) -> Counting {
        other(Real::tan(self.0))
    }
    fn asin(self) -> Counting {
        other(Real::asin(self.0))
    }
    fn acos(self) -> Counting {
        other(Real::acos(self.0))
    }
    fn atan2(self, x: Counting) -> Counting {
        other(Real::atan2(self.0, x.0))
    }
    fn exp(self) -> Counting {
        other(Real::exp(self.0))
    }
    fn ln(self) -> Counting {
        other(Real::ln(self.0))
    }
    fn tanh(self) -> Counting {
        other(Real::tanh(self.0))
    }
    fn abs(self) -> Counting {
        other(Real::abs(self.0))
    }
    fn sign(self) -> Counting {
        other(Real::sign(self.0))
    }
    fn min(self, right: Counting) -> Counting {
        other(Real::min(self.0, right.0))
    }
    fn max(self, right: Counting) -> Counting {
        other(Real::max(self.0, right.0))
    }
    fn min_size(self, right: Counting) -> Counting {
        other(Real::min_size(self.0, right.0))
    }
    fn max_size(self, right: Counting) -> Counting {
        other(Real::max_size(self.0, right.0))
    }
}

/// Comparisons are free.
impl Scalar for Counting {
    const EPSILON: Counting = Counting(f64::EPSILON);
    const ROOT_EPSILON: Counting = Counting(f64::ROOT_EPSILON);
    const FAR: Counting = Counting(f64::FAR);
    const LARGEST_ANGLE: Counting = Counting(<f64 as Scalar>::LARGEST_ANGLE);
    const TURN: [Counting; 3] = {
        let [a, b, c] = <f64 as Scalar>::TURN;
        [Counting(a), Counting(b), Counting(c)]
    };
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    fn to_f64(self) -> f64 {
        self.0
    }
    fn turns(self) -> Counting {
        other(Scalar::turns(self.0))
    }
}
