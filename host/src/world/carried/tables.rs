//! Emits a world as Rust for the firmware: constant tables, derived equations, its carriers.
//!
//! In: a world at its start. Out: the text of a Rust file in single precision, which the firmware's program `world`
//! includes. `Debug` output of the runtime's plain types is a Rust expression, and for a number the shortest decimal
//! that reads back the same: the compiler rounds it once to single precision, for chip and host alike.

use super::methods::{Contacts, Stepping};
use super::{CarriedWorld, Place, Touching};
use crate::world::assembly::{Assembly, Kind, Mechanism};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Engine as _;
use smartbed_codegen::{
    Asked, Effort, EmitOptions, Function, ParameterChoice, Program, ScalarType, program, rust,
};
use smartbed_runtime::ode::Method;
use smartbed_runtime::rigid::contact::Twist;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::world::{Coupling, InverseInertia, StepMemory, Touch};
use std::fmt::{Debug, Write as _};

/// Spare room for contacts: at least this many, or a quarter of those found if that is more.
const BESIDE: usize = 4;

/// Memory that a world needs on the chip, in single precision.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Demand {
    /// Nodes.
    pub nodes: usize,
    /// Numbers of the state.
    numbers: usize,
    method: Method,
    /// If parts may touch: number of ports, number of answers about them, room for contacts.
    contacts: Option<[usize; 3]>,
}

impl Demand {
    /// Bytes: the state with the compensation of its summation, and the method's memory; positions, velocities and two
    /// forces of each node; memory for contacts, with the host's pointers slightly larger than the chip's.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let numbers = |scratch: usize| size_of::<f32>() * (2 * self.numbers + scratch + 4 * 3 * self.nodes);
        let Some([ports, answers, room]) = self.contacts else {
            return numbers(self.method.scratch(self.numbers));
        };
        numbers(StepMemory::<f32>::scratch(self.numbers))
            + ports * (2 * size_of::<Frame<f32>>() + size_of::<Coupling>())
            + 3 * (ports + self.nodes) * size_of::<Twist<f32>>()
            + self.nodes * 4 * size_of::<f32>()
            + answers * size_of::<InverseInertia<f32>>()
            + 2 * room * size_of::<Touch<f32>>()
    }

    /// Room for contacts.
    #[must_use]
    pub fn contacts(&self) -> usize {
        self.contacts.map_or(0, |[.., room]| room)
    }

    /// Without this many nodes: all, and the free ones among them.
    #[must_use]
    pub fn without(self, [all, free]: [usize; 2]) -> Self {
        Demand { nodes: self.nodes - all, numbers: self.numbers - 6 * free, ..self }
    }

    /// With this many additional nodes.
    #[must_use]
    pub fn with(self, [all, free]: [usize; 2]) -> Self {
        Demand { nodes: self.nodes + all, numbers: self.numbers + 6 * free, ..self }
    }
}

impl CarriedWorld {
    /// The chip's method; `None` if contacts have a method of their own.
    ///
    /// # Errors
    /// If the assembly needs something that the chip does not support.
    pub fn for_chip(&self, assembly: &Assembly) -> Result<Option<Method>, String> {
        if self.contacts == Contacts::Located {
            return Err("the chip locates no touches; take impact = \"moreau\" for all contacts".to_owned());
        }
        if assembly.is_rigid() {
            let why = "the chip steps flexible parts, mechanisms and contacts; rigid parts without any have a step of their own";
            return Err(why.to_owned());
        }
        if assembly.has_lines() || !assembly.controllers.is_empty() {
            let why = "the chip steps worlds without lines of gas and controllers; leave supply, vent and [controllers] out";
            return Err(why.to_owned());
        }
        let kinks = |part: &usize| {
            let Place::Carrier(number, _) = self.places[*part] else { return false };
            matches!(&self.carriers[number], HostCarrier::Mechanism(own) if own.switches.any())
        };
        if let Some(part) = (0..self.places.len()).find(kinks) {
            return Err(format!(
                "`{}`: a command, law or load with abs, sign, min or max of the time may change at once, where the chip cuts no \
                 step; write a smooth one",
                self.names[part]
            ));
        }
        match self.method.1 {
            Stepping::Ode(method) => Ok(Some(method)),
            Stepping::Moreau => Ok(None),
            Stepping::Conserving => Err(format!(
                "run.method = \"{}\": the chip has verlet, rk4 and other methods of fixed step, and with contacts \
                 moreau; take one of them",
                self.method.0
            )),
        }
    }

