//! A drawn mechanism as the text of a model.

use super::description::{Body, Description, Frame, Load, Point};
use super::expression::{Function, Pair, Scalar, Value, Vector, si};
use std::fmt::Write as _;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Name of a frame: N is the first.
fn frame(i: usize) -> String {
    if i == 0 { "N".to_owned() } else { format!("f{i}") }
}

/// Name of a point: O is the first.
fn point(i: usize) -> String {
    if i == 0 { "O".to_owned() } else { format!("P{i}") }
}

/// Name of a speed.
#[must_use]
pub fn speed(description: &Description, i: usize) -> String {
    description.speeds[i].of.map_or_else(|| format!("w{i}"), |q| format!("u_q{q}"))
}

/// Writes expressions of one description.
struct Writer<'a>(&'a Description);

impl Writer<'_> {
    fn scalar(&self, e: &Scalar) -> String {
        match e {
            Scalar::Literal(value, unit) => literal(*value, unit),
            Scalar::Parameter(i) => format!("p{i}"),
            Scalar::Input(i) => format!("i{i}"),
            Scalar::Coordinate(i) => format!("q{i}"),
            Scalar::Speed(i) => speed(self.0, *i),
            Scalar::Rate(i) => format!("q_dot(q{i})"),
            Scalar::Definition(i) => format!("s{i}"),
            Scalar::Time => "t".to_owned(),
            Scalar::Sum(a, b) => format!("({} + {})", self.scalar(a), self.scalar(b)),
            Scalar::Difference(a, b) => format!("({} - {})", self.scalar(a), self.scalar(b)),
            Scalar::Product(a, b) => format!("{}*{}", self.scalar(a), self.scalar(b)),
            Scalar::Quotient(a, b) => format!("{}/({})", self.scalar(a), self.scalar(b)),
            Scalar::Call(function, a) => format!("{}({})", name(*function), self.scalar(a)),
            Scalar::CallTwo(pair, a, b) => {
                format!("{}({}, {})", name_of_pair(*pair), self.scalar(a), self.scalar(b))
            }
            Scalar::Power(a, n) => format!("({}).powi({n})", self.scalar(a)),
            Scalar::Dot(a, b) => format!("dot({}, {})", self.vector(a), self.vector(b)),
            Scalar::Norm(a) => format!("norm({})", self.vector(a)),
        }
    }

    fn vector(&self, e: &Vector) -> String {
        match e {
            Vector::Axis(of, axis) => format!("{}.{}", frame(*of), AXES[*axis]),
            Vector::Point(i) => point(*i),
            Vector::Definition(i) => format!("v{i}"),
            Vector::Velocity(i) => format!("velocity({})", point(*i)),
            Vector::AngularVelocity(i) => format!("angular_velocity({})", frame(*i)),
            Vector::Sum(a, b) => format!("({} + {})", self.vector(a), self.vector(b)),
            Vector::Difference(a, b) => format!("({} - {})", self.vector(a), self.vector(b)),
            Vector::Scaled(s, a) => format!("{}*{}", self.scalar(s), self.vector(a)),
            Vector::Cross(a, b) => format!("cross({}, {})", self.vector(a), self.vector(b)),
        }
    }

    fn value(&self, e: &Value) -> String {
        match e {
            Value::Scalar(scalar) => self.scalar(scalar),
            Value::Vector(vector) => self.vector(vector),
        }
    }

    fn point(&self, p: &Point) -> String {
        let mut text = format!("{{ position = \"{}\"", self.vector(&p.position));
        if !p.closures.is_empty() {
            let closures: Vec<String> =
                p.closures.iter().map(|c| format!("\"{}\"", self.vector(c))).collect();
            let _ = write!(text, ", closures = [{}]", closures.join(", "));
        }
        if let Some(velocity) = &p.velocity {
            let _ = write!(text, ", velocity = \"{}\"", self.vector(velocity));
        }
        text + " }"
    }

    fn frame(&self, i: usize) -> String {
        match &self.0.frames[i] {
            Frame::Inertial => String::new(),
            Frame::Rotations(parent, steps) => {
                let step = |(axis, angle): &(usize, Scalar)| {
                    format!("[\"{}\", \"{}\"]", AXES[*axis], self.scalar(angle))
                };
                let steps: Vec<String> = steps.iter().map(step).collect();
                format!("{{ parent = \"{}\", rotations = [{}] }}", frame(*parent), steps.join(", "))
            }
            Frame::Directions(x, y) => {
                let fixed = self.fixed(i);
                format!("{{ x = \"{}\", y = \"{}\"{fixed} }}", self.vector(x), self.vector(y))
            }
        }
    }

    fn fixed(&self, of: usize) -> String {
        let stated = self.0.fixed.iter().filter(|(frame, ..)| *frame == of).map(|(_, vector, components)| {
            let components: Vec<String> =
                components.iter().map(|c| format!("\"{}\"", self.scalar(c))).collect();
            format!("{{ vector = \"{}\", components = [{}] }}", self.vector(vector), components.join(", "))
        });
        let stated: Vec<String> = stated.collect();
        if stated.is_empty() { String::new() } else { format!(", fixed = [{}]", stated.join(", ")) }
    }

    fn body(&self, b: &Body) -> String {
        let mut text = format!("{{ centre = \"{}\"", point(b.centre));
        if let Some(mass) = &b.mass {
            let _ = write!(text, ", mass = \"{}\"", self.scalar(mass));
        }
        if let Some((of, moments)) = &b.inertia {
            let names = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"];
            let given = names.iter().zip(moments).filter_map(|(name, moment)| {
                moment.as_ref().map(|m| format!("{name} = \"{}\"", self.scalar(m)))
            });
            let given: Vec<String> = given.collect();
            let _ = write!(text, ", frame = \"{}\", inertia = {{ {} }}", frame(*of), given.join(", "));
        }
        text + if b.weight { " }" } else { ", weight = false }" }
    }

    fn load(&self, load: &Load) -> (&'static str, String) {
        let damped = |d: &Option<Scalar>| {
            d.as_ref().map_or_else(String::new, |d| format!(", damping = \"{}\"", self.scalar(d)))
        };
        match load {
            Load::Force(at, force, reaction) => {
                let reaction =
                    reaction.map_or_else(String::new, |p| format!(", reaction = \"{}\"", point(p)));
                let force = self.vector(force);
                ("forces", format!("{{ point = \"{}\", force = \"{force}\"{reaction} }}", point(*at)))
            }
            Load::Torque(on, torque, reaction) => {
                let reaction =
                    reaction.map_or_else(String::new, |f| format!(", reaction = \"{}\"", frame(f)));
                let torque = self.vector(torque);
                ("torques", format!("{{ frame = \"{}\", torque = \"{torque}\"{reaction} }}", frame(*on)))
            }
            Load::Spring([a, b], stiffness, rest, damping) => {
                let (stiffness, rest, damping) = (self.scalar(stiffness), self.scalar(rest), damped(damping));
                let ends = format!("[\"{}\", \"{}\"]", point(*a), point(*b));
                let text = format!(
                    "{{ between = {ends}, stiffness = \"{stiffness}\", rest_length = \"{rest}\"{damping} }}"
                );
                ("springs", text)
            }
            Load::CoordinateSpring(q, stiffness, rest, damping) => {
                let (stiffness, damping) = (self.scalar(stiffness), damped(damping));
                // A plain number is in the coordinate's own unit.
                let rest = match rest {
                    Scalar::Literal(value, _) => format!("{:?}", value / si(self.0.coordinates[*q].unit)),
                    other => format!("\"{}\"", self.scalar(other)),
                };
                (
                    "springs",
                    format!(
                        "{{ coordinate = \"q{q}\", stiffness = \"{stiffness}\", rest = {rest}{damping} }}"
                    ),
                )
            }
        }
    }
}

