//! Figure 4.2: work over impulse for the impact of a rigid rod on the ground, in the thesis' four phases.

use super::setting::{name_of, value_of};
use crate::failure::Failure;
use crate::plot;
use crate::plot::chart::{self, Chart, Curve, Panel};
use smartbed_runtime::rigid::impact::{CurvePoint, Stage, Touch, trace};

/// A slender rod of 1 kg and 1 m that strikes the ground with its lower end, without rotation.
#[derive(Clone, Copy)]
pub(super) struct Rod {
    restitution: f64,
    friction: f64,
    /// Angle to the ground (rad).
    angle: f64,
    /// Speed downwards (m/s).
    speed: f64,
    /// Speed along the ground, away from the side of the mass centre (m/s).
    slip: f64,
}

impl Rod {
    /// Reads the settings.
    pub(super) fn new(settings: &[String]) -> Result<Rod, Failure> {
        let mut rod =
            Rod { restitution: 0.6, friction: 0.3, angle: 60_f64.to_radians(), speed: 3.0, slip: 1.0 };
        for setting in settings {
            let wrong = |expected: &str| Failure::Wrong(format!("--set {setting}: expected {expected}"));
            let value = value_of(setting)?;
            match name_of(setting) {
                "e" if (0.0..=1.0).contains(&value) => rod.restitution = value,
                "mu" if value >= 0.0 => rod.friction = value,
                "angle" if (0.0..=90.0).contains(&value) => rod.angle = value.to_radians(),
                "speed" if value > 0.0 => rod.speed = value,
                "slip" => rod.slip = value,
                _ => {
                    return Err(wrong(
                        "e from 0 to 1, mu of 0 or more, angle from 0 to 90, speed above 0, or slip",
                    ));
                }
            }
        }
        Ok(rod)
    }

    fn touch(&self) -> Touch<f64> {
        // J = m l^2/12 with m = l = 1; the end is at (x, y) relative to the mass centre.
        let (x, y) = (-0.5 * self.angle.cos(), -0.5 * self.angle.sin());
        let inverse_mass = [
            [1.0 + 12.0 * x * x, -12.0 * x * y, 0.0],
            [-12.0 * x * y, 1.0 + 12.0 * y * y, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let (friction, restitution) = (self.friction, self.restitution);
        Touch { inverse_mass, velocity: [-self.speed, self.slip, 0.0], friction, restitution }
    }

    /// Work and relative speeds over the normal impulse, each phase in a colour of its own.
    pub(super) fn draw(&self) -> plot::drawing::Drawing {
        let mut points = Vec::new();
        let impact = trace(&self.touch(), |point| points.push(point));
        let phases = [("compression", Stage::Compression), ("restitution", Stage::Restitution)];
        let mut work: Vec<Curve> = phases
            .into_iter()
            .map(|(name, stage)| {
                let (across, values) = work_curve(&points, stage);
                Curve { name: name.to_owned(), values, color: None, across: Some(across) }
            })
            .collect();
        // No impulse acts before the collision or at its first instant: both are the curve's first point.
        for name in ["pre-collision", "collision"] {
            if let Some(first) = points.first() {
                let (values, across) = (vec![first.work], Some(vec![first.impulse]));
                work.push(Curve { name: name.to_owned(), values, color: None, across });
            }
        }
        let speed = |name: &str, axis: usize| Curve {
            name: name.to_owned(),
            values: points.iter().map(|p| p.velocity[axis]).collect(),
            color: None,
            across: Some(points.iter().map(|p| p.impulse).collect()),
        };
        let panels = [
            Panel { label: "work [J]".to_owned(), curves: work },
            Panel { label: "speed [m/s]".to_owned(), curves: vec![speed("normal", 0), speed("slip", 1)] },
        ];
        let impulses: Vec<f64> = points.iter().map(|p| p.impulse).collect();
        let note = format!(
            "rod of 1 kg and 1 m at {:.0} deg, {} m/s down, {} m/s along, e = {}, mu = {}; W_c = {:.4} J, W_n = {:.4} J, friction {:.4} J",
            self.angle.to_degrees(),
            self.speed,
            self.slip,
            self.restitution,
            self.friction,
            impact.compression_work,
            impact.normal_work,
            impact.friction_work
        );
        chart::draw(&Chart {
            title: "Work over normal impulse of a rigid impact (Fig. 4.2)",
            note: &note,
            across: "normal impulse [N s]",
            time: &impulses,
            panels: &panels,
            events: &ends(&points),
        })
    }
}

/// The work over the impulse in one phase, interpolated by cubics with the slopes dW/dp = `v_n`.
fn work_curve(points: &[CurvePoint<f64>], stage: Stage) -> (Vec<f64>, Vec<f64>) {
    /// Intervals between two points.
    const PIECES: u32 = 24;
    let mut curve = (Vec::new(), Vec::new());
    // A piece belongs to the phase of its first point; the point at the end of compression is marked as restitution.
    let inside =
        |pair: &&[CurvePoint<f64>]| (pair[0].stage == Stage::Restitution) == (stage == Stage::Restitution);
    for pair in points.windows(2).filter(inside) {
        let (a, b) = (pair[0], pair[1]);
        let length = b.impulse - a.impulse;
        for n in 0..=PIECES {
            let s = f64::from(n) / f64::from(PIECES);
            let (h00, h10) = ((1.0 + 2.0 * s) * (1.0 - s).powi(2), s * (1.0 - s).powi(2));
            let (h01, h11) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
            curve.0.push(a.impulse + s * length);
            curve.1.push(
                h00 * a.work + h10 * length * a.velocity[0] + h01 * b.work + h11 * length * b.velocity[0],
            );
        }
    }
    curve
}

/// The impulses at the collision, at the end of compression, and at the end of restitution.
fn ends(points: &[CurvePoint<f64>]) -> Vec<f64> {
    let compressed = points.iter().find(|p| p.stage == Stage::Restitution);
    [points.first(), compressed, points.last()].into_iter().flatten().map(|p| p.impulse).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_impulse_only_grows_through_compression_and_restitution() {
        for settings in [vec![], vec!["mu=1.2"], vec!["e=1", "angle=20"], vec!["slip=-2", "mu=0.8"]] {
            let settings: Vec<String> = settings.into_iter().map(str::to_owned).collect();
            let mut points = Vec::new();
            let impact = trace(&Rod::new(&settings).expect("settings").touch(), |p| points.push(p));
            let [compression, restitution] =
                [Stage::Compression, Stage::Restitution].map(|stage| work_curve(&points, stage));
            let all: Vec<f64> = compression.0.iter().chain(&restitution.0).copied().collect();
            assert!(all.len() > 40 && all.windows(2).all(|p| p[0] <= p[1]), "{settings:?}");
            let marks = ends(&points);
            assert_eq!(marks.len(), 3);
            assert!(marks[0] == 0.0 && marks[1] == impact.compression && marks[2] == impact.impulse[0]);
            // The least work is where compression ends.
            let least = compression.1.iter().chain(&restitution.1).copied().fold(0.0, f64::min);
            assert!((least - impact.compression_work).abs() <= 1e-12, "{settings:?}");
        }
    }
}
