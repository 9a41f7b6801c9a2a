//! A motion of the whole tile from heights to heights, all legs along one profile.
//!
//! In: heights at start and end, speed. Out: wanted motion of each leg at each tick.
//! Heights are linear in heave and slopes, h_i = zc - R (tx cos alpha_i + ty sin alpha_i), so a straight line in
//! heights is also one in heave and slopes: the platform takes the shortest path, without torsion.

use super::design::{LEG_SPEED, RADIUS, RETREAT, SLOPE, SLOPE_RATE, STROKE, UNHOMED_FACTOR};
use super::profile::{Along, Profile};
use crate::command::Pose;
use crate::link::message::Refusal;
use smartbed_runtime::real::Real;

/// A leg with a smaller displacement does not count as moving (m): it may stick throughout.
const STAYS: f32 = 2e-4;

/// Heights of the legs (m).
pub type Heights = [f32; 3];

/// A motion in progress.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Motion {
    from: Heights,
    to: Heights,
    profile: Profile,
    tick: u32,
}

/// Heights of a commanded pose, checked against the limits.
///
/// # Errors
/// [`Refusal::Tilt`], [`Refusal::Stroke`], [`Refusal::NonFinite`].
pub fn heights(pose: Pose) -> Result<Heights, Refusal> {
    let steepness = pose.tx * pose.tx + pose.ty * pose.ty;
    let heights = pose.heights(RADIUS);
    if !(steepness.is_finite() && heights.iter().all(|h| h.is_finite())) {
        return Err(Refusal::NonFinite);
    }
    if steepness > SLOPE * SLOPE {
        return Err(Refusal::Tilt);
    }
    if heights.iter().any(|h| Real::abs(*h) > STROKE) {
        return Err(Refusal::Stroke);
    }
    Ok(heights)
}

/// Heave and slopes of these heights: the inverse of [`Pose::heights`].
#[must_use]
pub fn pose([a, b, c]: Heights) -> Pose {
    const SQRT_3: f32 = 1.732_050_8;
    let zc = (a + b + c) / 3.0;
    Pose { zc, tx: (b - c) / (SQRT_3 * RADIUS), ty: (b + c - 2.0 * a) / (3.0 * RADIUS) }
}

impl Motion {
    /// From heights to heights, with this factor on the usual speed.
    #[must_use]
    pub fn new(from: Heights, to: Heights, factor: f32) -> Self {
        let (start, end) = (pose(from), pose(to));
        let turn = Real::sqrt(square(end.tx - start.tx) + square(end.ty - start.ty));
        let way = difference(to, from).map(Real::abs).into_iter().fold(0.0, Real::max);
        let seconds = Real::max(turn / SLOPE_RATE, way / LEG_SPEED) / factor;
        // The profile runs from s = 0 to 1; a displacement of 0 takes the time of a ramp.
        let speed = 1.0 / Real::max(seconds, 1e-3);
        Self { from, to, profile: Profile::new(1.0, speed), tick: 0 }
    }

    /// Wanted motion of each leg at this tick.
    #[must_use]
    pub fn wanted(&self) -> [Along; 3] {
        let along = self.profile.at(self.tick);
        let mut wanted = [Along::default(); 3];
        for ((leg, from), to) in wanted.iter_mut().zip(self.from).zip(self.to) {
            let way = to - from;
            *leg = Along {
                position: from + way * along.position,
                speed: way * along.speed,
                acceleration: way * along.acceleration,
            };
        }
        wanted
    }

    /// Length of the motion in ticks.
    #[must_use]
    pub fn ticks(&self) -> u32 {
        self.profile.ticks()
    }

    /// Displacement of each leg, positive up (m).
    #[must_use]
    pub fn ways(&self) -> [f32; 3] {
        difference(self.to, self.from)
    }

    /// Heights at the end.
    #[must_use]
    pub fn end(&self) -> Heights {
        self.to
    }

    /// Advances by a tick; returns the number of ticks since the end, once it is reached.
    pub fn advance(&mut self) -> Option<u32> {
        self.tick = self.tick.saturating_add(1);
        self.tick.checked_sub(self.ticks())
    }

