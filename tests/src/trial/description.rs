//! Description of a random mechanism: one list for each section of a model; an index into a list stands for a name.

use super::expression::{Scalar, Value, Vector};

/// A parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Value in SI.
    pub value: f64,
    /// SI unit.
    pub unit: &'static str,
    /// Whether the derivation replaces it by its value.
    pub fixed: bool,
    /// Whether the nominal configuration still satisfies the constraints after a change of it.
    pub shape: bool,
}

/// A coordinate.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Whether it is an angle (otherwise a length).
    pub angle: bool,
    /// Unit in which the text gives its numbers.
    pub unit: &'static str,
    /// Nominal value (SI).
    pub nominal: f64,
    /// Half width of its range (SI).
    pub reach: f64,
    /// Independent in the constraints of configuration.
    pub independent: bool,
    /// Closed form in other coordinates, if any; it is then not part of the state.
    pub closed_form: Option<Scalar>,
}

/// A speed.
#[derive(Clone, Debug)]
pub struct Speed {
    /// The coordinate whose rate it is; none for an entry of `[speeds]`.
    pub of: Option<usize>,
    /// The same as an expression of rates.
    pub value: Scalar,
    /// Whether it is the rate of an angle (otherwise of a length).
    pub angle: bool,
    /// Independent, or given by constraints.
    pub independent: bool,
}

/// A frame.
#[derive(Clone, Debug)]
pub enum Frame {
    /// N.
    Inertial,
    /// Simple rotations from a parent: (axis, angle).
    Rotations(usize, Vec<(usize, Scalar)>),
    /// x and y as unit vectors.
    Directions(Vector, Vector),
}

/// A point.
#[derive(Clone, Debug)]
pub struct Point {
    /// From O.
    pub position: Vector,
    /// Other expressions of the same place.
    pub closures: Vec<Vector>,
    /// Its velocity, where no coordinates locate it.
    pub velocity: Option<Vector>,
}

/// A body: numbers are expressions of parameters.
#[derive(Clone, Debug)]
pub struct Body {
    /// Mass centre.
    pub centre: usize,
    /// Mass.
    pub mass: Option<Scalar>,
    /// Frame and Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
    pub inertia: Option<(usize, [Option<Scalar>; 6])>,
    /// Seen by gravity?
    pub weight: bool,
}

/// A load.
#[derive(Clone, Debug)]
pub enum Load {
    /// At a point, with the point that feels the reaction.
    Force(usize, Vector, Option<usize>),
    /// On a frame, with the frame that feels the reaction.
    Torque(usize, Vector, Option<usize>),
    /// Ends, stiffness, rest length, damping.
    Spring([usize; 2], Scalar, Scalar, Option<Scalar>),
    /// Coordinate, stiffness, rest, damping.
    CoordinateSpring(usize, Scalar, Scalar, Option<Scalar>),
}

/// Quantity defined by one step of the evaluation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Entity {
    /// A coordinate in closed form.
    Coordinate(usize),
    /// A definition of a number.
    Scalar(usize),
    /// A definition of a vector.
    Vector(usize),
    /// A frame.
    Frame(usize),
    /// A point.
    Point(usize),
}

/// A mechanism.
#[derive(Clone, Debug)]
pub struct Description {
    /// Kind and seed in words.
    pub title: String,
    /// Parameters.
    pub parameters: Vec<Parameter>,
    /// Units of the inputs.
    pub inputs: Vec<&'static str>,
    /// Coordinates.
    pub coordinates: Vec<Coordinate>,
    /// Speeds.
    pub speeds: Vec<Speed>,
    /// Definitions of numbers.
    pub scalars: Vec<Scalar>,
    /// Definitions of vectors.
    pub vectors: Vec<Vector>,
    /// Vectors declared as fixed in a frame, with their components there; these statements are redundant.
    pub fixed: Vec<(usize, Vector, [Scalar; 3])>,
    /// Frames; the first is N.
    pub frames: Vec<Frame>,
    /// Points; the first is O.
    pub points: Vec<Point>,
    /// An order of evaluation in which each entry uses only earlier ones.
    pub order: Vec<Entity>,
    /// Bodies.
    pub bodies: Vec<Body>,
    /// Constraints of configuration, closures apart.
    pub configuration: Vec<Value>,
    /// Constraints of motion.
    pub motion: Vec<Value>,
    /// Gravity.
    pub gravity: Option<Vector>,
    /// Loads.
    pub loads: Vec<Load>,
    /// Outputs.
    pub outputs: Vec<Scalar>,
    /// Configurations to be sampled: values of independent coordinates.
    pub configurations: Vec<Vec<(usize, f64)>>,
}

impl Description {
    /// N and O alone.
    #[must_use]
    pub fn empty(title: String) -> Self {
        let origin = Vector::Axis(0, 0).scaled(Scalar::Literal(0.0, "m"));
        Self {
            title,
            parameters: Vec::new(),
            inputs: Vec::new(),
            coordinates: Vec::new(),
            speeds: Vec::new(),
            scalars: Vec::new(),
            vectors: Vec::new(),
            fixed: Vec::new(),
            frames: vec![Frame::Inertial],
            points: vec![Point { position: origin, closures: Vec::new(), velocity: None }],
            order: Vec::new(),
            bodies: Vec::new(),
            configuration: Vec::new(),
            motion: Vec::new(),
            gravity: None,
            loads: Vec::new(),
            outputs: Vec::new(),
            configurations: Vec::new(),
        }
    }

    /// Coordinates that are state.
    #[must_use]
    pub fn state(&self) -> Vec<usize> {
        (0..self.coordinates.len()).filter(|&i| self.coordinates[i].closed_form.is_none()).collect()
    }

    /// Speeds that are state.
    #[must_use]
    pub fn independent_speeds(&self) -> Vec<usize> {
        (0..self.speeds.len()).filter(|&i| self.speeds[i].independent).collect()
    }

    /// Does any equation restrict the configuration?
    #[must_use]
    pub fn is_constrained(&self) -> bool {
        !self.configuration.is_empty()
            || self.points.iter().any(|p| !p.closures.is_empty())
            || self.coordinates.iter().any(|c| c.closed_form.is_some())
    }

    /// Adds a frame.
    pub fn frame(&mut self, frame: Frame) -> usize {
        self.frames.push(frame);
        self.order.push(Entity::Frame(self.frames.len() - 1));
        self.frames.len() - 1
    }

    /// Adds a point that coordinates locate.
    pub fn point(&mut self, position: Vector) -> usize {
        self.points.push(Point { position, closures: Vec::new(), velocity: None });
        self.order.push(Entity::Point(self.points.len() - 1));
        self.points.len() - 1
    }

    /// Adds a definition of a number.
    pub fn define(&mut self, value: Scalar) -> Scalar {
        self.scalars.push(value);
        self.order.push(Entity::Scalar(self.scalars.len() - 1));
        Scalar::Definition(self.scalars.len() - 1)
    }

    /// Adds a definition of a vector.
    pub fn define_vector(&mut self, value: Vector) -> Vector {
        self.vectors.push(value);
        self.order.push(Entity::Vector(self.vectors.len() - 1));
        Vector::Definition(self.vectors.len() - 1)
    }

    /// Nominal coordinates, closed forms left at their stated values.
    #[must_use]
    pub fn nominal(&self) -> Vec<f64> {
        self.coordinates.iter().map(|c| c.nominal).collect()
    }

    /// Values of all parameters.
    #[must_use]
    pub fn parameter_values(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.value).collect()
    }
}
