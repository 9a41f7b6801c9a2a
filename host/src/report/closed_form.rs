//! Exact motions of the scenes that have a closed form.
//!
//! Regular polygon let go stretched, without gravity: its radius swings as r'' = -w^2 (r - r_rest) with
//! w^2 = 4 K sin^2(pi/n)/m. Vertical spring of two equal masses: harmonic in the air (relative motion,
//! w^2 = 2 K/m) and on the ground (w^2 = K/m), joined at the roots of closed forms by the impact law.

use super::subject::{SAMPLES, Trace};
use crate::scene::Scene;
use smartbed_runtime::contact::ContactLaw;
use std::time::Duration;

/// The exact motion if the scene of this name has one.
#[must_use]
pub fn of(name: &str, scene: &Scene, seconds: f64) -> Option<(&'static str, Trace)> {
    let undamped = scene.around.air_drag == 0.0 && scene.lists.damping.iter().all(|c| *c == 0.0);
    let times = (1..=SAMPLES).map(|n| seconds * n as f64 / SAMPLES as f64);
    let (text, samples): (_, Vec<Vec<f64>>) = match name {
        "closed_loop_3_links" if undamped => {
            ("breathing polygon", times.map(|t| polygon(scene, t)).collect())
        }
        "single_spring" if undamped => ("harmonic between events", Bouncing::new(scene)?.at(times)),
        _ => return None,
    };
    Some((text, Trace { samples, evaluations: None, elapsed: Duration::ZERO }))
}

/// Every corner moves along its radius.
fn polygon(scene: &Scene, t: f64) -> Vec<f64> {
    let lists = &scene.lists;
    let n = lists.points.len() as f64;
    let half = (std::f64::consts::PI / n).sin();
    let w = 2.0 * half * (lists.stiffness[0] / lists.masses[0]).sqrt();
    let centre = [0, 1, 2].map(|c| lists.points.iter().map(|p| p[c]).sum::<f64>() / n);
    let radius = (0..3).map(|c| (lists.points[0][c] - centre[c]).powi(2)).sum::<f64>().sqrt();
    let rest = lists.rest_lengths[0] / (2.0 * half);
    let scale = (rest + (radius - rest) * (w * t).cos()) / radius;
    let place = |p: &[f64; 3]| [0, 1, 2].map(|c| centre[c] + scale * (p[c] - centre[c]));
    lists.points.iter().flat_map(place).collect()
}

/// Two equal masses on a vertical spring, dropped.
struct Bouncing {
    mass: f64,
    stiffness: f64,
    length: f64,
    gravity: f64,
    start: [f64; 2],
}

/// Heights and speeds of the lower and the upper mass.
type State = [f64; 4];

impl Bouncing {
    fn new(scene: &Scene) -> Option<Self> {
        let lists = &scene.lists;
        let law = scene.around.ground?.law;
        let fits = matches!(law, ContactLaw::Compensation { eta: 1.0, .. })
            && lists.springs.len() == 1
            && lists.masses[0] == lists.masses[1]
            && lists.velocities.iter().flatten().all(|v| *v == 0.0);
        fits.then(|| Self {
            mass: lists.masses[0],
            stiffness: lists.stiffness[0],
            length: lists.rest_lengths[0],
            gravity: -scene.around.gravity[2],
            start: [lists.points[0][2], lists.points[1][2]],
        })
    }

    /// Positions of both masses at increasing times.
    fn at(&self, times: impl Iterator<Item = f64>) -> Vec<Vec<f64>> {
        let (mut begin, mut state, mut held) = (0.0, [self.start[0], self.start[1], 0.0, 0.0], false);
        let mut end = self.phase_end(state, held);
        let mut places = Vec::new();
        for t in times {
            while t >= begin + end {
                state = self.after(state, held, end);
                begin += end;
                (state, held) = if held { (state, false) } else { self.touch(state) };
                end = self.phase_end(state, held);
            }
            let [low, high, ..] = self.after(state, held, t - begin);
            places.push(vec![0.0, 0.0, low, 0.0, 0.0, high]);
        }
        places
    }

    /// The state `t` later in the same phase.
    fn after(&self, [low, high, v_low, v_high]: State, held: bool, t: f64) -> State {
        let (k, m, g) = (self.stiffness, self.mass, self.gravity);
        if held {
            let w = (k / m).sqrt();
            let middle = self.length - m * g / k;
            let (s, c) = (w * t).sin_cos();
            let x = high - middle;
            return [0.0, middle + x * c + v_high / w * s, 0.0, v_high * c - x * w * s];
        }
        let w = (2.0 * k / m).sqrt();
        let (s, c) = (w * t).sin_cos();
        let (x, v) = (high - low - self.length, v_high - v_low);
        let (stretch, rate) = (x * c + v / w * s, v * c - x * w * s);
        let (v_mean, mean) = (0.5 * (v_low + v_high), 0.5 * (low + high));
        let centre = mean + v_mean * t - 0.5 * g * t * t;
        let fall = v_mean - g * t;
        let half = 0.5 * (self.length + stretch);
        [centre - half, centre + half, fall - 0.5 * rate, fall + 0.5 * rate]
    }

    /// Time until the lower mass touches the ground, or until the ground would have to pull it.
    fn phase_end(&self, state: State, held: bool) -> f64 {
        let release = self.length + self.mass * self.gravity / self.stiffness;
        let guard = |t: f64| {
            let [low, high, ..] = self.after(state, held, t);
            if held { release - high } else { low }
        };
        // Fine relative to the fastest oscillation, so that no touch is missed between two times.
        let stride = 0.01 / (2.0 * self.stiffness / self.mass).sqrt();
        let mut n = 1_u32;
        while guard(f64::from(n) * stride) > 0.0 && f64::from(n) * stride < 100.0 {
            n += 1;
        }
        let (mut early, mut late) = (f64::from(n - 1) * stride, f64::from(n) * stride);
        while late - early > f64::EPSILON * late {
            let middle = 0.5 * (early + late);
            if middle <= early || middle >= late {
                break;
            }
            *(if guard(middle) > 0.0 { &mut early } else { &mut late }) = middle;
        }
        late
    }

    /// The impact: the lower mass stops, the upper one takes its energy. Returns whether the ground then holds the
    /// lower one.
    fn touch(&self, [_, high, v_low, v_high]: State) -> (State, bool) {
        let speed = v_low.hypot(v_high);
        // Downwards, unless the upper mass is already rising or the ground would have to pull.
        let down = v_high <= 0.0 && -v_low - v_high - speed >= 0.0;
        let v_high = if down { -speed } else { speed };
        let pushes = self.mass * self.gravity - self.stiffness * (high - self.length) > 0.0;
        ([0.0, high, 0.0, v_high], pushes)
    }
}