/// A literal as the language writes it; a negative one in parentheses.
fn literal(value: f64, unit: &str) -> String {
    let unit = if unit.is_empty() { String::new() } else { format!("_{unit}") };
    let size = format!("{:?}{unit}", value.abs());
    if value < 0.0 { format!("(-{size})") } else { size }
}

fn name(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Sqrt => "sqrt",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Tanh => "tanh",
        Function::Abs => "abs",
        Function::Sign => "sign",
    }
}

fn name_of_pair(pair: Pair) -> &'static str {
    match pair {
        Pair::Atan2 => "atan2",
        Pair::Min => "min",
        Pair::Max => "max",
        Pair::SmoothStep => "smooth_step",
    }
}

/// The coordinate's entry, numbers in its own unit.
fn coordinate(writer: &Writer<'_>, i: usize) -> String {
    let d = writer.0;
    let c = &d.coordinates[i];
    let mut text = format!("{{ unit = \"{}\"", c.unit);
    let own = d.speeds.iter().find(|s| s.of == Some(i));
    if let Some(form) = &c.closed_form {
        let _ = write!(text, ", closed_form = \"{}\"", writer.scalar(form));
    } else {
        let si = si(c.unit);
        let range = [c.nominal - c.reach, c.nominal + c.reach].map(|x| x / si);
        let _ = write!(text, ", nominal = {:?}, range = {range:?}", c.nominal / si);
        if d.is_constrained() {
            let _ = write!(text, ", independent = {}", c.independent);
        }
        match own {
            None => text.push_str(", speed = false"),
            Some(speed) if speed.independent != c.independent => {
                let _ = write!(text, ", speed = {{ independent = {} }}", speed.independent);
            }
            Some(_) => {}
        }
    }
    text + " }"
}

