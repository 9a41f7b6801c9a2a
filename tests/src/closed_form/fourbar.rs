//! Assembly of a planar four-bar from its crank angle: two circles meet in two points.
//!
//! l1 e(q1) + l2 e(q2) + l3 e(q3) = (l4, 0); absolute angles from +x.

/// Angles q2, q3 for a crank angle q1, or none if the links do not reach. `side` (+1 or -1) is the
/// sign of q3 - q2 in (-pi, pi), the two ways to assemble.
#[must_use]
pub fn assemble(lengths: [f64; 4], q1: f64, side: f64) -> Option<[f64; 2]> {
    let [l1, l2, l3, l4] = lengths;
    // What links 2 and 3 must span together.
    let (x, y) = (l4 - l1 * q1.cos(), -l1 * q1.sin());
    let span_squared = x * x + y * y;
    let cos_between = (span_squared - l2 * l2 - l3 * l3) / (2.0 * l2 * l3);
    if 1.0 <= cos_between.abs() {
        return None;
    }
    let sin_between = side * (1.0 - cos_between * cos_between).sqrt();
    let q2 = y.atan2(x) - (l3 * sin_between).atan2(l2 + l3 * cos_between);
    Some([q2, q2 + sin_between.atan2(cos_between)])
}

/// Largest component of the loop equation's residual (m).
#[must_use]
pub fn residual(lengths: [f64; 4], q: [f64; 3]) -> f64 {
    let [l1, l2, l3, l4] = lengths;
    let x = l1 * q[0].cos() + l2 * q[1].cos() + l3 * q[2].cos() - l4;
    let y = l1 * q[0].sin() + l2 * q[1].sin() + l3 * q[2].sin();
    x.abs().max(y.abs())
}
