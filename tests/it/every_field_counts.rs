//! Every field of the language changes an answer that has an oracle.
//!
//! In: drawn mechanisms. Each change drops or alters one field of the text only; the oracle keeps the mechanism as it
//! was. A change that no comparison detects means that no test would notice a derivation that ignores the field.

use crate::hard_table;
use smartbed_codegen::Settings;
use smartbed_tests::random::Random;
use smartbed_tests::trial::description::{Description, Frame, Load};
use smartbed_tests::trial::draw::{self, KINDS};
use smartbed_tests::trial::expression::{Scalar, Value, Vector};
use smartbed_tests::trial::{text, verdict};
use std::collections::BTreeSet;

/// Seeds of each kind; a field is read by many of them.
const SEEDS: u64 = 20;
/// A difference that is seen.
const SEEN: f64 = 1e-6;

/// What a change does to one kind of entry; false for the others.
macro_rules! on {
    ($entry:ident, $kind:pat => $change:expr) => {
        match $entry {
            $kind => $change,
            _ => false,
        }
    };
}

/// Alters a description; false where it has no such field.
type Change = fn(&mut Description) -> bool;

/// Drops an option.
fn drop<T>(field: &mut Option<T>) -> bool {
    field.take().is_some()
}

fn any_load(d: &mut Description, change: impl FnMut(&mut Load) -> bool) -> bool {
    d.loads.iter_mut().any(change)
}

fn moment(d: &mut Description, which: usize) -> bool {
    d.bodies.iter_mut().any(|b| b.inertia.as_mut().is_some_and(|(_, moments)| drop(&mut moments[which])))
}

/// Twice the vector.
fn double_vector(v: &mut Vector) -> bool {
    *v = v.clone() + v.clone();
    true
}

/// Changes the first step of a frame.
fn first_rotation(d: &mut Description, change: fn(&mut (usize, Scalar))) -> bool {
    let steps = |f: &mut Frame| match f {
        Frame::Rotations(_, steps) => steps.first_mut().map(change).is_some(),
        _ => false,
    };
    d.frames.iter_mut().any(steps)
}

/// Changes the axes of a frame given by them.
fn directed(d: &mut Description, change: fn(&mut Vector, &mut Vector)) -> bool {
    let axes = |f: &mut Frame| match f {
        Frame::Directions(x, y) => {
            change(x, y);
            true
        }
        _ => false,
    };
    d.frames.iter_mut().any(axes)
}

/// Twice the number.
fn double(e: &mut Scalar) -> bool {
    *e = Scalar::number(2.0) * e.clone();
    true
}

/// A displacement of 5 cm.
fn step() -> Vector {
    Vector::Axis(0, 0).scaled(Scalar::Literal(0.05, "m"))
}

