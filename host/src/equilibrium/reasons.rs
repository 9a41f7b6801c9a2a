//! Why no equilibrium was found, in words.
//!
//! In: where a search ended. Out: what is wrong there, and what to change.

use super::search::{Search, Unknown};

/// Most coordinates named in a message.
const NAMED: usize = 4;

impl Search<'_> {
    pub(super) fn not_found(&self, name: &str, value: f64) -> String {
        let advice = match self.unknown {
            Unknown::State if self.is_euler_parameter(name) => {
                "a body that turns changes its Euler parameters, and no motion of it is steady in them; describe its \
                 attitude by rotations, such as [[\"z\", \"yaw\"], [\"x\", \"lean\"], [\"y\", \"spin\"]], and its speeds \
                 along axes that do not spin with it"
            }
            Unknown::State if self.state.iter().any(|e| !e.is_speed && e.name == name) => {
                return format!(
                    "no equilibrium was found: the rate of `{name}` stays {value:.3e}: accelerations depend on `{name}`, \
                     which cannot stay constant at these speeds; hold other speeds"
                );
            }
            Unknown::State => {
                "give a start nearer to it by --set, hold inputs by --input, or let them balance it by --trim"
            }
            Unknown::Inputs if self.free_inputs.is_empty() => {
                "the model has no input without a law, or --input holds them all"
            }
            Unknown::Inputs if self.is_motion() => {
                "its inputs cannot balance this state, whose speeds are kept too; set them to 0 by --set for an equilibrium"
            }
            Unknown::Inputs => "its inputs cannot balance this state; give another by --set",
        };
        format!("no equilibrium was found: the rate of `{name}` stays {value:.3e}; {advice}")
    }

    /// Where the search ended, in words.
    fn end_place(&self) -> String {
        let places = self.state.iter().filter(|entry| entry.is_free_coordinate());
        let place: Vec<String> =
            places.take(NAMED).map(|e| format!("`{}` = {:.4}", e.name, self.q[e.place] + 0.0)).collect();
        place.join(", ")
    }

    pub(super) fn singular(&self, pivot: f64) -> String {
        format!(
            "no equilibrium was found where the equations are regular: at {} nothing accelerates, but the configuration \
             is singular (the smallest pivot is {pivot:.1e} of its nominal size), so that accelerations and modes have no \
             meaning there, as where an axis of rotation falls onto another; describe the attitude by rotations about \
             other axes, or hold a coordinate elsewhere by --hold",
            self.end_place()
        )
    }

    pub(super) fn dependent(&self, pivot: f64) -> String {
        format!(
            "no equilibrium was found: the search ended at {}, where forces act and the rates of the speeds vanish only \
             because the speeds as the model defines them stop being independent of one another (the smallest pivot is \
             {pivot:.1e} of its nominal size); define speeds that stay independent, such as the rates of the \
             coordinates, or give a start nearer to an equilibrium by --set",
            self.end_place()
        )
    }
}
