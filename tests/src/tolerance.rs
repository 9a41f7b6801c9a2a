//! How far apart two results are.

/// Largest difference, relative to the largest expected value: the measure of the references.
///
/// # Panics
/// If the lengths differ or something is not finite.
#[must_use]
pub fn relative_error(actual: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(actual.len(), expected.len(), "{actual:?} against {expected:?}");
    assert!(actual.iter().all(|x| x.is_finite()), "not finite: {actual:?}");
    let scale = largest(expected);
    let worst = actual.iter().zip(expected).fold(0.0, |worst: f64, (a, e)| worst.max((a - e).abs()));
    if worst == 0.0 { 0.0 } else { worst / scale }
}

/// Largest absolute value.
#[must_use]
pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |worst: f64, x| worst.max(x.abs()))
}
