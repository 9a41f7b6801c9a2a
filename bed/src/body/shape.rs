//! A box with round edges, the common form of all simple shapes: without side lengths a ball, with one a capsule, with
//! two a slab.
//!
//! In: a point in the shape's axes. Out: its distance from the surface, negative inside, and the normal there.

use smartbed_runtime::vec3::{Vec3, norm, scale};

/// All points within `radius` of a box that is centred at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Half the sides of the box (m).
    pub half: Vec3<f64>,
    /// Radius (m).
    pub radius: f64,
}

impl Shape {
    /// A ball.
    #[must_use]
    pub fn ball(radius: f64) -> Shape {
        Shape { half: [0.0; 3], radius }
    }

    /// Distance of a point from the surface (m), and the normal outwards.
    #[must_use]
    pub fn gap(&self, point: Vec3<f64>) -> (f64, Vec3<f64>) {
        let beyond: Vec3<f64> =
            std::array::from_fn(|i| point[i] - point[i].clamp(-self.half[i], self.half[i]));
        let distance = norm(beyond);
        if distance > 0.0 {
            return (distance - self.radius, scale(beyond, 1.0 / distance));
        }
        // Inside the box the nearest face counts.
        let depth = |i: usize| self.half[i] - point[i].abs();
        let axis = (1..3).fold(0, |best, i| if depth(i) < depth(best) { i } else { best });
        let mut normal = [0.0; 3];
        normal[axis] = 1.0_f64.copysign(point[axis]);
        (-depth(axis) - self.radius, normal)
    }

    /// Second derivatives of the distance: (P - n n')/d outside the box at distance d, with P the projection on the
    /// axes along which the point lies outside; inside the box 0.
    #[must_use]
    pub fn curvature(&self, point: Vec3<f64>) -> [Vec3<f64>; 3] {
        let beyond: Vec3<f64> =
            std::array::from_fn(|i| point[i] - point[i].clamp(-self.half[i], self.half[i]));
        let distance = norm(beyond);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let is_along = beyond[i] != 0.0 || self.half[i] == 0.0;
                let same = if i == j && is_along { 1.0 } else { 0.0 };
                let bent = same - beyond[i] / distance * beyond[j] / distance;
                if distance > 0.0 { bent / distance } else { 0.0 }
            })
        })
    }

    /// Points of the box without its round edges: its centre, corners, and the middles between them.
    #[must_use]
    pub fn core(&self) -> Vec<Vec3<f64>> {
        let [xs, ys, zs] = self.half.map(|h| if h > 0.0 { vec![-h, 0.0, h] } else { vec![0.0] });
        let row = |x: f64, y: f64| zs.iter().map(move |z| [x, y, *z]).collect::<Vec<_>>();
        xs.iter().flat_map(|x| ys.iter().flat_map(move |y| row(*x, *y))).collect()
    }

    /// Upper bound of the distance of its points from the centre (m).
    #[must_use]
    pub fn reach(&self) -> f64 {
        norm(self.half) + self.radius
    }

    /// Distances (m) along the axes of three pairs of points, each with a sixth of the mass, that have the moments of
    /// inertia of the solid shape: sqrt(3 <x^2>), by the parts of [`Shape::volume`].
    #[must_use]
    pub fn gyration(&self) -> Vec3<f64> {
        let (r, pi) = (self.radius, std::f64::consts::PI);
        std::array::from_fn(|i| {
            let [a, b, c] = [0, 1, 2].map(|k| self.half[(i + k) % 3]);
            let square = a * a / 3.0;
            let within = (8.0 * a * b * c + 8.0 * r * a * (b + c) + 2.0 * pi * r * r * a) * square;
            let ends = 8.0 * b * c * ((a + r).powi(3) - a.powi(3)) / 3.0;
            // The centroids of half a disc and half a ball are 4 r/(3 pi) and 3 r/8 from the centre.
            let edges = 2.0 * pi * r * r * (b + c) * (a * a + 8.0 / 3.0 / pi * a * r + 0.25 * r * r);
            let corners = 4.0 / 3.0 * pi * r * r * r * (a * a + 0.75 * a * r + 0.2 * r * r);
            (3.0 * (within + ends + edges + corners) / self.volume()).sqrt()
        })
    }

    /// Volume (m^3): the box, slabs on its faces, quarter cylinders along its edges, and eight octants of a ball.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let [a, b, c] = self.half.map(|h| 2.0 * h);
        let (r, pi) = (self.radius, std::f64::consts::PI);
        a * b * c + 2.0 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4.0 / 3.0 * pi * r * r * r
    }
}
