//! Frames -> triads: one triad per simple rotation, or one given by its unit vectors in the parent's components.

use super::quantities::Kinematics;
use super::{lifted, lower};
use crate::expr::ExprId;
use crate::expr::number::Number;
use crate::model::{Axis, FrameId, Model, Orientation};
use crate::vector::{Algebra, Components, TriadId, Turn, Vector, cross_components};

/// An angle (degrees) within this of a whole degree is taken as that, so that its sine and cosine are exact.
const WHOLE_DEGREE: f64 = 1e-12;

/// Adds the triads of `frame`; its own is the last of them.
pub(super) fn derive(alg: &mut Algebra, model: &Model, k: &Kinematics, frame: FrameId) -> TriadId {
    let triad = match &model.frames[frame].orientation {
        Orientation::Inertial => TriadId::INERTIAL,
        Orientation::Rotations { parent, rotations } => {
            let mut triad = k.frame_triad[*parent];
            for (axis, angle) in rotations {
                let angle = lower::scalar(alg, k, angle);
                triad = alg.triads.push(Turn::Simple { parent: triad, axis: *axis, angle });
            }
            triad
        }
        Orientation::Euler { parent, parameters } => {
            let parameters = parameters.each_ref().map(|e| lower::scalar(alg, k, e));
            let turn = by_euler_parameters(alg, k.frame_triad[*parent], parameters);
            alg.triads.push(turn)
        }
        Orientation::Directions { axes } => {
            let given: [Option<Components>; 3] = std::array::from_fn(|j| {
                axes[j].as_ref().map(|expr| {
                    let v = lower::vector(alg, k, expr);
                    let v = lifted::flatten(alg, k, &v);
                    alg.express(&v, TriadId::INERTIAL)
                })
            });
            let rows = complete(alg, given);
            alg.triads.push(Turn::Directions { parent: TriadId::INERTIAL, rows, spin: None })
        }
    };
    declare_constants(alg, model, k, (frame, triad));
    triad
}

/// Axes from Euler parameters, and w = 2 (e0 e' - e0' e - e x e') along them (Kane, Likins, Levinson 1983, section
/// 1.13).
fn by_euler_parameters(alg: &mut Algebra, parent: TriadId, parameters: [ExprId; 4]) -> Turn {
    let [e0, e1, e2, e3] = parameters;
    let dag = &mut alg.dag;
    let two = dag.number(Number::integer(2));
    let twice = parameters.map(|e| dag.mul(two, e));
    let squares = parameters.map(|e| dag.mul(e, e));
    let mut diagonal = |i: usize| {
        let both = dag.add(squares[0], squares[i]);
        let (j, l) = ([0, 2, 3, 1][i], [0, 3, 1, 2][i]);
        let less = dag.sub(both, squares[j]);
        dag.sub(less, squares[l])
    };
    let [xx, yy, zz] = [1, 2, 3].map(&mut diagonal);
    let mut pair = |a: ExprId, b: ExprId, c: ExprId| {
        let (across, along) = (dag.mul(a, b), dag.mul(e0, c));
        let (sum, difference) = (dag.add(across, along), dag.sub(across, along));
        [dag.mul(two, sum), dag.mul(two, difference)]
    };
    let ([xy, yx], [yz, zy], [zx, xz]) = (pair(e1, e2, e3), pair(e2, e3, e1), pair(e3, e1, e2));
    let rows = [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]];
    let [t0, t1, t2, t3] = twice;
    let [n1, n2, n3] = [t1, t2, t3].map(|t| dag.negate(t));
    let spin = [
        vec![(t0, e1), (n1, e0), (t3, e2), (n2, e3)],
        vec![(t0, e2), (n2, e0), (t1, e3), (n3, e1)],
        vec![(t0, e3), (n3, e0), (t2, e1), (n1, e2)],
    ];
    Turn::Directions { parent, rows, spin: Some(spin) }
}

/// Adds the third axis as the cross product of the two given.
fn complete(alg: &mut Algebra, given: [Option<Components>; 3]) -> [Components; 3] {
    let zero = [alg.dag.zero(); 3];
    std::array::from_fn(|j| match given[j] {
        Some(row) => row,
        None => match (given[(j + 1) % 3], given[(j + 2) % 3]) {
            (Some(a), Some(b)) => cross_components(&mut alg.dag, &a, &b),
            _ => zero, // the model's check asks for two axes at least
        },
    })
}