/// The change for each field.
const CHANGES: [(&str, Change); 41] = [
    ("top level.gravity", |d| drop(&mut d.gravity)),
    ("parameters.value", |d| d.parameters.iter_mut().filter(|p| p.fixed).map(|p| p.value *= 1.5).count() > 0),
    ("coordinates.closed_form", |d| {
        d.coordinates.iter_mut().any(|c| c.closed_form.as_mut().is_some_and(double))
    }),
    ("speeds.value", |d| d.speeds.iter_mut().any(|s| s.of.is_none() && double(&mut s.value))),
    ("definitions.value", |d| d.scalars.first_mut().is_some_and(double)),
    ("definitions.value of a vector", |d| d.vectors.first_mut().is_some_and(double_vector)),
    ("frames.parent", |d| {
        d.frames.iter_mut().any(|f| on!(f, Frame::Rotations(p, _) => std::mem::take(p) != 0))
    }),
    ("frames.rotations", |d| first_rotation(d, |(axis, _)| *axis = (*axis + 1) % 3)),
    ("frames.rotations, an angle", |d| {
        first_rotation(d, |(_, angle)| *angle = Scalar::number(2.0) * angle.clone())
    }),
    ("frames.x", |d| directed(d, std::mem::swap)),
    ("frames.y", |d| directed(d, |_, y| *y = y.clone().scaled(Scalar::number(-1.0)))),
    ("points.position", |d| {
        let centre = d.bodies[0].centre;
        d.points[centre].position = d.points[centre].position.clone() + step();
        true
    }),
    ("points.closures", |d| {
        d.points.iter_mut().flat_map(|p| &mut p.closures).map(|c| *c = c.clone() + step()).count() > 0
    }),
    ("points.velocity", |d| d.points.iter_mut().any(|p| p.velocity.as_mut().is_some_and(double_vector))),
    ("bodies.centre", |d| std::mem::take(&mut d.bodies[0].centre) != 0),
    ("bodies.mass", |d| d.bodies.iter_mut().any(|b| b.inertia.is_some() && drop(&mut b.mass))),
    ("bodies.weight", |d| d.bodies.iter_mut().any(|b| !std::mem::replace(&mut b.weight, true))),
    ("bodies.frame", |d| {
        d.bodies.iter_mut().filter_map(|b| b.inertia.as_mut()).map(|(f, _)| *f = 1).count() > 1
    }),
    ("bodies.inertia", |d| d.bodies.iter_mut().any(|b| b.mass.is_some() && drop(&mut b.inertia))),
    ("bodies.inertia.Ixx", |d| moment(d, 0)),
    ("bodies.inertia.Iyy", |d| moment(d, 1)),
    ("bodies.inertia.Izz", |d| moment(d, 2)),
    ("bodies.inertia.Ixy", |d| moment(d, 3)),
    ("bodies.inertia.Ixz", |d| moment(d, 4)),
    ("bodies.inertia.Iyz", |d| moment(d, 5)),
    ("constraints.configuration", |d| {
        d.configuration.iter_mut().any(|row| on!(row, Value::Vector(v) => { *v = v.clone() + step(); true }))
    }),
    ("constraints.motion", |d| {
        let edge = |row: &mut Value| match row {
            Value::Scalar(Scalar::Dot(_, axis)) => {
                **axis = Vector::Axis(0, 0);
                true
            }
            _ => false,
        };
        d.motion.iter_mut().any(edge)
    }),
    ("forces.point", |d| any_load(d, |l| on!(l, Load::Force(p, ..) => std::mem::take(p) != 0))),
    ("forces.force", |d| any_load(d, |l| on!(l, Load::Force(_, f, _) => double_vector(f)))),
    ("forces.reaction", |d| any_load(d, |l| on!(l, Load::Force(_, _, r) => drop(r)))),
    ("torques.frame", |d| any_load(d, |l| on!(l, Load::Torque(f, ..) => std::mem::take(f) != 0))),
    ("torques.torque", |d| any_load(d, |l| on!(l, Load::Torque(_, t, _) => double_vector(t)))),
    ("torques.reaction", |d| any_load(d, |l| on!(l, Load::Torque(_, _, r) => drop(r)))),
    ("springs.between", |d| any_load(d, |l| on!(l, Load::Spring([_, b], ..) => std::mem::take(b) != 0))),
    ("springs.stiffness", |d| any_load(d, |l| on!(l, Load::Spring(_, k, ..) => double(k)))),
    ("springs.rest_length", |d| any_load(d, |l| on!(l, Load::Spring(_, _, rest, _) => double(rest)))),
    ("springs.damping", |d| any_load(d, |l| on!(l, Load::Spring(_, _, _, c) => drop(c)))),
    ("springs.coordinate", |d| {
        any_load(d, |l| on!(l, Load::CoordinateSpring(q, ..) => std::mem::take(q) != 0))
    }),
    ("springs.rest", |d| any_load(d, |l| on!(l, Load::CoordinateSpring(_, _, rest, _) => double(rest)))),
    ("springs.damping on a coordinate", |d| {
        any_load(d, |l| on!(l, Load::CoordinateSpring(_, _, _, c) => drop(c)))
    }),
    ("outputs.value", |d| d.outputs.first_mut().is_some_and(double)),
];

