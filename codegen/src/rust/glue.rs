//! Emits the struct that implements the runtime's `Mechanism` trait for a program.

use super::options::ScalarType;
use super::{layout, name};
use crate::escape;
use crate::program::Program;

/// The struct, with `$name` for its name, `$runtime` for the runtime's path, `$by_index` for access to
/// parameters, and [`TIME`] where places depend on time.
const STRUCT: &str = "\
#[derive(Clone, Copy, Debug)]
$unread\
pub struct $name {
    parameters: Parameters,
    prepared: Prepared,
$time_field}
impl Default for $name {
    fn default() -> Self {
        Self::new(Parameters::default())
    }
}
$unread\
impl $name {
    /// The mechanism with these parameters.
    #[must_use]
    pub fn new(parameters: Parameters) -> Self {
        Self {
            parameters,
            prepared: prepare(&parameters),
$time_start        }
    }
    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }
    /// What depends on them alone.
    #[must_use]
    pub fn prepared(&self) -> &Prepared {
        &self.prepared
    }
    /// Changes all parameters and prepares anew.
    pub fn set_parameters(&mut self, parameters: Parameters) {
        self.prepared = prepare(&parameters);
        self.parameters = parameters;
    }
$by_index$can_be_assembled}
impl $runtime::mechanism::Mechanism<S> for $name {
    fn n_q(&self) -> usize {
        NQ
    }
    fn n_u(&self) -> usize {
        NU
    }
    fn n_inputs(&self) -> usize {
        N_INPUTS
    }
    fn is_angle(&self, index: usize) -> bool {
        IS_ANGLE.get(index).copied().unwrap_or(false)
    }
    fn rates(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, $runtime::mechanism::Fault> {
        let (Ok(q), Ok(u), Ok(inputs), Ok(q_out), Ok(u_out)) = (
            <&[S; NQ]>::try_from(q),
            <&[S; NU]>::try_from(u),
            <&[S; N_INPUTS]>::try_from(inputs),
            <&mut [S; NQ]>::try_from(q_dot),
            <&mut [S; NU]>::try_from(u_dot),
        ) else {
            return Err($runtime::mechanism::Fault::Shape);
        };
$time_given        Ok(rates_into(t, q, u, inputs, &self.prepared, q_out, u_out))
    }
$time_setter    #[allow(
        clippy::assign_op_pattern,
        reason = \"scalars need not have assigning operators\"
    )]
$project        let Ok(q) = <&mut [S; NQ]>::try_from(q) else {
            return Err($runtime::mechanism::Fault::Shape);
        };
        let (correction, residual) = projection(
            $time,
            q,
            &[<S as Real>::ZERO; NU],
            &[<S as Real>::ZERO; N_INPUTS],
            &self.prepared,
        );
        for (&index, &change) in CORRECTED.iter().zip(&correction) {
            if let Some(coordinate) = q.get_mut(index) {
                *coordinate = *coordinate + change;
            }
        }
        Ok(residual)
    }
$speed_projection$energy        let (Ok(q), Ok(u)) = (<&[S; NQ]>::try_from(q), <&[S; NU]>::try_from(u)) else {
            return Err($runtime::mechanism::Fault::Shape);
        };
        Ok(energy(
            $time,
            q,
            u,
            &[<S as Real>::ZERO; N_INPUTS],
            &self.prepared,
        ))
    }
}
";

/// Access to parameters by their position.
const BY_INDEX: &str = "    /// The parameter at a position of `PARAMETER_NAMES`; none beyond the last.
    #[must_use]
    pub fn parameter(&self, index: usize) -> Option<S> {
        Some(match index {
$getters            _ => return None,
        })
    }
    /// Changes the parameter at a position of `PARAMETER_NAMES` and prepares anew; false beyond the last$refusal.
    pub fn set_parameter(&mut self, index: usize, value: S) -> bool {
$before        let place = match index {
$setters            _ => return false,
        };
        *place = value;
        self.prepared = prepare(&self.parameters);
$assembled        true
    }
";

/// The same where there is none.
const NO_PARAMETERS: &str = "    /// The parameter at a position of `PARAMETER_NAMES`: there is none.
    #[must_use]
    pub fn parameter(&self, _: usize) -> Option<S> {
        None
    }
    /// Changes the parameter at a position of `PARAMETER_NAMES`: there is none, so that it returns false.
    pub fn set_parameter(&mut self, _: usize, _: S) -> bool {
        false
    }
";

/// Replacements for the placeholders of time; empty if neither projection nor energy depends on time.
const TIME: [(&str, &str, &str); 5] = [
    ("$time_field", "    time: S,\n", ""),
    ("$time_start", "            time: <S as Real>::ZERO,\n", ""),
    ("$time_given", "        self.time = t;\n", ""),
    ("$time_setter", "    fn set_time(&mut self, t: S) {\n        self.time = t;\n    }\n", ""),
    ("$time", "self.time", "<S as Real>::ZERO"),
];

