//! Facets of a flexible body as a surface: gap along normals that are interpolated from the corners.
//!
//! In: a facet's corners a, b, c, d (round the outside, c = d for a triangle), the normals there, a point x.
//! Out: the parameters (u, v) of the point of the facet whose normal passes through x. With bilinear weights w_i,
//! ```text
//! X(u, v) = sum w_i x_i,  N(u, v) = sum w_i n_i,   x = X + t N,   g = t |N|
//! ```
//! is solved by Newton's method. N is the same on both sides of an edge, so gap and normal are continuous from facet to
//! facet; the normals of flat facets would jump there.

use core::ops::Range;

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Newton iterations: from the facet's middle, convergence is quadratic.
const ITERATIONS: usize = 16;
/// A step of u and v below which the next ones are so much smaller that a point [`CLEARLY`] outside stays outside.
const SMALL: f64 = 1.0 / 1024.0;
const CLEARLY: f64 = 1.0 / 64.0;

/// A facet with the normals at its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet<S> {
    /// a, b, c, d in N (m).
    pub corners: [Vec3<S>; 4],
    /// Outward unit normals at the corners.
    pub normals: [Vec3<S>; 4],
}

/// A point over a facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacetNearest<S> {
    /// g (m), < 0 inside.
    pub gap: S,
    /// N/|N|, outwards: the direction of forces.
    pub normal: Vec3<S>,
    /// Gradient of the gap; parallel to n only where the facet is perpendicular to it.
    pub gradient: Vec3<S>,
    /// Weight of each corner at the foot; the sum is 1.
    pub weights: [S; 4],
    /// The foot (m).
    pub foot: Vec3<S>,
    /// How much the gap (m) to the facet may change along a smooth surface with these normals.
    pub sagitta: S,
}

impl<S: Scalar> FacetNearest<S> {
    /// g' (m/s) at g = 0 of a point with this velocity, given the velocities of the corners.
    #[must_use]
    pub fn gap_rate(&self, velocity: Vec3<S>, corners: &[Vec3<S>; 4]) -> S {
        vec3::dot(self.gradient, vec3::sub(velocity, blend(&self.weights, corners)))
    }
}

/// Unit normals at consecutive points of a body: the sum of the vector areas of the adjacent facets, normalised.
///
/// `normals` has one row per point of `pos`; those at `points` are written, with the zero vector at points of no facet.
/// Corners of facets that are not among them get none.
pub fn vertex_normals<S: Scalar>(
    facets: &[[usize; 4]],
    pos: &[Vec3<S>],
    points: Range<usize>,
    normals: &mut [Vec3<S>],
) {
    let first = points.start;
    let Some(normals) = normals.get_mut(points) else { return };
    normals.fill(vec3::zero());
    for facet in facets {
        let [a, b, c, d] = *facet;
        let [x, y, z, w] = facet.map(|k| vec3::at(pos, k));
        let area = vec3::cross(vec3::sub(z, x), vec3::sub(w, y));
        let mut add = |corner: usize, repeats: bool| {
            if let Some(normal) = normals.get_mut(corner.wrapping_sub(first)).filter(|_| !repeats) {
                *normal = vec3::add(*normal, area);
            }
        };
        // A triangle repeats its third corner.
        add(a, false);
        add(b, b == a);
        add(c, c == a || c == b);
        add(d, d == a || d == b || d == c);
    }
    for normal in normals {
        (*normal, _) = vec3::direction(*normal);
    }
}

impl<S: Scalar> Facet<S> {
    /// The point of the facet whose normal passes through `point`; None if it lies outside by more than `margin`
    /// (relative to the facet) or there is none, as where normals meet on this side of the point.
    #[must_use]
    pub fn nearest(&self, point: Vec3<S>, margin: S) -> Option<FacetNearest<S>> {
        let half = S::from_f64(0.5);
        let (mut u, mut v) = (half, half);
        let mut t = vec3::dot(vec3::sub(point, blend(&weights(u, v), &self.corners)), self.normal(u, v));
        let mut off = vec3::zero();
        for _ in 0..ITERATIONS {
            let (rows, scale) = self.inverse(u, v, t)?;
            let w = weights(u, v);
            off = vec3::sub(
                vec3::sub(point, blend(&w, &self.corners)),
                vec3::scale(blend(&w, &self.normals), t),
            );
            let [du, dv, dt] = vec3::apply(&rows, off);
            let before = (u, v, t);
            (u, v, t) = (u + scale * du, v + scale * dv, t + scale * dt);
            if (u, v, t) == before {
                break;
            }
            let (small, clearly) = (S::from_f64(SMALL), S::from_f64(CLEARLY));
            let outside = (-u).max(u - S::ONE).max(-v).max(v - S::ONE) > margin + clearly;
            if outside && (scale * du).abs() < small && (scale * dv).abs() < small {
                return None;
            }
        }
        let [a, _, c, _] = self.corners;
        let found = vec3::norm(off) <= S::EPSILON.sqrt() * vec3::norm(vec3::sub(c, a));
        let (low, high) = (-margin, S::ONE + margin);
        let inside = low <= u && u <= high && low <= v && v <= high;
        if found && inside { self.result(u, v, t) } else { None }
    }

