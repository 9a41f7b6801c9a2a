use smartbed_runtime::ode::{rk4, runge_kutta};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::real::Real;
use smartbed_runtime::ode::State;

/// q'' = -(g / l) sin q with g / l = 9.81 / s^2.
struct Pendulum;

impl Ode<f32> for Pendulum {
    fn n_x(&self) -> usize {
        2
    }
    fn n_q(&self) -> usize {
        1
    }
    fn rates(&mut self, _t: f32, x: &[f32], x_dot: &mut [f32]) -> Result<f32, Fault> {
        let ([q, u], [q_dot, u_dot]) = (x, x_dot) else { return Err(Fault::Shape) };
        let (sin_q, _) = Real::sin_cos(*q);
        *q_dot = *u;
        *u_dot = -9.81 * sin_q;
        Ok(1.0) // no elimination, no pivot
    }
}

let (mut x, mut low) = ([0.1_f32, 0.0], [0.0; 2]);
let mut scratch = [0.0; runge_kutta::rk4_scratch(2)];
let mut state = State::new(&mut x, &mut low)?;
for step in 0..1000_u16 {
    rk4(&mut Pendulum, 1e-3 * f32::from(step), 1e-3, &mut state, &mut scratch)?;
}
// Small swings: q = 0.1 cos(w t (1 - 0.1^2 / 16)), w^2 = g / l.
let expected = 0.1 * f64::cos(f64::sqrt(9.81) * (1.0 - 0.01 / 16.0));
assert!((f64::from(state.x()[0]) - expected).abs() < 2e-6);
# Ok::<(), Fault>(())
