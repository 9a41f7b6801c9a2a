//! Rotation matrices from roll, pitch and yaw and back; inertia about other points and axes.

/// Three components.
pub type Vector = [f64; 3];
/// Rows.
pub type Matrix = [Vector; 3];

/// No rotation.
pub const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Length of a vector.
pub fn norm(v: Vector) -> f64 {
    v.iter().fold(0.0, |sum: f64, x| sum.hypot(*x))
}

/// A rotated vector.
pub fn turned(m: &Matrix, v: Vector) -> Vector {
    // Without a rotation the vector keeps the digits of the file.
    if *m == IDENTITY { v } else { m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]) }
}

/// Product of two rotations: a b.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    if *a == IDENTITY {
        return *b;
    }
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Rz(yaw) Ry(pitch) Rx(roll).
pub fn rotation([roll, pitch, yaw]: Vector) -> Matrix {
    if [roll, pitch, yaw] == [0.0; 3] {
        return IDENTITY;
    }
    let ((sr, cr), (sp, cp), (sy, cy)) = (sin_cos(roll), sin_cos(pitch), sin_cos(yaw));
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

/// Rotation by an angle about an axis of unit length.
pub fn about([x, y, z]: Vector, angle: f64) -> Matrix {
    let (s, c) = sin_cos(angle);
    let v = 1.0 - c;
    [
        [c + v * x * x, v * x * y - s * z, v * x * z + s * y],
        [v * x * y + s * z, c + v * y * y, v * y * z - s * x],
        [v * x * z - s * y, v * y * z + s * x, c + v * z * z],
    ]
}

/// Sine and cosine, exact for multiples of a quarter turn.
fn sin_cos(angle: f64) -> (f64, f64) {
    match quarters(angle) {
        Some(n) => [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][n.rem_euclid(4) as usize],
        None => (libm::sin(angle), libm::cos(angle)),
    }
}

/// The number of quarter turns in an angle; `None` if it is not a multiple up to rounding.
pub fn quarters(angle: f64) -> Option<i32> {
    let n = (angle / std::f64::consts::FRAC_PI_2).round();
    let near = (angle - n * std::f64::consts::FRAC_PI_2).abs() <= 4.0 * f64::EPSILON;
    (near && n.abs() <= 4.0).then_some(n as i32)
}

/// Roll, pitch and yaw of a rotation.
pub fn angles(m: &Matrix) -> Vector {
    let across = m[0][0].hypot(m[1][0]);
    let pitch = libm::atan2(-m[2][0], across);
    // At a pitch of a quarter turn roll and yaw are about the same axis: all of it counts as yaw.
    if across <= 1e-12 {
        return [0.0, pitch, libm::atan2(-m[0][1], m[1][1])];
    }
    let yaw = libm::atan2(m[1][0], m[0][0]);
    // What turns the rest of the matrix, so that an error of yaw near a quarter turn of pitch is undone.
    let (s, c) = (libm::sin(yaw), libm::cos(yaw));
    [libm::atan2(s * m[0][2] - c * m[1][2], c * m[1][1] - s * m[0][1]), pitch, yaw]
}

/// Entries xx, yy, zz, xy, xz, yz along other axes: R I R'.
pub fn along(m: &Matrix, inertia: [f64; 6]) -> [f64; 6] {
    if *m == IDENTITY {
        return inertia;
    }
    let [xx, yy, zz, xy, xz, yz] = inertia;
    let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let left: Matrix =
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| m[i][k] * rows[k][j]).sum()));
    let entry = |i: usize, j: usize| (0..3).map(|k| left[i][k] * m[j][k]).sum();
    [entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)]
}

/// Inertia of a point mass at `d` about the origin (Steiner's theorem).
pub fn of_point(mass: f64, [x, y, z]: Vector) -> [f64; 6] {
    let of = |a: f64| mass * a;
    [of(y * y + z * z), of(x * x + z * z), of(x * x + y * y), of(-x * y), of(-x * z), of(-y * z)]
}
