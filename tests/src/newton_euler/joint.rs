//! Joints as rows of constraints over jets; every row is zero where the joint holds.

use super::jet::{Jet, JetVector};

/// Two points coincide: 3 rows.
#[must_use]
pub fn coincide(a: &JetVector, b: &JetVector) -> [Jet; 3] {
    (*a - *b).components()
}

/// Two directions are perpendicular: 1 row.
#[must_use]
pub fn perpendicular(a: &JetVector, b: &JetVector) -> Jet {
    a.dot(b)
}

/// Two points keep a distance: 1 row, (|a - b|^2 - l^2) / (2 l), a length.
#[must_use]
pub fn distance(a: &JetVector, b: &JetVector, length: f64) -> Jet {
    let ab = *a - *b;
    (ab.dot(&ab) - Jet::constant(length * length)) * Jet::constant(0.5 / length)
}

/// A hinge: the points coincide and `axis` stays perpendicular to two directions of the other body. 5 rows.
#[must_use]
pub fn hinge(a: &JetVector, b: &JetVector, axis: &JetVector, across: [JetVector; 2]) -> [Jet; 5] {
    let [x, y, z] = coincide(a, b);
    [x, y, z, perpendicular(axis, &across[0]), perpendicular(axis, &across[1])]
}
