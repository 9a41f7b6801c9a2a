//! A flexible body as plain lists in f64: the result of a shape, and the input of a simulation.
//!
//! The same lists are stepped on the host and printed as constant tables for the firmware.

use std::collections::{BTreeMap, BTreeSet};

use smartbed_runtime::flexible::Spring;
use smartbed_runtime::real::Scalar;

/// Indices of the nodes row by row, `None` where the grid has a hole.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Length of a row.
    pub columns: usize,
    /// The nodes, row after row.
    pub nodes: Vec<Option<usize>>,
}

/// Points, springs and facets of one body, SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lists {
    /// Initial positions (m).
    pub points: Vec<[f64; 3]>,
    /// Masses (kg).
    pub masses: Vec<f64>,
    /// True where a point is held in space.
    pub fixed: Vec<bool>,
    /// Ends of each spring.
    pub springs: Vec<[usize; 2]>,
    /// Rest lengths (m).
    pub rest_lengths: Vec<f64>,
    /// K of each spring (N/m).
    pub stiffness: Vec<f64>,
    /// C of each spring (N s/m).
    pub damping: Vec<f64>,
    /// Corners of each facet, counter-clockwise seen from outside; a triangle repeats its third.
    pub facets: Vec<[usize; 4]>,
    /// Initial velocities (m/s).
    pub velocities: Vec<[f64; 3]>,
    /// Index of the first mass that is in the middle of a cell; `None` if there are none.
    pub first_centre: Option<usize>,
    /// Nodes that are arranged in rows and columns.
    pub table: Option<Table>,
}

impl Lists {
    /// Adds a free point of mass 1 kg; returns its index.
    pub fn point(&mut self, x: [f64; 3]) -> usize {
        self.points.push(x);
        self.masses.push(1.0);
        self.fixed.push(false);
        self.points.len() - 1
    }

    /// Its springs as the runtime takes them, rounded once to S, with point indices shifted by `first`.
    pub fn elements<S: Scalar>(&self, first: usize) -> impl Iterator<Item = Spring<S>> + '_ {
        (0..self.springs.len()).map(move |n| Spring {
            tail: self.springs[n][0] + first,
            head: self.springs[n][1] + first,
            stiffness: S::from_f64(self.stiffness[n]),
            damping: S::from_f64(self.damping[n]),
            rest_length: S::from_f64(self.rest_lengths[n]),
        })
    }

    /// Adds a spring between two points, at rest where they are.
    pub fn spring(&mut self, tail: usize, head: usize) {
        let [a, b] = [self.points[tail], self.points[head]];
        let length = (0..3).map(|c| (b[c] - a[c]).powi(2)).sum::<f64>().sqrt();
        self.springs.push([tail, head]);
        self.rest_lengths.push(length);
    }

    /// All numbers with their names, for checks.
    pub fn numbers(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        let list = |name: &'static str, list: &'_ [f64]| list.iter().map(|x| (name, *x)).collect::<Vec<_>>();
        let vectors = [("points", &self.points), ("initial_velocity", &self.velocities)];
        let vectors = vectors.map(|(name, vectors)| list(name, vectors.as_flattened()));
        let scalars = [
            ("mass", &self.masses),
            ("rest_lengths", &self.rest_lengths),
            ("K", &self.stiffness),
            ("C", &self.damping),
        ];
        vectors.into_iter().chain(scalars.map(|(name, values)| list(name, values))).flatten()
    }

    /// Connects every pair of the given points by a spring.
    pub fn join_all(&mut self, points: &[usize]) {
        for (n, a) in points.iter().enumerate() {
            for b in &points[n + 1..] {
                self.spring(*a, *b);
            }
        }
    }

    /// Distributes the mass of `massless` points evenly to their neighbours and removes the dampers of their springs.
    ///
    /// # Errors
    /// A point without a neighbour that has mass.
    pub fn redistribute(&mut self, massless: &[usize]) -> Result<(), String> {
        let is_massless: BTreeSet<usize> = massless.iter().copied().collect();
        let mut neighbours: BTreeMap<usize, Vec<usize>> = massless.iter().map(|p| (*p, Vec::new())).collect();
        for [tail, head] in &self.springs {
            for (point, other) in [(tail, head), (head, tail)] {
                if let Some(list) = neighbours.get_mut(point).filter(|_| !is_massless.contains(other)) {
                    list.push(*other);
                }
            }
        }
        let mut gains: BTreeMap<usize, f64> = BTreeMap::new();
        for point in massless {
            let takers = neighbours.get(point).map_or(&[][..], Vec::as_slice);
            if takers.is_empty() {
                return Err(format!(
                    "the massless point {point} has no neighbour that could take its mass; join it by a spring to a point with mass"
                ));
            }
            for k in takers {
                *gains.entry(*k).or_default() += self.masses[*point] / takers.len() as f64;
            }
        }
        for (k, gain) in gains {
            self.masses[k] += gain;
        }
        for &point in massless {
            self.masses[point] = 0.0;
            self.velocities[point] = [0.0; 3];
        }
        for (spring, c) in self.springs.iter().zip(&mut self.damping) {
            if spring.iter().any(|p| is_massless.contains(p)) {
                *c = 0.0;
            }
        }
        Ok(())
    }
}
