//! Temporary: the oracle in the place of the generated code, so that the tests can be tried.
#![expect(missing_docs, reason = "temporary")]
use crate::cases;
use crate::closed_form::tile as tile_form;
use crate::newton_euler::{
    fourbar::Fourbar,
    pendulum::Pendulum,
    system::Motion,
    tile::{Parameters, Tile},
};
use crate::reference::data;
use crate::subject::{Names, Subject};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::Scalar;

pub struct StandIn {
    model: String,
    names: Names,
    parameters: Vec<(String, f64)>,
}
impl StandIn {
    pub fn new(model: &str) -> Self {
        let case = &cases::reference_cases(model)[0];
        let of = |v: &Vec<(String, f64)>| v.iter().map(|x| x.0.clone()).collect::<Vec<_>>();
        let names = Names {
            q: of(&case.state.q),
            u: of(&case.state.u),
            inputs: of(&case.state.inputs),
            outputs: vec![],
        };
        Self { model: model.into(), names, parameters: case.parameters.clone() }
    }
    fn motion(&self, q: &[f64], u: &[f64], inputs: &[f64]) -> Motion {
        let p: Vec<f64> = self.parameters.iter().map(|x| x.1).collect();
        match self.model.as_str() {
            "pendulum3" => Pendulum { masses: &p[..3], lengths: &p[3..6], g: p[6], q }.solve(u),
            "fourbar" => Fourbar::new(&p, q, inputs).solve(u),
            _ => {
                let parameters = Parameters::new(&p);
                let q12: [f64; 12] = if q.len() == 12 {
                    q.try_into().unwrap()
                } else {
                    let h = q.try_into().unwrap();
                    tile_form::posture(parameters.r, h).coordinates(parameters.r, h)
                };
                Tile {
                    parameters,
                    q: q12,
                    h_dot: u.try_into().unwrap(),
                    thrust: inputs.try_into().unwrap(),
                    load: Default::default(),
                }
                .solve()
            }
        }
    }
}
fn wide<S: Scalar>(x: &[S]) -> Vec<f64> {
    x.iter().map(|x| x.to_f64()).collect()
}
impl<S: Scalar> Mechanism<S> for StandIn {
    fn n_q(&self) -> usize {
        self.names.q.len()
    }
    fn n_u(&self) -> usize {
        self.names.u.len()
    }
    fn n_inputs(&self) -> usize {
        self.names.inputs.len()
    }
    fn rates(
        &mut self,
        _t: S,
        q: &[S],
        u: &[S],
        inputs: &[S],
        q_dot: &mut [S],
        u_dot: &mut [S],
    ) -> Result<S, Fault> {
        let m = self.motion(&wide(q), &wide(u), &wide(inputs));
        let all: Vec<f64> = if self.model == "tile_minimal" { wide(u) } else { m.q_dot };
        for (a, b) in q_dot.iter_mut().zip(all) {
            *a = S::from_f64(b);
        }
        for (a, b) in u_dot.iter_mut().zip(m.u_dot) {
            *a = S::from_f64(b);
        }
        Ok(S::ONE)
    }
    fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        if self.model == "tile" {
            let r = self.parameters[0].1;
            let w = wide(q);
            let h = [w[0], w[4], w[8]];
            let res = crate::loop_equations::largest_residual(r, &w);
            for (a, b) in q.iter_mut().zip(tile_form::posture(r, h).coordinates(r, h)) {
                *a = S::from_f64(b);
            }
            return Ok(S::from_f64(res));
        }
        Ok(S::ZERO)
    }
    fn energy(&mut self, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        let m = self.motion(&wide(q), &wide(u), &vec![0.0; self.names.inputs.len()]);
        Ok((S::from_f64(m.kinetic), S::from_f64(m.potential)))
    }
}
impl<S: Scalar> Subject<S> for StandIn {
    fn names(&self) -> Names {
        self.names.clone()
    }
    fn set_parameter(&mut self, name: &str, value: f64) {
        self.parameters.iter_mut().find(|p| p.0 == name).unwrap_or_else(|| panic!("{name}")).1 = value;
    }
    fn outputs(&mut self, _q: &[S], _u: &[S], _inputs: &[S]) -> Vec<S> {
        vec![]
    }
}
