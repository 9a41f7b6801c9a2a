//! Positions of the shipped tiles, computed from the model's own trees, against the reference values.
//!
//! The evaluator here uses f64 vectors and does not depend on the generator's expression graph.

use crate::reactions::cross;
use smartbed_codegen::id::{Id, IdVec};
use smartbed_codegen::model::expression::{ExprKind, Function};
use smartbed_codegen::model::{
    Axis, CoordinateId, DefinitionId, Entity, Expr, FrameId, Model, Orientation, ParameterId, PointId,
};

use crate::models::shipped;

/// Lengths below 0.3 m and angles below 1 rad, some fifty rounded operations each.
const ROUNDING: f64 = 1e-14;

type Vector = [f64; 3];

#[derive(Clone, Copy, Debug)]
enum Value {
    Scalar(f64),
    Vector(Vector),
}

impl Value {
    fn scalar(self) -> f64 {
        if let Self::Scalar(x) = self { x } else { panic!("a scalar is expected") }
    }
    fn vector(self) -> Vector {
        if let Self::Vector(x) = self { x } else { panic!("a vector is expected") }
    }
}

fn scaled(v: Vector, s: f64) -> Vector {
    v.map(|x| x * s)
}
fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
/// Everything that has a value at one configuration.
struct Place<'a> {
    model: &'a Model,
    q: IdVec<CoordinateId, f64>,
    parameters: IdVec<ParameterId, f64>,
    definitions: IdVec<DefinitionId, Value>,
    frames: IdVec<FrameId, [Vector; 3]>,
    points: IdVec<PointId, Vector>,
}

impl<'a> Place<'a> {
    /// `state`: the coordinates without closed form.
    fn at(model: &'a Model, state: &[f64]) -> Self {
        let mut state = state.iter().copied();
        let mut given = |closed: bool| if closed { f64::NAN } else { state.next().expect("a coordinate") };
        let q = model.coordinates.iter().map(|c| given(c.closed_form.is_some())).collect();
        let mut place = Self {
            model,
            q,
            parameters: model.parameter_defaults(),
            definitions: model.definitions.iter().map(|_| Value::Scalar(f64::NAN)).collect(),
            frames: model.frames.iter().map(|_| [[f64::NAN; 3]; 3]).collect(),
            points: model.points.iter().map(|_| [f64::NAN; 3]).collect(),
        };
        for entity in &model.order {
            match *entity {
                Entity::Parameter(_) => {}
                Entity::Coordinate(id) => {
                    if let Some(form) = &model.coordinates[id].closed_form {
                        place.q[id] = place.value(form).scalar();
                    }
                }
                Entity::Definition(id) => place.definitions[id] = place.value(&model.definitions[id].value),
                Entity::Frame(id) => place.frames[id] = place.frame(&model.frames[id].orientation),
                Entity::Point(id) => place.points[id] = place.value(&model.points[id].position).vector(),
            }
        }
        place
    }

    fn frame(&self, orientation: &Orientation) -> [Vector; 3] {
        match orientation {
            Orientation::Inertial => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Orientation::Rotations { parent, rotations } => {
                let mut axes = self.frames[*parent];
                for (axis, angle) in rotations {
                    let (s, c) = self.value(angle).scalar().sin_cos();
                    let (i, j) = match axis {
                        Axis::X => (1, 2),
                        Axis::Y => (2, 0),
                        Axis::Z => (0, 1),
                    };
                    let (a, b) = (axes[i], axes[j]);
                    axes[i] = plus(scaled(a, c), scaled(b, s));
                    axes[j] = plus(scaled(b, c), scaled(a, -s));
                }
                axes
            }
            // v + 2 e x (e x v + e0 v), e along the parent's axes.
            Orientation::Euler { parent, parameters } => {
                let [e0, e1, e2, e3] = parameters.each_ref().map(|e| self.value(e).scalar());
                let axes = self.frames[*parent];
                let e = plus(plus(scaled(axes[0], e1), scaled(axes[1], e2)), scaled(axes[2], e3));
                axes.map(|v| plus(v, scaled(cross(e, plus(cross(e, v), scaled(v, e0))), 2.0)))
            }
            Orientation::Directions { axes } => {
                let [x, y, _] = axes.each_ref().map(|a| a.as_ref().map(|a| self.value(a).vector()));
                let (x, y) = (x.expect("x is given"), y.expect("y is given"));
                [x, y, cross(x, y)]
            }
        }
    }