    /// The tables, with room for this many contacts.
    ///
    /// # Errors
    /// If the chip does not support the assembly, or its equations cannot be derived.
    pub fn tables(&self, assembly: &Assembly, room: usize) -> Result<String, String> {
        let method = self.for_chip(assembly)?;
        let fixed = &self.fixed;
        let mut text = String::new();
        let mut constant = |name: &str, kind: &str, value: &dyn Debug| {
            let _ = writeln!(text, "pub const {name}: {kind} = {value:?};");
        };
        constant("NODES", "usize", &fixed.mass.len());
        constant("PORTS", "usize", &self.room.frames.len());
        constant("NUMBERS", "usize", &self.x.len());
        constant("STEP", "f32", &self.h);
        constant("METHOD", "Option<Method>", &method);
        constant("GRAVITY", "Vec3<f32>", &fixed.gravity);
        constant("AIR_DRAG", "f32", &fixed.air_drag);
        constant("CONTACTS", "usize", &room);
        constant("ANSWERS", "usize", &if method.is_none() { self.touched().answers() } else { 0 });
        constant("POS", "[Vec3<f32>; NODES]", &self.room.pos);
        constant("START", "[f32; NUMBERS]", &self.x);
        let mut table = |name: &str, kind: &str, length: usize, values: &dyn Debug| {
            let _ = writeln!(text, "pub static {name}: [{kind}; {length}] = {values:?};");
        };
        table("MASS", "f32", fixed.mass.len(), &fixed.mass);
        table("HELD", "bool", fixed.held.len(), &fixed.held);
        table("SPRINGS", "Spring<f32>", fixed.springs.len(), &fixed.springs);
        table("FACETS", "[usize; 4]", fixed.facets.len(), &fixed.facets);
        table("CELLS", "Cell<f32>", fixed.cells.len(), &fixed.cells);
        table("ATTACHMENTS", "Attachment<f32>", fixed.attachments.len(), &fixed.attachments);
        table("RESTRAINED", "[usize; 2]", fixed.restrained.len(), &fixed.restrained);
        let (things, pairs) = (&self.touched().things, &self.touched().pairs);
        table("THINGS", "Thing<f32>", things.len(), things);
        table("PAIRS", "Pair<f32>", pairs.len(), pairs);
        representable(&text)?;
        Ok(text + &self.members(assembly)?)
    }

    /// The memory that it needs, with room for this many contacts.
    #[must_use]
    pub fn demand(&self, room: usize) -> Demand {
        let ports = self.room.frames.len();
        let contacts = (self.contacts != Contacts::None).then(|| [ports, self.touched().answers(), room]);
        Demand { nodes: self.fixed.mass.len(), numbers: self.x.len(), method: self.ode_method(), contacts }
    }

    /// Room for the contacts during this many steps: the most that are near at once, found by taking the steps, and a
    /// quarter more.
    ///
    /// # Errors
    /// Why a step cannot be taken.
    pub fn contact_room(&self, steps: usize) -> Result<usize, String> {
        if self.contacts != Contacts::Unlocated {
            return Ok(0);
        }
        let (mut world, mut most) = (self.clone(), 0);
        for _ in 0..steps {
            world.step(self.h, &mut Vec::new())?;
            most = most.max(world.touched().near());
        }
        Ok(most + most / 4 + BESIDE)
    }

    /// The parts that can be touched.
    fn touched(&self) -> &Touching {
        self.touching.as_ref().expect("there is one but while a step is made")
    }