    fn normal(&self, u: S, v: S) -> Vec3<S> {
        blend(&weights(u, v), &self.normals)
    }

    /// Rows of the inverse of [X_u + t N_u, X_v + t N_v, N] times its determinant, and 1/determinant.
    fn inverse(&self, u: S, v: S, t: S) -> Option<([Vec3<S>; 3], S)> {
        let (wu, wv) = slopes(u, v);
        let a = vec3::axpy(blend(&wu, &self.corners), t, blend(&wu, &self.normals));
        let b = vec3::axpy(blend(&wv, &self.corners), t, blend(&wv, &self.normals));
        let c = self.normal(u, v);
        let rows = [vec3::cross(b, c), vec3::cross(c, a), vec3::cross(a, b)];
        let determinant = vec3::dot(a, rows[0]);
        (determinant.is_finite() && determinant != S::ZERO).then(|| (rows, S::ONE / determinant))
    }

    /// Twice the most by which the tangent plane of a corner misses the facet's middle: a smooth surface may be that
    /// far above it at one place and below it at another. 0 where a flat facet's normals are its own.
    fn sagitta(&self) -> S {
        let middle = blend(&[S::from_f64(0.25); 4], &self.corners);
        let missed =
            self.corners.iter().zip(&self.normals).map(|(x, n)| vec3::dot(*n, vec3::sub(*x, middle)).abs());
        S::from_f64(2.0) * missed.fold(S::ZERO, S::max)
    }

    fn result(&self, u: S, v: S, t: S) -> Option<FacetNearest<S>> {
        let (rows, scale) = self.inverse(u, v, t)?;
        let w = weights(u, v);
        let (normal, length) = vec3::direction(blend(&w, &self.normals));
        let (wu, wv) = slopes(u, v);
        // dg = |N| dt + t n . (N_u du + N_v dv).
        let turn = |w: &[S; 4]| t * vec3::dot(normal, blend(w, &self.normals));
        let [du, dv, dt] = rows.map(|row| vec3::scale(row, scale));
        let gradient = vec3::axpy(vec3::axpy(vec3::scale(dt, length), turn(&wu), du), turn(&wv), dv);
        let foot = blend(&w, &self.corners);
        Some(FacetNearest { gap: t * length, normal, gradient, weights: w, foot, sagitta: self.sagitta() })
    }
}

/// Bilinear weights of a, b, c, d.
fn weights<S: Scalar>(u: S, v: S) -> [S; 4] {
    let (p, q) = (S::ONE - u, S::ONE - v);
    [p * q, u * q, u * v, p * v]
}

/// Derivatives of the weights with respect to u and v.
fn slopes<S: Scalar>(u: S, v: S) -> ([S; 4], [S; 4]) {
    let (p, q) = (S::ONE - u, S::ONE - v);
    ([-q, q, v, -v], [-p, -u, u, p])
}

/// a_i (1/m): how the weights of the corners x_i change as the foot moves across the normal n. sum a_i = 0, and
/// sum x_i (a_i . d) = d but for a part along n: the tangent plane at the foot turns with angular velocity
/// n x sum a_i (n . v_i), given the velocities v_i of the corners. 0 where n lies in that plane.
#[must_use]
pub fn weight_slopes<S: Scalar>(corners: &[Vec3<S>; 4], near: &FacetNearest<S>) -> [Vec3<S>; 4] {
    let ([_, b, c, d], n) = (near.weights, near.normal);
    let (wu, wv) = slopes(b + c, c + d);
    let [x, y] = [&wu, &wv].map(|w| blend(w, corners));
    let [du, dv] = [vec3::cross(y, n), vec3::cross(n, x)];
    let area = vec3::dot(x, du);
    let scale = if area == S::ZERO { S::ZERO } else { S::ONE / area };
    let slope = |[u, v]: [S; 2]| vec3::scale(vec3::axpy(vec3::scale(du, u), v, dv), scale);
    let [[a, b, c, d], [e, f, g, h]] = [wu, wv];
    [[a, e], [b, f], [c, g], [d, h]].map(slope)
}

/// Weighted sum of four vectors.
fn blend<S: Scalar>(weights: &[S; 4], vectors: &[Vec3<S>; 4]) -> Vec3<S> {
    weights.iter().zip(vectors).fold(vec3::zero(), |sum, (w, x)| vec3::axpy(sum, *w, *x))
}