    /// A slow motion back from here: 5 mm for the leg with the largest displacement, within the stroke.
    // Once in the image.
    #[inline(never)]
    #[must_use]
    pub fn back(&self, here: Heights) -> Self {
        let way = difference(self.from, self.to);
        let longest = way.map(Real::abs).into_iter().fold(0.0, Real::max);
        let scale = if longest > 0.0 { RETREAT / longest } else { 0.0 };
        let mut to = here;
        for (to, way) in to.iter_mut().zip(way) {
            *to = Real::max(Real::min(*to + way * scale, STROKE), -STROKE);
        }
        // Not steeper than may be commanded: a motion that has just left a steep pose returns to it.
        let is_allowed = heights(pose(to)).is_ok();
        Self::new(here, if is_allowed { to } else { self.from }, UNHOMED_FACTOR)
    }
}

/// Direction of a leg with this displacement (m): 1 up, -1 down, 0 if it hardly moves.
#[must_use]
pub fn sign(way: f32) -> f32 {
    match () {
        () if way > STAYS => 1.0,
        () if way < -STAYS => -1.0,
        () => 0.0,
    }
}

fn square(x: f32) -> f32 {
    x * x
}

fn difference(mut a: Heights, b: Heights) -> Heights {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= b);
    a
}

#[cfg(test)]
mod tests {
    use super::{LEG_SPEED, Motion, RETREAT, SLOPE_RATE, heights, pose};
    use crate::command::Pose;
    use crate::link::message::Refusal;
    use proptest::prelude::proptest;

    proptest! {
        #[test]
        fn rates_stay_below_their_limits(zc in -0.01_f32..0.01, tx in -0.1_f32..0.1, ty in -0.1_f32..0.1) {
            let to = heights(Pose { zc, tx, ty }).expect("it is within the stroke");
            let back = pose(to);
            assert!((back.zc - zc).abs() < 1e-7 && (back.tx - tx).abs() < 1e-6 && (back.ty - ty).abs() < 1e-6);
            let mut motion = Motion::new([0.0; 3], to, 1.0);
            let mut last = motion.wanted();
            while motion.advance().is_none() {
                let wanted = motion.wanted();
                let (was, is) = (pose(last.map(|w| w.position)), pose(wanted.map(|w| w.position)));
                let rate = f32::hypot(is.tx - was.tx, is.ty - was.ty) / 1e-3;
                // Differences of f32 near 0.1 over 1 ms carry some 1e-5 of rounding.
                assert!(rate <= SLOPE_RATE + 3e-4, "{rate}");
                assert!(wanted.iter().all(|w| w.speed.abs() <= LEG_SPEED * 1.0001));
                last = wanted;
            }
            assert_eq!(motion.wanted().map(|w| w.position), to);
        }
    }

    #[test]
    fn wrong_poses_are_refused_and_never_clamped() {
        let refusal = |zc, tx| heights(Pose { zc, tx, ty: 0.0 }).err();
        assert_eq!(refusal(0.0, 0.27), Some(Refusal::Tilt));
        assert_eq!(refusal(0.0291, 0.0), Some(Refusal::Stroke));
        assert_eq!(refusal(-0.02, 0.2), Some(Refusal::Stroke));
        assert_eq!(refusal(f32::NAN, 0.0), Some(Refusal::NonFinite));
        assert_eq!(refusal(0.0, f32::INFINITY), Some(Refusal::NonFinite));
        assert_eq!(refusal(0.0, 0.26), None);
    }

    #[test]
    fn the_way_back_is_five_millimetres() {
        let motion = Motion::new([0.0; 3], [0.02, 0.01, 0.0], 1.0);
        let mut back = motion.back([0.01, 0.005, 0.0]);
        while back.advance().is_none() {}
        let [a, b, c] = back.wanted().map(|w| w.position);
        assert!((a - (0.01 - RETREAT)).abs() < 1e-7 && (b - 0.0025).abs() < 1e-7 && c == 0.0);
        // From 15 degrees: 5 mm back would be steeper.
        let steep = heights(Pose { zc: 0.0, tx: 0.0, ty: 0.26 }).expect("it is allowed");
        let back = Motion::new(steep, [0.0; 3], 1.0).back(steep.map(|h| 0.95 * h));
        assert_eq!(back.end(), steep);
    }
}
