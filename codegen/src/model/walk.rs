//! Lists every expression of a model with its role; all checks and passes use this one list.
//!
//! In: a [`Model`]. Out: pairs of [`Role`] and [`Expr`]. Every struct is destructured field by field, so that a new
//! field does not compile until this file says whether it holds an expression; a new role does not compile until the
//! checks of units and dependences say what they require of it.

use super::data::*;
use super::expression::Expr;
use super::ids::*;

/// What an expression states in the model.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    /// A parameter's default.
    Parameter(ParameterId),
    /// A definition.
    Definition(DefinitionId),
    /// A part of a frame's orientation: an angle, a unit vector.
    Orientation(FrameId, OrientationPart),
    /// A vector fixed in a frame, by its index among them.
    FixedVector(FrameId, usize),
    /// A component of that vector.
    FixedComponent(FrameId, usize),
    /// A point's position.
    Position(PointId),
    /// Another expression for a point's position, which closes a loop.
    Closure(PointId),
    /// A point's velocity, where the model states it.
    StatedVelocity(PointId),
    /// A body's mass.
    Mass(BodyId),
    /// An entry of a body's inertia matrix.
    Inertia(BodyId),
    /// A configuration constraint.
    ConfigurationConstraint,
    /// A motion constraint.
    MotionConstraint,
    /// Gravity.
    Gravity,
    /// A coordinate in closed form.
    ClosedForm(CoordinateId),
    /// A coordinate's nominal value or an end of its range.
    Nominal(CoordinateId),
    /// A speed as a combination of rates.
    Speed(SpeedId),
    /// A start value.
    Start(StartRef),
    /// A coordinate of a configuration that is sampled.
    Configuration(CoordinateId),
    /// The law of an input.
    Law(InputId),
    /// A coordinate by what a scene may command in its place.
    Commanded(CoordinateId),
    /// A force.
    Force,
    /// A torque.
    Torque,
    /// Stiffness of a spring between points.
    Stiffness,
    /// Its rest length.
    RestLength,
    /// Its damping.
    Damping,
    /// Stiffness of a spring on a coordinate.
    CoordinateStiffness(CoordinateId),
    /// Its value at rest.
    CoordinateRest(CoordinateId),
    /// Its damping.
    CoordinateDamping(CoordinateId),
    /// An output, by its index.
    Output(usize),
    /// A length of a shape that pictures show.
    Size,
}

/// The list under construction.
pub type List<'m> = Vec<(Role, &'m Expr)>;

