//! Frames -> triads: one triad per simple rotation, or unit vectors in inertial components.

use super::quantities::Kinematics;
use super::{lifted, lower};
use crate::expr::ExprId;
use crate::expr::number::Number;
use crate::model::{Axis, FrameId, Model, Orientation};
use crate::vector::{Components, TriadId, Turn, Vector, cross_components};

/// An angle this near to a whole degree is meant to be one (its sine and cosine are then exact).
const WHOLE_DEGREE: f64 = 1e-12;

/// Adds the triads of `frame`.
pub(super) fn derive(model: &Model, k: &mut Kinematics, frame: FrameId) {
    k.frame_triad[frame] = match &model.frames[frame].orientation {
        Orientation::Inertial => TriadId::INERTIAL,
        Orientation::Rotations { parent, rotations } => {
            let mut triad = k.frame_triad[*parent];
            for (axis, angle) in rotations {
                let angle = lower::scalar(k, angle);
                triad = k.triads.push(Turn::Simple { parent: triad, axis: *axis, angle });
            }
            triad
        }
        Orientation::Directions { axes } => {
            let given: [Option<Components>; 3] = std::array::from_fn(|j| {
                axes[j].as_ref().map(|expr| {
                    let v = lower::vector(k, expr);
                    let v = lifted::flatten(k, &v);
                    k.triads.express(&mut k.dag, &v, TriadId::INERTIAL)
                })
            });
            let rows = complete(k, given);
            k.triads.push(Turn::Directions { rows })
        }
    };
    declare_constants(model, k, frame);
}

/// The third axis is the cross product of the two given.
fn complete(k: &mut Kinematics, given: [Option<Components>; 3]) -> [Components; 3] {
    let zero = [k.dag.zero(); 3];
    std::array::from_fn(|j| match given[j] {
        Some(row) => row,
        None => match (given[(j + 1) % 3], given[(j + 2) % 3]) {
            (Some(a), Some(b)) => cross_components(&mut k.dag, &a, &b),
            _ => zero, // the model's check asks for two axes at least
        },
    })
}

/// A fixed vector that is an axis of another triad (up to sign) makes that axis constant here.
fn declare_constants(model: &Model, k: &mut Kinematics, frame: FrameId) {
    let here = k.frame_triad[frame];
    for fixed in &model.frames[frame].fixed_vectors {
        let components: [ExprId; 3] = std::array::from_fn(|j| lower::scalar(k, &fixed.components[j]));
        let vector = lower::vector(k, &fixed.vector);
        if let Some((triad, axis, negative)) = single_axis(k, &vector) {
            let components = components.map(|c| if negative { k.dag.negate(c) } else { c });
            k.triads.declare_constant(triad, axis, here, components);
            if let Some((turned, along)) = aligned_triad(k, here, &components) {
                k.triads.declare_constant(triad, axis, turned, along);
            }
        }
    }
}

/// A triad fixed in `frame` with its axis along a constant vector in a coordinate plane, and that vector there.
///
/// What turns about a rod is short in the rod's own axes: w x (w x e) has three products there.
fn aligned_triad(
    k: &mut Kinematics,
    frame: TriadId,
    components: &Components,
) -> Option<(TriadId, Components)> {
    let size = |c: ExprId| k.dag.as_number(c).map(|number| number.to_f64());
    let [x, y, z] = [size(components[0])?, size(components[1])?, size(components[2])?];
    if z != 0.0 || x == 0.0 || y == 0.0 {
        return None; // an axis already, or out of the plane of x and y
    }
    let degrees = y.atan2(x).to_degrees();
    let whole = degrees.round();
    let angle = if (degrees - whole).abs() < WHOLE_DEGREE {
        let (pi, turn) = (k.dag.pi(), k.dag.number(Number::rational(whole as i64, 180)));
        k.dag.mul(turn, pi)
    } else {
        k.dag.constant(y.atan2(x))
    };
    let length = k.dag.constant(x.hypot(y));
    let zero = k.dag.zero();
    let turned = k.triads.push(Turn::Simple { parent: frame, axis: Axis::Z, angle });
    Some((turned, [length, zero, zero]))
}

/// The triad, fixed in `frame`, in which a vector along one axis stays along one; `frame` where there is none.
pub(super) fn aligned(k: &Kinematics, vector: &Vector, frame: TriadId) -> TriadId {
    let mut places = vector.terms.iter().filter_map(|(&triad, components)| {
        let axis = crate::vector::along_axis(&k.dag, components)?;
        k.triads.aligned(&k.dag, (triad, [Axis::X, Axis::Y, Axis::Z][axis.0]), frame)
    });
    places.next().unwrap_or(frame)
}

/// (triad, axis, negative) if the vector is plus or minus one unit vector.
fn single_axis(k: &Kinematics, vector: &Vector) -> Option<(TriadId, Axis, bool)> {
    let (&triad, components) = vector.terms.first_key_value()?;
    if vector.terms.len() != 1 || !vector.points.is_empty() {
        return None;
    }
    let mut found = None;
    for (axis, &c) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(components) {
        if k.dag.is_zero(c) {
            continue;
        }
        let value = k.dag.as_number(c)?.to_f64();
        if found.is_some() || value.abs() != 1.0 {
            return None;
        }
        found = Some((triad, axis, value < 0.0));
    }
    found
}

/// Inertial components of an exactly orthonormal version of a frame of two stated directions.
///
/// The cheap triad of the model is orthonormal only on the constraints; Newton's residual of a
/// vector "fixed in the frame" needs one that is orthonormal off them, or it would not converge
/// quadratically. Gram-Schmidt: x along the first axis, z along x cross y, y = z cross x.
pub(super) fn orthonormal(k: &mut Kinematics, frame: TriadId) -> Option<[Components; 3]> {
    let Turn::Directions { rows } = k.triads.turn(frame).clone() else { return None };
    let x = normalized(k, &rows[0]);
    let z = cross_components(&mut k.dag, &x, &rows[1]);
    let z = normalized(k, &z);
    let y = cross_components(&mut k.dag, &z, &x);
    Some([x, y, z])
}

/// The same vector with its part in `frame` read off the orthonormal version of that frame.
pub(super) fn flattened(k: &mut Kinematics, vector: &Vector, frame: TriadId) -> Vector {
    let (Some(&part), Some(rows)) = (vector.terms.get(&frame), orthonormal(k, frame)) else {
        return vector.clone();
    };
    let stated = std::array::from_fn(|i| {
        let column: Components = std::array::from_fn(|j| rows[j][i]);
        crate::vector::dot_components(&mut k.dag, &part, &column)
    });
    let mut rest = vector.clone();
    rest.terms.remove(&frame);
    let stated = Vector::new(&k.dag, TriadId::INERTIAL, stated);
    rest.plus(&mut k.dag, &stated)
}

fn normalized(k: &mut Kinematics, v: &Components) -> Components {
    let square = crate::vector::dot_components(&mut k.dag, v, v);
    let norm = k.dag.sqrt(square);
    v.map(|c| k.dag.div(c, norm))
}