    fn value(&self, expr: &Expr) -> Value {
        use Value::{Scalar, Vector};
        let scalar = |e: &Expr| self.value(e).scalar();
        let vector = |e: &Expr| self.value(e).vector();
        match &expr.kind {
            ExprKind::Number(x) => Scalar(*x),
            ExprKind::Pi => Scalar(std::f64::consts::PI),
            ExprKind::Degree => Scalar(1.0_f64.to_radians()),
            ExprKind::Parameter(id) => Scalar(self.parameters[*id]),
            ExprKind::Coordinate(id) => Scalar(self.q[*id]),
            ExprKind::Definition(id) => self.definitions[*id],
            ExprKind::Point(id) => Vector(self.points[*id]),
            ExprKind::Axis(id, axis) => Vector(self.frames[*id][*axis as usize]),
            ExprKind::Negate(a) => match self.value(a) {
                Scalar(x) => Scalar(-x),
                Vector(x) => Vector(scaled(x, -1.0)),
            },
            ExprKind::Add(a, b) => match (self.value(a), self.value(b)) {
                (Scalar(x), Scalar(y)) => Scalar(x + y),
                (x, y) => Vector(plus(x.vector(), y.vector())),
            },
            ExprKind::Subtract(a, b) => match (self.value(a), self.value(b)) {
                (Scalar(x), Scalar(y)) => Scalar(x - y),
                (x, y) => Vector(plus(x.vector(), scaled(y.vector(), -1.0))),
            },
            ExprKind::Multiply(a, b) => match (self.value(a), self.value(b)) {
                (Scalar(x), Scalar(y)) => Scalar(x * y),
                (Scalar(s), Vector(v)) | (Vector(v), Scalar(s)) => Vector(scaled(v, s)),
                _ => panic!("two vectors"),
            },
            ExprKind::Divide(a, b) => match self.value(a) {
                Scalar(x) => Scalar(x / scalar(b)),
                Vector(x) => Vector(scaled(x, 1.0 / scalar(b))),
            },
            ExprKind::Power(a, n) => Scalar(scalar(a).powi(*n)),
            ExprKind::Dot(a, b) => Scalar(dot(vector(a), vector(b))),
            ExprKind::Cross(a, b) => Vector(cross(vector(a), vector(b))),
            ExprKind::Norm(a) => Scalar(dot(vector(a), vector(a)).sqrt()),
            ExprKind::Call(function, arguments) => {
                let x = scalar(&arguments[0]);
                Scalar(match function {
                    Function::Sin => x.sin(),
                    Function::Cos => x.cos(),
                    Function::Asin => x.asin(),
                    Function::Sqrt => x.sqrt(),
                    Function::Atan2 => x.atan2(scalar(&arguments[1])),
                    other => panic!("{other:?} is not needed for positions"),
                })
            }
            other => panic!("{other:?} is no position"),
        }
    }

    fn coordinate(&self, name: &str) -> CoordinateId {
        self.model.coordinates.enumerate().find(|(_, c)| c.name == name).expect("a coordinate").0
    }
}

fn assert_close(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= ROUNDING, "{what}: {a} against {b}, off by {:e}", a - b);
}

fn assert_right_handed(axes: &[Vector; 3]) {
    for i in 0..3 {
        for j in 0..3 {
            assert_close(dot(axes[i], axes[j]), f64::from(u8::from(i == j)), "orthonormality");
        }
    }
    assert_close(dot(cross(axes[0], axes[1]), axes[2]), 1.0, "handedness");
}

/// Heights, and Gx Gy Gz psiA thA sA psiB thB sB psiC thC sC there.
#[rustfmt::skip]
const MINIMAL: [([f64; 3], [f64; 12]); 4] = [
    ([0.19740698592486167, 0.07996705046214557, 0.2166857768043045],
     [0.005586141951583231, 0.005931024796872778, 0.16786163058782927, 0.028776366432785135, -0.15101981442634949, 0.19638457205260998, 0.01127628085238388, 0.40012730861243817, 0.22563940380079, -0.04000074995716194, -0.24142771815226316, 0.20420893201449308]),
    ([0.14128968467408945, 0.12391928541219394, 0.13145959992845746],
     [9.863216683931439e-05, -7.898666057715388e-05, 0.13222142280691615, 0.0004929661055157464, -0.045292407688663244, 0.20028440779231763, -0.0005884674964888641, 0.04147734831386498, 0.2002181592794409, 9.550150179140693e-05, 0.0038114764116787105, 0.1998765414558055]),
    ([0.19059002371156258, 0.05106545125140534, 0.20798466865997484],
     [0.007654446868624535, 0.007261801390342083, 0.15482554977236615, 0.039693358561691205, -0.18333174887597944, 0.19617772900181102, 0.01170726900573651, 0.45839491306176877, 0.2344811736909898, -0.05130533008913283, -0.26323223155459796, 0.20429879671504153]),
    ([0.20155629036987754, 0.08921300038760034, 0.2268899812829689],
     [0.00497389160542702, 0.006363154332498602, 0.17545266940877693, 0.025681053033592027, -0.13395561428525407, 0.19545169895665554, 0.014571818813598614, 0.3938738690597392, 0.22471792831131995, -0.040192733141562555, -0.2529004280487537, 0.20557395422503394]),
];

