//! Equations in the shape of generated ones, until the generator writes them: three screws, each
//! with its own load and a spring that is not linear.

use std::error::Error;

/// Parameters with their values.
const PARAMETERS: [(&str, f64); 9] = [
    ("R", 0.2),
    ("ms", 0.8),
    ("mr", 2.0),
    ("mc", 0.15),
    ("M", 6.0),
    ("c", 40.0),
    ("g", 9.81),
    ("Ix", 0.09),
    ("k", 5.0),
];

/// The text of the generated file.
pub fn generate(_model: &str, set: &str) -> Result<String, Box<dyn Error>> {
    let mut parameters = PARAMETERS;
    for assignment in set.split(';').filter(|a| !a.is_empty()) {
        let (name, value) = assignment.split_once('=').ok_or("expected name=value")?;
        let parameter = parameters.iter_mut().find(|p| p.0 == name).ok_or("unknown parameter")?;
        parameter.1 = value.parse()?;
    }
    let mut text = format!("pub const PARAMETERS: [(&str, f32); {}] = [\n", parameters.len());
    for (name, value) in parameters {
        let value = value as f32;
        text += &format!("    ({name:?}, {value:?}),\n");
    }
    Ok(text + "];\n" + EQUATIONS)
}

const EQUATIONS: &str = r#"
pub const NQ: usize = 3;
pub const NU: usize = 3;
pub const N_INPUTS: usize = 3;
pub const COORDINATES: [&str; NQ] = ["hA", "hB", "hC"];
pub const SPEEDS: [&str; NU] = ["u_hA", "u_hB", "u_hC"];
pub const INPUTS: [&str; N_INPUTS] = ["FA", "FB", "FC"];
pub const START_Q: [f32; NQ] = [0.12; NQ];
pub const START_U: [f32; NU] = [0.0; NU];

pub struct Model;

impl Model {
    pub const fn new() -> Self {
        Self
    }
}

impl smartbed_runtime::mechanism::Mechanism<f32> for Model {
    fn n_q(&self) -> usize {
        NQ
    }
    fn n_u(&self) -> usize {
        NU
    }
    fn n_inputs(&self) -> usize {
        N_INPUTS
    }
    fn rates(
        &mut self,
        _t: f32,
        q: &[f32],
        u: &[f32],
        inputs: &[f32],
        q_dot: &mut [f32],
        u_dot: &mut [f32],
    ) -> Result<f32, smartbed_runtime::mechanism::Fault> {
        let [_, ms, mr, mc, m, c, g, _, k] = PARAMETERS.map(|p| p.1);
        let load = ms + mc + m / 3.0;
        for ((((q, u), f), q_dot), u_dot) in q.iter().zip(u).zip(inputs).zip(q_dot).zip(u_dot) {
            let (s, _) = smartbed_runtime::real::Real::sin_cos(*q);
            *q_dot = *u;
            *u_dot = (*f - load * g - c * *u - k * s) / (load + mr);
        }
        Ok(1.0)
    }
    fn project(&mut self, _q: &mut [f32]) -> Result<f32, smartbed_runtime::mechanism::Fault> {
        Ok(0.0)
    }
    fn energy(&mut self, _q: &[f32], _u: &[f32]) -> Result<(f32, f32), smartbed_runtime::mechanism::Fault> {
        Ok((0.0, 0.0))
    }
}
"#;