/// The model.
#[must_use]
pub fn model(d: &Description) -> String {
    let writer = Writer(d);
    let mut text = format!("format = 1\nname = \"trial\"\ndoc = \"{}\"\n", d.title);
    let _ = writeln!(text, "dof = {}", d.independent_speeds().len());
    if let Some(gravity) = &d.gravity {
        let _ = writeln!(text, "gravity = \"{}\"", writer.vector(gravity));
    }
    let mut section = |name: &str, entries: Vec<(String, String)>| {
        if !entries.is_empty() {
            let _ = writeln!(text, "\n[{name}]");
        }
        for (key, value) in entries {
            let _ = writeln!(text, "{key} = {value}");
        }
    };
    let named = |prefix: &str, list: Vec<String>| -> Vec<(String, String)> {
        list.into_iter().enumerate().map(|(i, value)| (format!("{prefix}{i}"), value)).collect()
    };
    let parameter = |p: &super::description::Parameter| {
        let fixed = if p.fixed { ", fixed = true" } else { "" };
        format!("{{ value = {:?}, unit = \"{}\"{fixed} }}", p.value, p.unit)
    };
    let quoted = |text: String| format!("\"{text}\"");
    section("parameters", named("p", d.parameters.iter().map(parameter).collect()));
    section("inputs", named("i", d.inputs.iter().map(|unit| format!("{{ unit = \"{unit}\" }}")).collect()));
    section("coordinates", named("q", (0..d.coordinates.len()).map(|i| coordinate(&writer, i)).collect()));
    let combinations = (0..d.speeds.len()).filter(|&i| d.speeds[i].of.is_none()).map(|i| {
        let (value, independent) = (writer.scalar(&d.speeds[i].value), d.speeds[i].independent);
        let unit = if d.speeds[i].angle { "rad/s" } else { "m/s" };
        let entry = format!("{{ unit = \"{unit}\", value = \"{value}\", independent = {independent} }}");
        (speed(d, i), entry)
    });
    section("speeds", combinations.collect());
    let mut definitions = named("s", d.scalars.iter().map(|e| quoted(writer.scalar(e))).collect());
    definitions.extend(named("v", d.vectors.iter().map(|e| quoted(writer.vector(e))).collect()));
    section("definitions", definitions);
    let frames = (1..d.frames.len()).map(|i| (frame(i), writer.frame(i)));
    section("frames", frames.collect());
    section("points", (1..d.points.len()).map(|i| (point(i), writer.point(&d.points[i]))).collect());
    section("bodies", named("b", d.bodies.iter().map(|b| writer.body(b)).collect()));
    let rows = |list: &[Value]| list.iter().map(|row| quoted(writer.value(row))).collect();
    section("constraints.configuration", named("c", rows(&d.configuration)));
    section("constraints.motion", named("m", rows(&d.motion)));
    for kind in ["forces", "torques", "springs"] {
        let loads = d.loads.iter().map(|load| writer.load(load)).filter(|(of, _)| *of == kind);
        section(kind, named("l", loads.map(|(_, text)| text).collect()));
    }
    section("outputs", named("y", d.outputs.iter().map(|e| quoted(writer.scalar(e))).collect()));
    for values in &d.configurations {
        let given: Vec<String> = values
            .iter()
            .map(|(i, value)| {
                format!("q{i} = \"{}\"", {
                    let unit = if d.coordinates[*i].angle { "" } else { "m" };
                    literal(*value, unit)
                })
            })
            .collect();
        let _ = writeln!(text, "\n[[configurations]]\nvalues = {{ {} }}", given.join(", "));
    }
    text
}