/// If a fixed vector is (plus or minus) an axis of another triad, declares that axis constant in this frame.
fn declare_constants(alg: &mut Algebra, model: &Model, k: &Kinematics, (frame, here): (FrameId, TriadId)) {
    for fixed in &model.frames[frame].fixed_vectors {
        let components: [ExprId; 3] = std::array::from_fn(|j| lower::scalar(alg, k, &fixed.components[j]));
        let vector = lower::vector(alg, k, &fixed.vector);
        if let Some((triad, axis, negative)) = single_axis(alg, &vector) {
            let components = components.map(|c| if negative { alg.dag.negate(c) } else { c });
            alg.triads.declare_constant(triad, axis, here, components);
            if let Some((turned, along)) = aligned_triad(alg, here, &components) {
                alg.triads.declare_constant(triad, axis, turned, along);
            }
        }
    }
}

/// Adds a triad fixed in `frame` whose x axis is along a constant vector of the x-y plane; returns it with that vector
/// in it.
///
/// Vectors that rotate with a rod are short along the rod's own axes: w x (w x e) takes three products there.
fn aligned_triad(
    alg: &mut Algebra,
    frame: TriadId,
    components: &Components,
) -> Option<(TriadId, Components)> {
    let size = |c: ExprId| alg.dag.as_number(c).map(|number| number.to_f64());
    let [x, y, z] = [size(components[0])?, size(components[1])?, size(components[2])?];
    if z != 0.0 || x == 0.0 || y == 0.0 {
        return None; // an axis already, or out of the plane of x and y
    }
    let degrees = y.atan2(x).to_degrees();
    let whole = degrees.round();
    let angle = if (degrees - whole).abs() < WHOLE_DEGREE {
        let (pi, turn) = (alg.dag.pi(), alg.dag.number(Number::rational(whole as i64, 180)));
        alg.dag.mul(turn, pi)
    } else {
        alg.dag.constant(y.atan2(x))
    };
    let length = alg.dag.constant(x.hypot(y));
    let zero = alg.dag.zero();
    let turned = alg.triads.push(Turn::Simple { parent: frame, axis: Axis::Z, angle });
    Some((turned, [length, zero, zero]))
}

/// The triad fixed in `frame` in which a term of the vector along one axis stays along one axis; otherwise `frame`.
pub(super) fn aligned(alg: &Algebra, vector: &Vector, frame: TriadId) -> TriadId {
    let mut places = vector.terms.iter().filter_map(|(&triad, components)| {
        let axis = crate::vector::along_axis(&alg.dag, components)?;
        alg.triads.aligned(&alg.dag, (triad, [Axis::X, Axis::Y, Axis::Z][axis.0]), frame)
    });
    places.next().unwrap_or(frame)
}

/// (triad, axis, is negative) if the vector is plus or minus one unit vector.
fn single_axis(alg: &Algebra, vector: &Vector) -> Option<(TriadId, Axis, bool)> {
    let (&triad, components) = vector.terms.first()?;
    if vector.terms.len() != 1 || !vector.points.is_empty() {
        return None;
    }
    let mut found = None;
    for (axis, &c) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(components) {
        if alg.dag.is_zero(c) {
            continue;
        }
        let value = alg.dag.as_number(c)?.to_f64();
        if found.is_some() || value.abs() != 1.0 {
            return None;
        }
        found = Some((triad, axis, value < 0.0));
    }
    found
}

/// An exactly orthonormal version of a frame given by directions, and the triad in which its components are.
///
/// The triad as stated is cheap but orthonormal only where the constraints hold. Newton's residual of a vector fixed in
/// the frame needs axes that are orthonormal elsewhere too, or the iteration would not converge quadratically.
/// Gram-Schmidt: x along the first axis, z along x cross y, y = z cross x.
pub(super) fn orthonormal(alg: &mut Algebra, frame: TriadId) -> Option<(TriadId, [Components; 3])> {
    let Turn::Directions { parent, rows, .. } = alg.triads.turn(frame).clone() else { return None };
    let x = normalized(alg, &rows[0]);
    let z = cross_components(&mut alg.dag, &x, &rows[1]);
    let z = normalized(alg, &z);
    let y = cross_components(&mut alg.dag, &z, &x);
    Some((parent, [x, y, z]))
}

/// The vector with its part in `frame` taken along the axes of the orthonormal version of that frame.
pub(super) fn flattened(alg: &mut Algebra, vector: &Vector, frame: TriadId) -> Vector {
    let (Some(&part), Some((parent, rows))) = (vector.terms.get(&frame), orthonormal(alg, frame)) else {
        return vector.clone();
    };
    let stated = std::array::from_fn(|i| {
        let column: Components = std::array::from_fn(|j| rows[j][i]);
        crate::vector::dot_components(&mut alg.dag, &part, &column)
    });
    let mut rest = vector.clone();
    rest.terms.remove(&frame);
    let stated = Vector::new(&alg.dag, parent, stated);
    rest.plus(&mut alg.dag, &stated)
}

fn normalized(alg: &mut Algebra, v: &Components) -> Components {
    let square = crate::vector::dot_components(&mut alg.dag, v, v);
    let norm = alg.dag.sqrt(square);
    v.map(|c| alg.dag.div(c, norm))
}
