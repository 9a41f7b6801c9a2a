//! Finds rigid parts that may have passed through each other: contacts are looked for where steps end.
//!
//! In: the middles of parts that are free or fixed in space, before and after a step. Out: warnings of pairs that, near
//! each other and without a touch, moved by more than both parts are wide.

use super::assembly::{Assembly, Kind, Rigid};
use super::engine::Event;
use smartbed_runtime::surface::Shape;
use smartbed_runtime::vec3::{self, Vec3};

/// A pair of parts of finite width.
#[derive(Clone, Debug)]
struct Pair {
    parts: [usize; 2],
    /// Sums of the parts' least widths and of the radii of spheres about them (m).
    width: f64,
    reach: f64,
    /// Of a fixed box: its axes, and half its edges widened by the other part's sphere.
    fixed: Option<([Vec3<f64>; 3], Vec3<f64>)>,
    /// In how many steps they passed, and the largest relative speed (m/s) then.
    steps: usize,
    fastest: f64,
}

/// All pairs with contacts.
#[derive(Clone, Debug)]
pub(super) struct Passing(Vec<Pair>);

/// Least width of a shape and the radius of a sphere about it (m); `None` if no part passes through it in a step.
fn extent(shape: &Shape<f64>) -> Option<[f64; 2]> {
    let width = match shape {
        Shape::HalfSpace => return None,
        Shape::Sphere(sphere) => 2.0 * sphere.radius,
        Shape::Capsule(capsule) => 2.0 * capsule.radius,
        Shape::Cuboid(cuboid) => 2.0 * cuboid.half.into_iter().fold(f64::INFINITY, f64::min),
    };
    Some([width, shape.reach()?])
}

impl Pair {
    /// Whether the parts may meet on a straight way from one distance of their middles to another.
    fn meets(&self, from: Vec3<f64>, way: Vec3<f64>) -> bool {
        let Some((axes, half)) = &self.fixed else {
            let closest = (-vec3::dot(from, way) / vec3::dot(way, way)).clamp(0.0, 1.0);
            return vec3::norm(vec3::axpy(from, closest, way)) < self.reach;
        };
        // The part of the way, from 0 to 1, that lies within the box along all three of its axes.
        let mut within = [0.0_f64, 1.0];
        for (axis, half) in axes.iter().zip(half) {
            let (place, rate) = (vec3::dot(from, *axis), vec3::dot(way, *axis));
            let ends = [(-half - place) / rate, (half - place) / rate];
            if rate != 0.0 {
                within = [within[0].max(ends[0].min(ends[1])), within[1].min(ends[0].max(ends[1]))];
            } else if place.abs() > *half {
                return false;
            }
        }
        within[0] <= within[1]
    }
}

impl Passing {
    /// Watches the pairs of a world.
    pub(super) fn new(assembly: &Assembly) -> Self {
        let of = |part: usize| match &assembly.parts[part].kind {
            Kind::Rigid(rigid) if rigid.on.is_none() => extent(&rigid.shape),
            _ => None,
        };
        let fixed_box = |part: usize, wider: f64| match &assembly.parts[part].kind {
            Kind::Rigid(Rigid { shape: Shape::Cuboid(cuboid), body: None, start, .. }) => {
                Some((start.attitude.axes(), cuboid.half.map(|half| half + wider)))
            }
            _ => None,
        };
        let pair = |parts: [usize; 2]| {
            let [one, other] = [of(parts[0])?, of(parts[1])?];
            let fixed = fixed_box(parts[0], other[1]).or_else(|| fixed_box(parts[1], one[1]));
            Some(Pair {
                parts,
                width: one[0] + other[0],
                reach: one[1] + other[1],
                fixed,
                steps: 0,
                fastest: 0.0,
            })
        };
        Self(assembly.contacts.iter().filter_map(|contact| pair(contact.between)).collect())
    }

    /// Whether there is anything to watch.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Takes a step of h (s) with its events.
    pub(super) fn observe(&mut self, h: f64, [before, after]: [&[Vec3<f64>]; 2], events: &[Event]) {
        for pair in &mut self.0 {
            let [one, other] = pair.parts;
            let apart = |at: &[Vec3<f64>]| vec3::sub(at[one], at[other]);
            let (from, to) = (apart(before), apart(after));
            let way = vec3::sub(to, from);
            let length = vec3::norm(way);
            let touched = events.iter().any(|event| event.parts == pair.parts);
            if length > pair.width && pair.meets(from, way) && !touched {
                pair.steps += 1;
                pair.fastest = pair.fastest.max(length / h);
            }
        }
    }

    /// What is to be said at the end.
    pub(super) fn warnings(&self, assembly: &Assembly) -> Vec<String> {
        let passed = self.0.iter().filter(|pair| pair.steps > 0);
        let said = passed.map(|pair| {
            let [one, other] = pair.parts.map(|part| &assembly.parts[part].name);
            let steps = smartbed_codegen::words::count(pair.steps, "step");
            format!(
                "`{one}` and `{other}` moved by more than both are wide in {steps}, near each other and without a touch: they may \
                 have passed through each other unseen; take a step of at most {:.1e} s",
                pair.width / pair.fastest
            )
        });
        said.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_may_have_passed_through_is_counted() {
        let first = Pair { parts: [0, 1], width: 0.02, reach: 0.5, fixed: None, steps: 0, fastest: 0.0 };
        let pair = |way: [Vec3<f64>; 2], events: &[Event]| {
            let mut passing = Passing(vec![first.clone()]);
            passing.observe(1e-3, [&[way[0], [0.0; 3]], &[way[1], [0.0; 3]]], events);
            (passing.0[0].steps, passing.0[0].fastest)
        };
        let through = [[0.0, 0.1, 0.03], [0.0, 0.1, -0.02]];
        let (steps, fastest) = pair(through, &[]);
        assert!(steps == 1 && (fastest - 50.0).abs() < 1e-9, "{fastest}");
        let struck = Event { time: 0.0, parts: [0, 1], points: 1, approach: 1.0, impulse: 1.0 };
        assert_eq!(pair(through, &[struck]).0, 0, "it was seen");
        assert_eq!(pair([[0.0, 0.6, 0.03], [0.0, 0.6, -0.02]], &[]).0, 0, "it flew by");
        assert_eq!(pair([[0.0, 0.0, 0.015], [0.0, 0.0, 0.0]], &[]).0, 0, "no step is that long");
        assert_eq!(pair([[0.0; 3]; 2], &[]).0, 0, "nothing moves");
        // A plate of 1 m, turned by 45 degrees about x.
        let c = 0.5_f64.sqrt();
        let plate = Pair {
            fixed: Some(([[1.0, 0.0, 0.0], [0.0, c, c], [0.0, -c, c]], [0.51, 0.51, 0.011])),
            ..first.clone()
        };
        assert!(plate.meets([0.0, 0.2, 0.3], [0.0, 0.0, -0.2]));
        assert!(!plate.meets([0.0, 0.2, 0.5], [0.0, 0.0, -0.2]), "it stops before");
        assert!(!plate.meets([0.6, 0.2, 0.3], [0.0, 0.0, -0.2]), "it passes beside");
        assert!(!plate.meets([0.0, 0.2, 0.3], [0.0, 0.1, 0.1]), "it flies along");
    }
}
