//! A grid of springs that represents a plane sheet of modulus E, thickness t and Poisson's ratio 1/3.
//!
//! A cell with sides a (along x) and b (along y) has springs along its sides and both diagonals, l^2 = a^2 + b^2. Under
//! uniform strain the energy per area is that of an isotropic sheet (C11 = 9/8 E t, C12 = C66 = 3/8 E t) exactly if k_d
//! = 3/8 E t l^2/(2 a b), k_x = (b/a) (9/8 - 3/8 (a/b)^2) E t, and k_y with a and b exchanged. A square cell has k =
//! 3/4 E t, k_d = 3/8 E t; sides beyond 1 : sqrt 3 would need springs of negative stiffness.

use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::Vec3;
use std::fmt;

/// A spring between two nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<T = f64> {
    /// Its ends.
    pub ends: [usize; 2],
    /// Stiffness (N/m).
    pub stiffness: T,
    /// Rest length (m).
    pub rest_length: T,
}

/// The nodes, springs and facets of an unstretched sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice<T = f64> {
    /// Number of cells along x and y.
    pub intervals: [usize; 2],
    /// Lengths along x and y (m).
    pub size: [f64; 2],
    /// Springs.
    pub springs: Vec<Spring<T>>,
}

/// The reason why there is no such sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LatticeError {
    /// Fewer than two cells, or more than 500, along x or y.
    Intervals(usize),
    /// A size or E t is not a positive number.
    Size(f64),
    /// The ratio a/b of a cell's sides is beyond 1 : sqrt 3.
    Aspect(f64),
}

impl fmt::Display for LatticeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LatticeError::Intervals(n) => write!(f, "{n} intervals along a side, expected 2 to 500"),
            LatticeError::Size(x) => write!(f, "a length or E t is {x}, expected a number > 0"),
            LatticeError::Aspect(r) => {
                write!(
                    f,
                    "the sides of a cell are {r:.3} : 1, expected 1 : 1.7 to 1.7 : 1; change the intervals"
                )
            }
        }
    }
}

impl std::error::Error for LatticeError {}

impl Lattice {
    /// A sheet with the membrane stiffness E t (N/m).
    ///
    /// # Errors
    /// [`LatticeError`].
    pub fn new(intervals: [usize; 2], size: [f64; 2], modulus: f64) -> Result<Lattice, LatticeError> {
        if let Some(n) = intervals.iter().find(|n| !(2..=500).contains(*n)) {
            return Err(LatticeError::Intervals(*n));
        }
        if let Some(x) = [size[0], size[1], modulus].iter().find(|x| !(**x > 0.0 && x.is_finite())) {
            return Err(LatticeError::Size(*x));
        }
        let (a, b) = (size[0] / intervals[0] as f64, size[1] / intervals[1] as f64);
        let ratio = a / b;
        if !(1.0 / 1.7..=1.7).contains(&ratio) {
            return Err(LatticeError::Aspect(ratio));
        }
        let along = |r: f64| (9.0 / 8.0 - 3.0 / 8.0 * r * r) / r * modulus;
        let diagonal = 3.0 / 8.0 * modulus * (a * a + b * b) / (2.0 * a * b);
        let mut lattice = Lattice { intervals, size, springs: Vec::new() };
        lattice.fill([along(ratio), along(1.0 / ratio), diagonal], [a, b]);
        Ok(lattice)
    }

    /// Adds springs along x, along y and both diagonals; a spring on the rim belongs to one cell and has half the
    /// stiffness.
    fn fill(&mut self, [k_x, k_y, k_d]: [f64; 3], [a, b]: [f64; 2]) {
        let [nx, ny] = self.intervals;
        let mut add = |from: usize, to: usize, stiffness: f64, rest_length: f64| {
            self.springs.push(Spring { ends: [from, to], stiffness, rest_length });
        };
        let node = |i: usize, j: usize| j * (nx + 1) + i;
        for j in 0..=ny {
            for i in 0..=nx {
                let inside = |k: usize, n: usize| if k == 0 || k == n { 0.5 } else { 1.0 };
                if i < nx {
                    add(node(i, j), node(i + 1, j), k_x * inside(j, ny), a);
                }
                if j < ny {
                    add(node(i, j), node(i, j + 1), k_y * inside(i, nx), b);
                }
                if i < nx && j < ny {
                    add(node(i, j), node(i + 1, j + 1), k_d, a.hypot(b));
                    add(node(i + 1, j), node(i, j + 1), k_d, a.hypot(b));
                }
            }
        }
    }

    /// The same in another scalar.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> Lattice<T> {
        let round = |s: &Spring| Spring {
            ends: s.ends,
            stiffness: T::from_f64(s.stiffness),
            rest_length: T::from_f64(s.rest_length),
        };
        let springs = self.springs.iter().map(round).collect();
        Lattice { intervals: self.intervals, size: self.size, springs }
    }

    /// Positions of the nodes of the flat sheet.
    #[must_use]
    pub fn flat(&self) -> Vec<Vec3<f64>> {
        self.bulged(0.0)
    }

    /// Positions of the nodes of a sheet with a bulge of this height (m), a product of two parabolas.
    #[must_use]
    pub fn bulged(&self, height: f64) -> Vec<Vec3<f64>> {
        let [nx, ny] = self.intervals;
        let place = |node: usize| {
            let u = (node % (nx + 1)) as f64 / nx as f64 - 0.5;
            let v = (node / (nx + 1)) as f64 / ny as f64 - 0.5;
            [u * self.size[0], v * self.size[1], height * (1.0 - 4.0 * u * u) * (1.0 - 4.0 * v * v)]
        };
        (0..self.nodes()).map(place).collect()
    }
}

impl<T> Lattice<T> {
    /// Number of nodes, including those on the rim.
    #[must_use]
    pub fn nodes(&self) -> usize {
        (self.intervals[0] + 1) * (self.intervals[1] + 1)
    }

    /// Number of free nodes.
    #[must_use]
    pub fn free_nodes(&self) -> usize {
        (self.intervals[0] - 1) * (self.intervals[1] - 1)
    }

    /// Index of a node among the free ones, row by row; `None` on the rim.
    #[must_use]
    pub fn free(&self, node: usize) -> Option<usize> {
        let [nx, ny] = self.intervals;
        let (i, j) = (node % (nx + 1), node / (nx + 1));
        (i > 0 && i < nx && j > 0 && j < ny).then(|| (j - 1) * (nx - 1) + i - 1)
    }

    /// Half bandwidth of a Hessian.
    #[must_use]
    pub fn width(&self) -> usize {
        3 * self.intervals[0] + 2
    }

    /// Area of a cell, which is also that of a node (m^2).
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.size[0] * self.size[1] / (self.intervals[0] * self.intervals[1]) as f64
    }

    /// Corners of the cells, counterclockwise seen from above.
    pub fn facets(&self) -> impl Iterator<Item = [usize; 4]> {
        let [nx, ny] = self.intervals;
        let node = move |i: usize, j: usize| j * (nx + 1) + i;
        (0..nx * ny).map(move |k| {
            let (i, j) = (k % nx, k / nx);
            [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]
        })
    }
}