impl Model {
    /// Every expression of the model.
    #[must_use]
    pub fn expressions(&self) -> Vec<(Role, &Expr)> {
        #[rustfmt::skip]
        let Self {
            parameters, coordinates, speeds, definitions, frames, points, bodies, configuration_constraints,
            motion_constraints, gravity, loads, outputs, configurations, start_written, laws, commanded,
            source: _, name: _, doc: _, dof: _, inputs: _, ports: _, order: _, start: _, run: _, view,
        } = self;
        let mut all = Vec::new();
        for (id, parameter) in parameters.enumerate() {
            let Parameter { value, name: _, doc: _, unit: _, written_unit: _, tunable: _, range: _, span: _ } =
                parameter;
            all.push((Role::Parameter(id), value));
        }
        for (id, Definition { value, name: _, written_unit: _, span: _ }) in definitions.enumerate() {
            all.push((Role::Definition(id), value));
        }
        frames.enumerate().for_each(|(id, frame)| of_frame(id, frame, &mut all));
        for (id, Point { position, closures, velocity, name: _, span: _ }) in points.enumerate() {
            all.push((Role::Position(id), position));
            all.extend(closures.iter().map(|e| (Role::Closure(id), e)));
            all.extend(velocity.iter().map(|e| (Role::StatedVelocity(id), e)));
        }
        for (id, body) in bodies.enumerate() {
            // The lengths of its shape are in its mass or inertia already.
            let Body { mass, inertia, lengths: _, name: _, centre: _, frame: _, weight: _, span: _ } = body;
            all.extend(mass.iter().map(|e| (Role::Mass(id), e)));
            all.extend(inertia.iter().flatten().map(|e| (Role::Inertia(id), e)));
        }
        for Constraint { expression, name: _, unit: _, span: _ } in configuration_constraints {
            all.push((Role::ConfigurationConstraint, expression));
        }
        for Constraint { expression, name: _, unit: _, span: _ } in motion_constraints {
            all.push((Role::MotionConstraint, expression));
        }
        all.extend(gravity.iter().map(|e| (Role::Gravity, e)));
        coordinates.enumerate().for_each(|(id, coordinate)| of_coordinate(id, coordinate, &mut all));
        for (id, Speed { meaning, name: _, unit: _, independent: _, span: _ }) in speeds.enumerate() {
            match meaning {
                SpeedMeaning::RateOf(_) => {}
                SpeedMeaning::Combination(e) => all.push((Role::Speed(id), e)),
            }
        }
        all.extend(start_written.iter().map(|(of, e)| (Role::Start(*of), e)));
        for Configuration { written, name: _, values: _ } in configurations {
            all.extend(written.iter().map(|(id, e)| (Role::Configuration(*id), e)));
        }
        all.extend(laws.iter().map(|(id, e)| (Role::Law(*id), e)));
        for Commanded { coordinate, value, written: _ } in commanded {
            all.push((Role::Commanded(*coordinate), value));
        }
        loads.iter().for_each(|Load { kind, name: _, span: _ }| of_load(kind, &mut all));
        for (n, Output { value, name: _, unit: _, span: _ }) in outputs.iter().enumerate() {
            all.push((Role::Output(n), value));
        }
        let View { shapes, colours: _, hidden: _, links: _ } = view;
        for (_, Shape { sizes, kind: _, axis: _, at: _ }) in shapes {
            all.extend(sizes.iter().map(|e| (Role::Size, e)));
        }
        all
    }
}

fn of_frame<'m>(id: FrameId, frame: &'m Frame, all: &mut List<'m>) {
    let Frame { orientation, fixed_vectors, name: _, span: _ } = frame;
    let parts = orientation.expressions().into_iter();
    all.extend(parts.map(|(part, expression)| (Role::Orientation(id, part), expression)));
    for (n, FixedVector { vector, components, span: _ }) in fixed_vectors.iter().enumerate() {
        all.push((Role::FixedVector(id, n), vector));
        all.extend(components.iter().map(|e| (Role::FixedComponent(id, n), e)));
    }
}

fn of_coordinate<'m>(id: CoordinateId, coordinate: &'m Coordinate, all: &mut List<'m>) {
    #[rustfmt::skip]
    let Coordinate {
        closed_form, written,
        name: _, doc: _, unit: _, written_unit: _, independent: _, nominal: _, range: _, span: _,
    } = coordinate;
    all.extend(closed_form.iter().map(|e| (Role::ClosedForm(id), e)));
    all.extend(written.iter().flatten().map(|e| (Role::Nominal(id), e)));
}

impl LoadKind {
    /// Its expressions.
    #[must_use]
    pub fn expressions(&self) -> List<'_> {
        let mut all = List::new();
        of_load(self, &mut all);
        all
    }
}

fn of_load<'m>(kind: &'m LoadKind, all: &mut List<'m>) {
    match kind {
        LoadKind::Force { force, point: _, reaction: _ } => all.push((Role::Force, force)),
        LoadKind::Torque { torque, frame: _, reaction: _ } => all.push((Role::Torque, torque)),
        LoadKind::Spring { stiffness, rest_length, damping, ends: _ } => {
            all.extend([(Role::Stiffness, stiffness), (Role::RestLength, rest_length)]);
            all.extend(damping.iter().map(|e| (Role::Damping, e)));
        }
        LoadKind::CoordinateSpring { coordinate, stiffness, rest, damping } => {
            let of = *coordinate;
            all.extend([(Role::CoordinateStiffness(of), stiffness), (Role::CoordinateRest(of), rest)]);
            all.extend(damping.iter().map(|e| (Role::CoordinateDamping(of), e)));
        }
    }
}
