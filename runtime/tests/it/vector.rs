//! Spatial vectors for tests, independent of the runtime's.

pub type Vector = [f64; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + s b
pub fn along(a: Vector, s: f64, b: Vector) -> Vector {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn unit(a: Vector) -> Vector {
    a.map(|x| x / dot(a, a).sqrt())
}

/// Axes turned about a unit vector (Rodrigues).
pub fn turned(axes: [Vector; 3], axis: Vector, angle: f64) -> [Vector; 3] {
    let (sin, cos) = angle.sin_cos();
    axes.map(|a| along(along(a.map(|x| x * cos), sin, cross(axis, a)), (1.0 - cos) * dot(axis, a), axis))
}