/// Fields that no change of a drawn mechanism reaches, each with a test that fails if it is misread.
const ELSEWHERE: [(&str, &str, &str); 50] = [
    ("top level.format", "smartbed-codegen", "rejected_models_have_their_exact_messages"),
    ("top level.name", "smartbed-tests", "emitted_text_equals_the_golden_files"),
    ("top level.doc", "smartbed-tests", "emitted_text_equals_the_golden_files"),
    ("top level.dof", "smartbed-codegen", "stated_degrees_of_freedom_are_compared"),
    ("top level.extends", "smartbed-codegen", "an_extension_takes_over_what_it_names"),
    ("parameters.unit", "smartbed-codegen", "numbers_are_in_the_declared_unit_and_expressions_in_their_own"),
    ("parameters.doc", "smartbed-tests", "emitted_text_equals_the_golden_files"),
    ("parameters.fixed", "smartbed-tests", "emitted_text_equals_the_golden_files"),
    ("parameters.range", "smartbed-tests", "parameters_outside_their_range_are_named"),
    ("joints.kind", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("joints.child", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("joints.parent", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("joints.at", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("joints.turned", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("joints.axis", "smartbed-codegen", "a_hinge_about_any_axis_is_a_physical_pendulum"),
    ("joints.axes", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("joints.radius", "smartbed-codegen", "a_rolling_disc_is_the_disc_by_hand"),
    ("joints.independent", "smartbed-codegen", "parallel_robots_move_as_lagrange_says"),
    ("joints.drive", "smartbed-codegen", "a_chain_of_joints_is_the_chain_of_frames_and_points"),
    ("bodies.density", "smartbed-codegen", "bodies_by_shape_have_the_mass_and_inertia_of_their_parts"),
    ("inputs.unit", "smartbed-codegen", "units_are_checked_at_the_subexpression"),
    ("inputs.doc", "smartbed-tests", "emitted_text_equals_the_golden_files"),
    ("coordinates.unit", "smartbed-codegen", "plain_numbers_are_in_the_unit_of_their_quantity"),
    ("coordinates.doc", "smartbed-tests", "emitted_text_equals_the_golden_files"),
    ("coordinates.independent", "smartbed-tests", "random_mechanisms_move_as_newton_and_euler_say"),
    ("coordinates.nominal", "smartbed-codegen", "plain_numbers_are_in_the_unit_of_their_quantity"),
    ("coordinates.range", "smartbed-codegen", "plain_numbers_are_in_the_unit_of_their_quantity"),
    ("coordinates.speed", "smartbed-tests", "random_mechanisms_move_as_newton_and_euler_say"),
    ("speeds.unit", "smartbed-codegen", "units_are_checked_at_the_subexpression"),
    ("speeds.doc", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("speeds.independent", "smartbed-tests", "random_mechanisms_move_as_newton_and_euler_say"),
    ("definitions.unit", "smartbed-codegen", "units_are_checked_at_the_subexpression"),
    ("definitions.doc", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("frames.z", "smartbed-tests", "newton_euler_agrees_at_random_states_and_parameters"),
    ("frames.euler", "smartbed-codegen", "a_free_joint_is_the_free_body_in_euler_parameters"),
    ("frames.fixed", "smartbed-codegen", "a_fixed_vector_may_be_a_definition_that_nothing_else_needs"),
    ("outputs.unit", "smartbed-codegen", "units_are_checked_at_the_subexpression"),
    ("outputs.doc", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("configurations.values", "smartbed-codegen", "plain_numbers_are_in_the_unit_of_their_quantity"),
    ("configurations.name", "smartbed-codegen", "rejected_models_have_their_exact_messages"),
    ("start", "smartbed-codegen", "plain_numbers_are_in_the_unit_of_their_quantity"),
    ("law", "smartbed-codegen", "plain_numbers_are_in_the_unit_of_their_quantity"),
    ("commanded", "smartbed-codegen", "rejected_models_have_their_exact_messages"),
    ("run.seconds", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("run.step", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("run.method", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("run.every", "smartbed-codegen", "every_model_is_read_without_a_finding"),
    ("ports.frame", "smartbed-codegen", "a_wrench_on_a_port_moves_it_as_its_inverse_inertia_says"),
    ("ports.point", "smartbed-codegen", "a_wrench_on_a_port_moves_it_as_its_inverse_inertia_says"),
    ("ports.doc", "smartbed-codegen", "every_model_is_read_without_a_finding"),
];

/// The fields that the manual's table of sections names, as `section.field`.
fn fields_of_the_manual() -> Vec<String> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/models.md");
    let text = std::fs::read_to_string(path).expect("the manual");
    let table = text.split("## Sections").nth(1).expect("sections").split("\n## ").next().unwrap_or_default();
    let mut fields = Vec::new();
    for row in table.lines().filter(|line| line.starts_with("| `[") || line.starts_with("| top level")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let section = cells[1].trim_matches(|c| "`[]".contains(c));
        if section.starts_with("repeat") {
            continue;
        }
        let words = cells[3].split('`').skip(1).step_by(2);
        let names: Vec<&str> = words.map(|word| word.split(' ').next().unwrap_or(word)).collect();
        match names.is_empty() {
            true => fields.push(section.to_owned()),
            false => fields.extend(names.iter().map(|name| format!("{section}.{name}"))),
        }
    }
    fields
}

#[test]
fn every_field_of_the_manual_has_a_test_that_reads_it() {
    let fields = fields_of_the_manual();
    assert!(fields.len() > 60, "{fields:?}");
    for (field, package, test) in ELSEWHERE {
        let folder = hard_table::folder(package, "it").expect(package);
        assert!(hard_table::tests(&folder).iter().any(|name| name == test), "{field}: no test `{test}`");
        assert!(fields.iter().any(|f| f == field), "{field} stands no longer in the manual");
    }
    let known = |f: &&String| {
        ELSEWHERE.iter().any(|(field, ..)| field == f) || CHANGES.iter().any(|(field, _)| field == f)
    };
    let unread: Vec<&String> = fields.iter().filter(|f| !known(f)).collect();
    assert!(unread.is_empty(), "no test reads {unread:?}: add a change of it, or name the test");
}

#[test]
fn a_change_of_any_field_is_seen_by_the_oracle() {
    let mut seen = BTreeSet::new();
    for seed in 0..SEEDS {
        for kind in KINDS {
            let d = draw::mechanism(kind, seed);
            // A mechanism that disagrees without a change cannot show whether the field is read.
            let as_it_is = verdict::of(&d, Settings::default(), 3, &mut Random::new(seed));
            if as_it_is.worst > verdict::AGREEMENT {
                continue;
            }
            for (field, change) in CHANGES {
                let mut changed = d.clone();
                if seen.contains(field) || !change(&mut changed) {
                    continue;
                }
                let text = text::model(&changed);
                let found = verdict::of_text(&d, &text, Settings::default(), 3, &mut Random::new(seed));
                // A refused text says nothing about how its field is read.
                if found.refusal.is_none() && found.worst > SEEN {
                    seen.insert(field);
                }
            }
        }
    }
    let unseen: Vec<&str> = CHANGES.iter().map(|(field, _)| *field).filter(|f| !seen.contains(f)).collect();
    assert!(unseen.is_empty(), "no oracle sees a change of {unseen:?}");
}