    /// Equations of mechanisms, those of copies once, and the list of carriers.
    fn members(&self, assembly: &Assembly) -> Result<String, String> {
        let (mut text, mut equations, mut variants, mut members) =
            (String::new(), Vec::<String>::new(), Vec::<String>::new(), Vec::<String>::new());
        for (part, place) in assembly.parts.iter().zip(&self.places) {
            let Place::Carrier(number, _) = place else { continue };
            let mut member = |kind: &str, value: String| {
                let variant = kind.split('<').next().unwrap_or(kind);
                let named = format!("{variant}: {kind}");
                if !variants.contains(&named) {
                    variants.push(named);
                }
                members.push(format!("Member::{variant}({value})"));
            };
            match (&self.carriers[*number], &part.kind) {
                (HostCarrier::Mechanism(ported), Kind::Mechanism(mechanism)) => {
                    let (module, carrier) = emitted(mechanism, ported.ports())
                        .map_err(|why| format!("`{}`: {why}", part.name))?;
                    let known = equations.iter().position(|known| *known == module);
                    let own = known.unwrap_or(equations.len());
                    if known.is_none() {
                        let _ = writeln!(text, "pub mod equations_{own} {{\n{module}}}");
                        let _ = writeln!(text, "{}", carrier.replace('#', &own.to_string()));
                        equations.push(module);
                    }
                    member(&format!("Derived{own}"), format!("Derived{own}::at({:?})", mechanism.place));
                }
                (HostCarrier::Floating(body), _) => member("Floating<f32>", format!("{body:?}")),
                (HostCarrier::Still(frame), _) => member("Still<f32>", format!("{frame:?}")),
                (HostCarrier::Mechanism(_), _) => {}
            }
        }
        if members.is_empty() {
            variants.push("Still: Still<f32>".to_owned());
        }
        let _ = writeln!(text, "carriers!(Member {{ {} }});", variants.join(", "));
        let n = members.len();
        let _ = writeln!(text, "pub fn members() -> [Member; {n}] {{\n    [{}]\n}}", members.join(", "));
        Ok(text)
    }
}

/// Refuses numbers that single precision cannot represent.
fn representable(tables: &str) -> Result<(), String> {
    let numbers = tables.split(|c: char| !(c.is_ascii_alphanumeric() || ".-".contains(c)));
    let large = numbers.filter_map(|word| word.parse::<f64>().ok()).find(|x| !(*x as f32).is_finite());
    match large {
        Some(x) => Err(format!("{x:e} is beyond single precision; choose other units")),
        None => Ok(()),
    }
}

/// Rust code of a mechanism's equations with these ports, and its carrier, with `#` for its number.
fn emitted(mechanism: &Mechanism, ports: &[String]) -> Result<(String, String), String> {
    let model = &mechanism.model;
    let mut functions = Vec::new();
    for (n, port) in ports.iter().enumerate() {
        functions.push(Function::parse(&format!("port_{n}=port:{port}"), n)?);
    }
    let has_law = !model.laws.is_empty();
    functions.extend(has_law.then(|| Function::each(&["law"])).into_iter().flatten());
    let asked = Asked::besides(functions);
    let program = program::derive_asked(model, &ParameterChoice::default(), Effort::All, &asked)
        .map_err(|found| found.to_string())?;
    if let Some(why) = program.beyond_single() {
        return Err(format!("{why}; choose other units"));
    }
    let emit = EmitOptions { scalar: ScalarType::F32, ..EmitOptions::default() };
    let module = rust::emit(&program, &emit) + &command(&program, has_law);
    let places: Vec<String> = ports.iter().enumerate().map(|(n, port)| wrench(&program, n, port)).collect();
    let name = rust::struct_name(&program);
    let carrier = format!("derived!(Derived#: equations_#::{name}, ports: [{}]);", places.join(", "));
    Ok((module, carrier))
}

/// The function of a port, and where its wrench begins among the inputs.
fn wrench(program: &Program, n: usize, port: &str) -> String {
    let first = format!("{port}_force_x");
    let place = program.inputs.iter().position(|input| input.name == first);
    format!("port_{n} => {}", place.unwrap_or(program.inputs.len()))
}

/// The model's law as a function of the state; without a law it leaves the inputs unchanged.
fn command(program: &Program, has_law: bool) -> String {
    let (underscore, body) = match has_law {
        true => ("", "law(t, q, u, inputs, p).inputs"),
        false => ("_", "*inputs"),
    };
    let [t, q, u, p] = ["t", "q", "u", "p"].map(|name| format!("{underscore}{name}"));
    let [nq, nu, n] = [program.q.len(), program.u.len(), program.inputs.len()];
    format!(
        "/// Inputs as the model's law commands them.\n#[must_use]\n\
         pub fn command({t}: f32, {q}: &[f32; {nq}], {u}: &[f32; {nu}], inputs: &[f32; {n}], {p}: &Prepared) \
         -> [f32; {n}] {{\n    {body}\n}}\n"
    )
}