/// Configurations on the loops: hA psiA thA sA hB ...
#[rustfmt::skip]
const TILE: [[f64; 12]; 3] = [
    [-0.033505052016680206, 0.001301598071505735, 0.16429616629983507, 0.20408338343474794, 0.01897669242175673, -0.006449843643393413, -0.09542946582766228, 0.20047576720635607, 0.013499994040472058, 0.005148418455910877, -0.06832647806120824, 0.19957388117169994],
    [-0.02639436365037895, 0.0008589202704901693, -0.016221593123857743, 0.1994775704510877, -0.049681936938970286, 0.0019437549174725571, 0.09971587830655053, 0.20142368792619209, -0.012895330836789225, -0.002802656471519495, -0.0834265696896722, 0.2008252646076005],
    [0.049756120886931585, 0.0012483097416490486, -0.06343146241596359, 0.20052789019185915, 0.02386877519689609, -0.001162542213478404, 0.0657348629222596, 0.20058747771652224, 0.03750395209101519, -8.576802604103934e-05, -0.0022985999673700956, 0.1997219538753469],
];

#[test]
fn closed_forms_of_the_minimal_tile_agree_with_the_reference() {
    let model = shipped("tile_minimal");
    for (h, expected) in &MINIMAL {
        let place = Place::at(&model, h);
        place.frames.iter().for_each(assert_right_handed);
        for (output, expected) in model.outputs.iter().zip(expected) {
            assert_close(place.value(&output.value).scalar(), *expected, &output.name);
        }
    }
}

#[test]
fn loops_of_the_tile_close_at_the_reference_configurations() {
    let model = shipped("tile");
    for q in &TILE {
        let place = Place::at(&model, q);
        place.frames.iter().for_each(assert_right_handed);
        for point in model.points.iter() {
            for closure in &point.closures {
                let (a, b) = (place.value(&point.position).vector(), place.value(closure).vector());
                (0..3).for_each(|i| assert_close(a[i], b[i], &point.name));
            }
        }
        let rods = place.value(&model.configuration_constraints[0].expression).vector();
        rods.iter().for_each(|x| assert_close(*x, 0.0, "rods"));
    }
}

#[test]
fn vectors_stated_to_be_fixed_in_the_platform_are_fixed() {
    let model = shipped("tile");
    let (_, platform) = model.frames.enumerate().find(|(_, f)| f.name == "platform").expect("the platform");
    for q in &TILE {
        let place = Place::at(&model, q);
        let axes = place.frame(&platform.orientation);
        for fixed in &platform.fixed_vectors {
            let vector = place.value(&fixed.vector).vector();
            for (axis, component) in axes.iter().zip(&fixed.components) {
                assert_close(dot(*axis, vector), place.value(component).scalar(), "component");
            }
        }
    }
}

#[test]
fn both_tiles_have_the_same_connector_frames_and_centre() {
    let (tile, minimal) = (shipped("tile"), shipped("tile_minimal"));
    for q in &TILE {
        let full = Place::at(&tile, q);
        let heights = ["hA", "hB", "hC"].map(|name| q[full.coordinate(name).index()]);
        let closed = Place::at(&minimal, &heights);
        for name in ["connectorA", "connectorB", "connectorC", "platform"] {
            let of =
                |model: &Model| model.frames.enumerate().find(|(_, f)| f.name == name).expect("a frame").0;
            for (a, b) in full.frames[of(&tile)].iter().zip(&closed.frames[of(&minimal)]) {
                (0..3).for_each(|i| assert_close(a[i], b[i], name));
            }
        }
        let centre = |model: &Model| model.points.enumerate().find(|(_, p)| p.name == "G").expect("G").0;
        let (a, b) = (full.points[centre(&tile)], closed.points[centre(&minimal)]);
        (0..3).for_each(|i| assert_close(a[i], b[i], "G"));
    }
}
