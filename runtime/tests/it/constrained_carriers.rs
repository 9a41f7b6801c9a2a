//! Carriers whose speeds obey constraints, as members of an island's group.

use crate::island::run;
use smartbed_runtime::flexible::Body;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::world::{Carrier, Group, InverseInertia, Island, Memory, Wrench};

/// A point whose speed is stored twice in the state; the second must follow the first.
struct Twice;

impl Carrier<f64> for Twice {
    fn n_q(&self) -> usize {
        1
    }
    fn n_u(&self) -> usize {
        2
    }
    fn n_ports(&self) -> usize {
        1
    }
    fn inverse_inertia(
        &mut self,
        _: f64,
        _: &[f64],
        _: &[f64],
        _: [usize; 2],
    ) -> Result<InverseInertia<f64>, Fault> {
        Ok([[0.0; 6]; 6])
    }
    fn frames(&mut self, _: f64, _: &[f64], _: &[f64], _: &mut [Frame<f64>]) -> Result<(), Fault> {
        Ok(())
    }
    fn rates(
        &mut self,
        _: f64,
        _: &[f64],
        u: &[f64],
        _: &[Wrench<f64>],
        q_dot: &mut [f64],
        u_dot: &mut [f64],
    ) -> Result<f64, Fault> {
        q_dot[0] = u[0];
        // The second drifts.
        (u_dot[0], u_dot[1]) = (1.0, 1.5);
        Ok(1.0)
    }
    fn energy(&mut self, _: f64, _: &[f64], _: &[f64]) -> Result<(f64, f64), Fault> {
        Ok((0.0, 0.0))
    }
    fn project_speeds(&mut self, _: &[f64], u: &mut [f64]) -> Result<(), Fault> {
        u[1] = u[0];
        Ok(())
    }
    fn projections(&self) -> u8 {
        1
    }
}

#[test]
fn speeds_of_carriers_in_a_group_are_put_back_on_their_constraints() {
    let mut members = [Twice, Twice];
    let (mut frames, mut wrenches) = ([Frame::inertial(); 2], [Wrench::zero(); 2]);
    let memory = Memory::without_nodes(&mut frames, &mut wrenches);
    let island = Island::new(Group { members: &mut members }, Body::none(), &[], memory);
    let mut island = island.expect("an island");
    let mut x = [0.0; 6];
    island.load(&[0.0, 1.0], &[2.0, 2.0, 3.0, 3.0], &mut x).expect("lengths");
    run(&mut island, &mut x, 0.5, 2);
    assert_eq!(x, [2.5, 4.5, 3.0, 3.0, 4.0, 4.0]);
}
