//! Figure 4.1: a rigid ball that falls, bounces and comes to rest, and the force of the ground on it (Eq. 4.1).

use super::setting::{name_of, value_of};
use crate::failure::Failure;
use crate::plot::chart::{self, Chart, Curve, Panel};
use crate::plot::drawing::Drawing;
use smartbed_runtime::rigid::contact::{Mobility, Twist};
use smartbed_runtime::rigid::law::Law;
use smartbed_runtime::rigid::scene::{Memory, Pair, Part, RigidScene, Touching};
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::{Shape, Sphere};

/// Radius of the ball (m).
const RADIUS: f64 = 0.1;
/// Acceleration of gravity (m/s^2).
const GRAVITY: f64 = 9.81;
/// Length and step of the run (s).
const SECONDS: f64 = 0.5;
const STEP: f64 = 1e-3;
/// Most contacts: a ball has one.
const ROOM: usize = 4;

/// The settings of the fall.
#[derive(Clone, Copy)]
pub(super) struct Ball {
    restitution: f64,
    /// Initial height of its lowest point (m).
    height: f64,
    mass: f64,
}

/// Heights (m) and forces of the ground (N) at the times (s), and the times of impacts.
#[derive(Default)]
struct Record {
    time: Vec<f64>,
    height: Vec<f64>,
    force: Vec<f64>,
    impacts: Vec<f64>,
}

impl Ball {
    /// Reads the settings.
    pub(super) fn new(settings: &[String]) -> Result<Ball, Failure> {
        let mut ball = Ball { restitution: 0.5, height: 0.02, mass: 1.0 };
        for setting in settings {
            let value = value_of(setting)?;
            match name_of(setting) {
                "e" if (0.0..=1.0).contains(&value) => ball.restitution = value,
                "height" if (0.0..=1.0).contains(&value) => ball.height = value,
                "mass" if value > 0.0 => ball.mass = value,
                _ => {
                    let expected = "e from 0 to 1, height from 0 to 1, or mass above 0";
                    return Err(Failure::Wrong(format!("--set {setting}: expected {expected}")));
                }
            }
        }
        Ok(ball)
    }

    fn run(&self) -> Result<Record, Failure> {
        let law = Law::stronge(self.restitution, 0.0)
            .map_err(|fault| Failure::Wrong(format!("figure 4.1: the law is refused: {fault:?}")))?;
        let inertia = [0.4 * self.mass * RADIUS * RADIUS; 3];
        let ball = Part {
            shape: Shape::Sphere(Sphere { radius: RADIUS }),
            body: Some(RigidBody { mass: self.mass, inertia }),
        };
        let ground = Part { shape: Shape::HalfSpace, body: None };
        let scene = RigidScene {
            parts: &[ground, ball],
            pairs: &[Pair { parts: [1, 0], law }],
            gravity: [0.0, 0.0, -GRAVITY],
        };
        let start = RigidState::at_rest([0.0, 0.0, RADIUS + self.height]);
        let mut states = [RigidState::at_rest([0.0; 3]), start];
        let [mut now, mut trial, mut middle] = [states; 3];
        let mut mobilities = [Mobility::fixed(); 2];
        let mut struck = [Struck::new(Touching::empty().held.contact, &mobilities[..]); ROOM];
        let mut memory = Memory {
            states: [&mut now, &mut trial, &mut middle],
            twists: &mut [Twist::zero(); 2],
            spare: &mut [Twist::zero(); 2],
            mobilities: &mut mobilities,
            touching: &mut [Touching::empty(); ROOM],
            along: &mut [Touching::empty(); ROOM],
            struck: &mut struck,
        };
        let mut record = Record::default();
        for number in 1..=(SECONDS / STEP).round() as u32 {
            let report = scene
                .step(&mut states, STEP, &mut memory)
                .map_err(|fault| Failure::Wrong(format!("figure 4.1: the step is refused: {fault:?}")))?;
            let time = f64::from(number) * STEP;
            record.time.push(time);
            record.height.push(states[1].position[2] - RADIUS);
            record.force.push(report.pressing);
            if report.impacts > 0 {
                record.impacts.push(time);
            }
        }
        Ok(record)
    }

    /// Height and forces over time.
    pub(super) fn draw(&self) -> Result<Drawing, Failure> {
        let record = self.run()?;
        let weight = self.mass * GRAVITY;
        let rests = record.force.last().is_some_and(|force| *force > 0.0);
        let curve =
            |name: &str, values: Vec<f64>| Curve { name: name.to_owned(), values, color: None, across: None };
        let panels = [
            Panel { label: "height [m]".to_owned(), curves: vec![curve("lowest point", record.height)] },
            Panel {
                label: "force [N]".to_owned(),
                curves: vec![
                    curve("contact", record.force),
                    curve("weight", vec![weight; record.time.len()]),
                ],
            },
        ];
        let (title, end) = match rests {
            true => (
                "A rigid ball comes to rest: contact force (Fig. 4.1)",
                format!("that of lasting contact, at rest the weight, {weight:.4} N"),
            ),
            false => (
                "A rigid ball bounces: contact force (Fig. 4.1)",
                format!("that of lasting contact, 0 for the {SECONDS} s shown; the weight is {weight:.4} N"),
            ),
        };
        let note = format!(
            "rigid ball of {} kg from {} m, e = {}; impacts are impulses and not shown; the force is {end}",
            self.mass, self.height, self.restitution
        );
        Ok(chart::draw(&Chart {
            title,
            note: &note,
            across: "time [s]",
            time: &record.time,
            panels: &panels,
            events: &record.impacts,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::drawing::Item;

    #[test]
    fn the_title_says_rest_only_where_there_is_one() {
        for (settings, words) in [("e=0.5", "comes to rest"), ("e=1", "bounces")] {
            let drawing = Ball::new(&[settings.to_owned()]).expect("settings").draw().expect("a run");
            let is_said = |item: &Item| matches!(item, Item::Text { text, .. } if text.contains(words));
            assert!(drawing.items.iter().any(is_said), "{settings}: {words}");
        }
    }

    #[test]
    fn the_force_is_nothing_in_flight_and_the_weight_at_rest() {
        let record = Ball::new(&["mass=2".to_owned()]).expect("settings").run().expect("a run");
        let touch = (2.0 * 0.02 / GRAVITY).sqrt();
        // The durations of all bounces sum up to t (1 + 2 e/(1 - e)).
        let rest = touch * 3.0;
        for (time, force) in record.time.iter().zip(&record.force) {
            if *time < rest - STEP {
                assert_eq!(*force, 0.0, "{time}");
            } else if *time > rest + STEP {
                assert!((force - 2.0 * GRAVITY).abs() <= 1e-12, "{time}: {force}");
            }
        }
        assert!((record.impacts[0] - touch).abs() <= STEP);
    }
}
