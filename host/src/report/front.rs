//! The Pareto front of a subject, and the slope of a method's line.

use super::point::Point;

/// Is `a` no worse than `b` in error and time, and better in one? Errors have been raised to the reference's certainty
/// before, so that none is better by rounding alone.
#[must_use]
pub fn dominates(a: &Point, b: &Point) -> bool {
    let no_worse = a.error <= b.error && a.nanoseconds <= b.nanoseconds;
    no_worse && (a.error < b.error || a.nanoseconds < b.nanoseconds)
}

/// Marks every point that no other one dominates.
pub fn mark(points: &mut [Point]) {
    let all = points.to_vec();
    for point in points {
        point.front = !all.iter().any(|other| dominates(other, point));
    }
}

/// Slope of log y over log x by least squares; `None` below two points.
#[must_use]
pub fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let n = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let (mx, my) = (logs.iter().map(|p| p.0).sum::<f64>() / n, logs.iter().map(|p| p.1).sum::<f64>() / n);
    let covariance: f64 = logs.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum();
    let variance: f64 = logs.iter().map(|p| (p.0 - mx).powi(2)).sum();
    (points.len() > 1 && variance > 0.0).then(|| covariance / variance)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(error: f64, nanoseconds: f64) -> Point {
        Point {
            method: String::new(),
            scalar: String::new(),
            control: None,
            error,
            evaluations: None,
            nanoseconds,
            front: false,
            is_peer: false,
            command: String::new(),
        }
    }

    #[test]
    fn a_beaten_point_is_not_on_the_front() {
        let mut points = [point(1e-3, 10.0), point(1e-2, 20.0), point(1e-6, 100.0), point(1e-6, 90.0)];
        mark(&mut points);
        assert_eq!(points.map(|p| p.front), [true, false, false, true]);
    }

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let line: Vec<(f64, f64)> = [1.0, 2.0, 4.0, 8.0].map(|h: f64| (h, 3.0 * h.powi(4))).to_vec();
        assert!((slope(&line).unwrap() - 4.0).abs() < 1e-12);
        assert_eq!(slope(&line[..1]), None);
    }
}
