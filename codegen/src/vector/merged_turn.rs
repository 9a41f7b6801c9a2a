//! Merges consecutive rotations about one axis into one, by the sum or difference of their angles.
//!
//! cos a cos b + sin a sin b = cos(a - b): two links that are turned against the same triad by absolute angles are
//! turned against each other by the difference. The merged rotation rounds as if one of the angles had an error of one
//! rounding, whereas the products cancel where the difference is small.

use super::components::turn_components;
use super::triads::{Components, TriadId, Triads, Turn};
use crate::expr::{Dag, ExprId};
use crate::model::Axis;

/// Consecutive rotations about one axis: by the variable angle `forth`, back by `back`, and by `constant`.
pub(super) struct MergedTurn {
    axis: Axis,
    forth: ExprId,
    back: ExprId,
    constant: ExprId,
}

impl MergedTurn {
    /// Does the rotation take a difference of two variable angles?
    pub fn is_difference(&self, dag: &Dag) -> bool {
        !dag.is_zero(self.forth) && !dag.is_zero(self.back)
    }

    /// Components after all rotations, each by its single merged angle.
    pub fn turn(turns: &[Self], dag: &mut Dag, v: Components) -> Components {
        turns.iter().fold(v, |v, &Self { axis, forth, back, constant }| {
            // Always the same difference, later node first, whichever way the rotation goes: its sine and cosine are
            // shared.
            if forth < back {
                let difference = dag.sub(back, forth);
                let angle = dag.sub(difference, constant);
                turn_components(dag, axis, angle, v, true)
            } else {
                let difference = dag.sub(forth, back);
                let angle = dag.add(difference, constant);
                turn_components(dag, axis, angle, v, false)
            }
        })
    }
}

impl Triads {
    /// The rotations from one triad up to the common ancestor and down to another, consecutive ones about one axis
    /// merged.
    /// `None` if one of them is not a simple rotation.
    pub(super) fn merged_turns(&self, dag: &mut Dag, from: TriadId, to: TriadId) -> Option<Vec<MergedTurn>> {
        let (up, down) = self.ways(from, to);
        let (up, down) = (up.iter().map(|&t| (t, false)), down.iter().map(|&t| (t, true)));
        let mut turns: Vec<MergedTurn> = Vec::new();
        for (triad, inwards) in up.chain(down.rev()) {
            let Turn::Simple { axis, angle, .. } = self.turns[triad] else { return None };
            if turns.last().is_none_or(|last| last.axis != axis) {
                let zero = dag.zero();
                turns.push(MergedTurn { axis, forth: zero, back: zero, constant: zero });
            }
            let turn = turns.last_mut()?;
            let sum = match (dag.is_constant(angle), inwards) {
                (true, _) => &mut turn.constant,
                (false, true) => &mut turn.back,
                (false, false) => &mut turn.forth,
            };
            let angle = if dag.is_constant(angle) && inwards { dag.negate(angle) } else { angle };
            *sum = dag.add(*sum, angle);
        }
        Some(turns)
    }

    /// Components in `to` of a vector given in `from`, using differences of the angles that turn both about one axis
    /// against a third triad; `None` where no such difference occurs and merging gains nothing.
    pub(super) fn by_differences(
        &self,
        dag: &mut Dag,
        from: TriadId,
        v: Components,
        to: TriadId,
    ) -> Option<Components> {
        let turns = self.merged_turns(dag, from, to)?;
        let has_difference = turns.iter().any(|turn| turn.is_difference(dag));
        has_difference.then(|| MergedTurn::turn(&turns, dag, v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Node, Unary};
    use crate::id::Id;

    /// A triad turned by a + 120 degrees about z, seen from one turned by b about z and then by c about y.
    #[test]
    fn a_difference_of_angles_turns_like_the_turns_themselves() {
        let mut dag = Dag::default();
        let [a, b, c] = ["a", "b", "c"].map(|name| dag.symbol(name));
        let third = dag.constant(2.0 * std::f64::consts::FRAC_PI_3);
        let mut triads = Triads::default();
        let inertial = triads.push(Turn::Inertial);
        let mut push = |parent, axis, angle| triads.push(Turn::Simple { parent, axis, angle });
        let offset = push(inertial, Axis::Z, third);
        let from = push(offset, Axis::Z, a);
        let other = push(inertial, Axis::Z, b);
        let to = push(other, Axis::Y, c);

        let v = [0.3, -1.2, 0.7].map(|x| dag.constant(x));
        let turns = triads.merged_turns(&mut dag, from, to).unwrap();
        assert_eq!(turns.len(), 2);
        assert!(turns[0].is_difference(&dag) && !turns[1].is_difference(&dag));
        let merged = MergedTurn::turn(&turns, &mut dag, v);
        let turned = triads.turn_by_turn(&mut dag, from, v, to);
        let is_sine =
            |dag: &Dag, id: &ExprId| matches!(dag.node(*id), Node::Unary(Unary::Sin | Unary::Cos, _));
        let sines = |roots: &[ExprId]| dag.reachable(roots).iter().filter(|id| is_sine(&dag, id)).count();
        assert_eq!((sines(&merged), sines(&turned)), (4, 6));

        for step in 0..20 {
            let angle = |k: usize| (f64::from(step) * 0.7 + k as f64).sin() * 3.0;
            let values = dag.evaluate(&[merged, turned].concat(), &|symbol| angle(symbol.index()));
            for (x, y) in values[..3].iter().zip(&values[3..]) {
                assert!((x - y).abs() < 1e-15 * 4.0, "{x} {y}");
            }
        }
    }
}