/// Replacements for the placeholders of constraints that follow from the others at the default parameters. At other
/// parameters they may not; scalars that can be compared detect that.
const IMPLIED: [(&str, &str); 4] = [
    ("$refusal", ",\n    /// and where the constraints can no longer be met: all is then as it was"),
    ("$before", "        let before = *self;\n"),
    (
        "$assembled",
        "        if !self.can_be_assembled() {\n            *self = before;\n            return false;\n        }\n",
    ),
    (
        "$can_be_assembled",
        "    /// Do Newton's corrections lead from the nominal configuration to one that satisfies every constraint, those
    /// included that follow from the others at the default parameters?
    #[must_use]
    #[allow(
        clippy::assign_op_pattern,
        reason = \"scalars need not have assigning operators\"
    )]
    pub fn can_be_assembled(&self) -> bool {
        let mut q = NOMINAL;
        for _ in 0..25usize {
            let (correction, residual) = projection(
                $time,
                &q,
                &[<S as Real>::ZERO; NU],
                &[<S as Real>::ZERO; N_INPUTS],
                &self.prepared,
            );
            if residual <= $satisfied {
                return true;
            }
            for (&index, &change) in CORRECTED.iter().zip(&correction) {
                if let Some(coordinate) = q.get_mut(index) {
                    *coordinate = *coordinate + change;
                }
            }
        }
        false
    }
",
    ),
];

/// The correction of speeds, where they are redundant.
const SPEEDS: &str = "    #[allow(
        clippy::assign_op_pattern,
        reason = \"scalars need not have assigning operators\"
    )]
$speeds_head        let (Ok(q), Ok(u)) = (<&[S; NQ]>::try_from(q), <&mut [S; NU]>::try_from(u)) else {
            return Err($runtime::mechanism::Fault::Shape);
        };
        let correction = speed_projection(
            $time,
            q,
            u,
            &[<S as Real>::ZERO; N_INPUTS],
            &self.prepared,
        );
        for (speed, &change) in u.iter_mut().zip(&correction) {
            *speed = *speed + change;
        }
        Ok(())
    }
";

/// The residual below which a constraint counts as satisfied: half of the scalar's digits. `None` for scalars that
/// cannot be compared, and for programs without such constraints.
fn satisfied(program: &Program, scalar: &ScalarType) -> Option<String> {
    let epsilon = match scalar {
        ScalarType::F32 => f64::from(f32::EPSILON),
        ScalarType::F64 => f64::EPSILON,
        ScalarType::Path(_) => return None,
    };
    program.has_implied.then(|| scalar.literal(epsilon.sqrt() * program.assembly.size()))
}

/// Do projection or energy depend on time?
fn keeps_time(program: &Program) -> bool {
    let roots = ["projection", "energy", "speed_projection"].map(|answer| program.roots_of(answer)).concat();
    program.dag.symbols_of_all(&roots).contains(&program.time)
}

/// The name of the struct that implements `Mechanism` in the emitted file.
#[must_use]
pub fn struct_name(program: &Program) -> String {
    name::type_name(&program.name)
}

/// `pub struct Tile` and its `impl Mechanism<S>`; `fields` are those of `Parameters`.
pub(super) fn mechanism(program: &Program, fields: &[String], runtime: &str, scalar: &ScalarType) -> String {
    let doc = match program.doc.trim().is_empty() {
        true => format!("The mechanism {}.", escape::markdown_code(&program.name)),
        false => program.doc.trim().lines().map(escape::markdown).collect::<Vec<_>>().join("\n"),
    };
    let arms = |indent: &str, place: &str| -> String {
        let numbered = fields.iter().enumerate();
        let arm = |(index, field)| layout::text(format_args!("{indent}{index}usize => {place}.{field},\n"));
        numbered.map(arm).collect()
    };
    let method = |head: &str, arguments: &[&str], value: &str| {
        let arguments: Vec<String> = arguments.iter().map(|&a| a.to_owned()).collect();
        let output = format!("Result<{value}, {runtime}::mechanism::Fault>");
        layout::signature(head, &arguments, &output, "    ")
    };
    let keeps = keeps_time(program);
    let satisfied = satisfied(program, scalar);
    let by_index = if fields.is_empty() { NO_PARAMETERS } else { BY_INDEX };
    let speeds = if program.speed_correction.is_empty() { "" } else { SPEEDS };
    let name = struct_name(program);
    let getters = arms(&" ".repeat(12), "self.parameters");
    let setters = arms(&" ".repeat(12), "&mut self.parameters");
    let project = method("fn project", &["&mut self", "q: &mut [S]"], "S");
    let speeds_head = method("fn project_speeds", &["&mut self", "q: &[S]", "u: &mut [S]"], "()");
    let energy = method("fn energy", &["&mut self", "q: &[S]", "u: &[S]"], "(S, S)");
    let mut values = vec![
        ("$by_index", by_index),
        ("$speed_projection", speeds),
        ("$satisfied", satisfied.as_deref().unwrap_or_default()),
        ("$unread", layout::UNREAD),
        ("$name", &name),
        ("$getters", &getters),
        ("$setters", &setters),
        ("$project", &project),
        ("$speeds_head", &speeds_head),
        ("$energy", &energy),
        ("$runtime", runtime),
    ];
    values.extend(IMPLIED.map(|(place, kept)| (place, if satisfied.is_some() { kept } else { "" })));
    values.extend(TIME.map(|(place, kept, not_kept)| (place, if keeps { kept } else { not_kept })));
    let mut text = layout::doc(&doc);
    fill(&mut text, STRUCT, &values);
    let alias = format!("/// The mechanism of this file, whatever it is called.\n{}", layout::UNREAD);
    text + &alias + &format!("pub type Model = {name};\n")
}

/// Appends a text with its placeholders replaced by their values, in which placeholders are replaced likewise. Where
/// one placeholder begins with another, the longer one is listed first.
fn fill(text: &mut String, template: &str, values: &[(&str, &str)]) {
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('$') {
        text.push_str(before);
        rest = after;
        match values.iter().find_map(|(place, value)| Some((after.strip_prefix(&place[1..])?, value))) {
            Some((after, value)) => {
                fill(text, value, values);
                rest = after;
            }
            None => text.push('$'),
        }
    }
    text.push_str(rest);
}
