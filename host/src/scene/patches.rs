//! Groups the springs of a body into patches of neighbours, so that the runtime finds their nodes in the innermost
//! cache.
//!
//! In: the springs. Out: the memory that [`Patches`] borrows. Within a patch springs are ordered by rank, one more than
//! the highest rank of the springs before them at either end. Springs of one rank share no node, so that no sum waits
//! for another; at each node the order of the list is kept, so that forces agree with those of the list bit for bit. If
//! the list jumps from place to place, it is first put in the order of Cuthill & McKee (1969); sums then differ by
//! rounding.

use std::collections::VecDeque;

use smartbed_runtime::flexible::Spring;
use smartbed_runtime::flexible::patch::{NODES, Patches};
use smartbed_runtime::real::Scalar;

/// Fewer springs than this gain nothing.
const FEW: usize = 64;
/// A body with fewer springs keeps their order: its nodes are always near in memory. So must a chip, which sums in that
/// order and has no room for more.
const SMALL: usize = 4096;
/// The order jumps if more nodes per spring than this are copied.
const JUMPS: f64 = 1.25;

/// The memory that a [`Patches`] borrows.
#[derive(Clone, Debug)]
pub struct Patched<S> {
    ends: Vec<[usize; 2]>,
    nodes: Vec<usize>,
    springs: Vec<[u8; 2]>,
    stiffness: Vec<S>,
    rest_length: Vec<S>,
    damping: Vec<S>,
    is_damped: bool,
}

impl<S: Scalar> Patched<S> {
    /// Divides the springs of a body into patches; `None` if there are few.
    pub fn new(springs: &[Spring<S>], points: usize) -> Option<Self> {
        if springs.len() < FEW {
            return None;
        }
        let listed = Self::cut(springs.iter(), points);
        let jumps = listed.nodes.len() as f64 > JUMPS * springs.len() as f64;
        if springs.len() < SMALL || !jumps {
            return Some(listed);
        }
        let sorted = Self::cut(by_neighbours(springs, points).into_iter().map(|i| &springs[i]), points);
        Some(if sorted.nodes.len() < listed.nodes.len() { sorted } else { listed })
    }

    /// Takes the springs one after the other; a patch ends before the spring that would give it more than [`NODES`].
    fn cut<'s>(springs: impl Iterator<Item = &'s Spring<S>>, points: usize) -> Self
    where
        S: 's,
    {
        let (mut ends, mut nodes) = (Vec::new(), Vec::new());
        let mut ranked: Vec<(usize, [u8; 2], &Spring<S>)> = Vec::new();
        // Index of each point in `nodes`, below `first` if it is not in the current patch, and the last rank of its
        // springs.
        let (mut place, mut ranks, mut first) = (vec![None; points], Vec::new(), 0);
        for spring in springs {
            let pair = [spring.tail, spring.head];
            let is_new = |end: &&usize| place[**end].is_none_or(|place| place < first);
            if nodes.len() + pair.iter().filter(is_new).count() > first + NODES {
                ends.push([nodes.len(), ranked.len()]);
                first = nodes.len();
            }
            let local = pair.map(|end| match place[end] {
                Some(place) if place >= first => place,
                _ => {
                    place[end] = Some(nodes.len());
                    nodes.push(end);
                    ranks.push(0);
                    nodes.len() - 1
                }
            });
            let rank = 1 + ranks[local[0]].max(ranks[local[1]]);
            local.iter().for_each(|end| ranks[*end] = rank);
            let byte = |place| {
                u8::try_from(place - first).expect("a patch has no more nodes than a byte has values")
            };
            ranked.push((rank, local.map(byte), spring));
        }
        ends.push([nodes.len(), ranked.len()]);
        let mut from = 0;
        for [_, to] in &ends {
            ranked[from..*to].sort_by_key(|(rank, ..)| *rank);
            from = *to;
        }
        let list = |of: fn(&Spring<S>) -> S| ranked.iter().map(|(.., spring)| of(spring)).collect::<Vec<S>>();
        let damping = list(|spring| spring.damping);
        Patched {
            ends,
            nodes,
            springs: ranked.iter().map(|(_, pair, _)| *pair).collect(),
            stiffness: list(|spring| spring.stiffness),
            rest_length: list(|spring| spring.rest_length),
            is_damped: damping.iter().any(|damping| *damping > S::ZERO),
            damping,
        }
    }

    /// The patches.
    pub fn view(&self) -> Patches<'_, S> {
        Patches {
            ends: &self.ends,
            nodes: &self.nodes,
            springs: &self.springs,
            stiffness: &self.stiffness,
            rest_length: &self.rest_length,
            damping: &self.damping,
            is_damped: self.is_damped,
        }
    }
}

/// The springs ordered by their first end, then as listed; points are ordered by breadth-first searches, neighbours
/// with few springs first. Linear in springs and points except for sorting the neighbours of each point.
fn by_neighbours<S: Scalar>(springs: &[Spring<S>], points: usize) -> Vec<usize> {
    let touched = |i: usize| [springs[i].tail, springs[i].head];
    let of_point = buckets(points, (0..springs.len()).flat_map(|i| touched(i).map(|end| (end, i))));
    let degree = |point: usize| of_point.starts[point + 1] - of_point.starts[point];
    let (mut rank, mut ranked, mut walk) = (vec![usize::MAX; points], 0, VecDeque::new());
    for start in 0..points {
        if rank[start] != usize::MAX {
            continue;
        }
        (rank[start], ranked) = (ranked, ranked + 1);
        walk.push_back(start);
        while let Some(point) = walk.pop_front() {
            let ends = of_point.of(point).iter().flat_map(|i| touched(*i));
            let mut next: Vec<usize> = ends.filter(|end| rank[*end] == usize::MAX).collect();
            next.sort_by_key(|end| degree(*end));
            for end in next {
                if rank[end] == usize::MAX {
                    (rank[end], ranked) = (ranked, ranked + 1);
                    walk.push_back(end);
                }
            }
        }
    }
    let first = |i: usize| touched(i).map(|end| rank[end]).into_iter().min().unwrap_or_default();
    buckets(points, (0..springs.len()).map(|i| (first(i), i))).items
}

/// Items sorted by bucket, in their order, and the index at which each bucket begins.
struct Buckets {
    starts: Vec<usize>,
    items: Vec<usize>,
}

impl Buckets {
    fn of(&self, bucket: usize) -> &[usize] {
        &self.items[self.starts[bucket]..self.starts[bucket + 1]]
    }
}

/// Sorts pairs of a bucket and an item by counting sort.
fn buckets(count: usize, pairs: impl Iterator<Item = (usize, usize)> + Clone) -> Buckets {
    let mut starts = vec![0; count + 1];
    pairs.clone().for_each(|(bucket, _)| starts[bucket + 1] += 1);
    (0..count).for_each(|bucket| starts[bucket + 1] += starts[bucket]);
    let (mut next, mut items) = (starts.clone(), vec![0; starts[count]]);
    for (bucket, item) in pairs {
        items[next[bucket]] = item;
        next[bucket] += 1;
    }
    Buckets { starts, items }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::shape;
    use smartbed_runtime::flexible::{Body, force};
    use smartbed_runtime::ode::nodes::MeanStep;
    use smartbed_runtime::vec3::Vec3;
    use std::collections::BTreeSet;

    /// Cubes of 8 a side, every spring its own numbers, each end somewhere else if points and springs are drawn by lot.
    fn body(drawn: bool) -> (Vec<Vec3<f64>>, Vec<Spring<f64>>) {
        let lists = shape::cubes(8, 8, 8, 0.1);
        let (points, count) = (lists.points.len(), lists.springs.len());
        // Multiples of a number without a common divisor come everywhere once.
        let (place, order) = if drawn { (611, 7919) } else { (1, 1) };
        assert!([(points, place), (count, order)].iter().all(|(n, step)| n % step != 0 || *step == 1));
        let mut pos = vec![[0.0; 3]; points];
        for (i, [x, y, z]) in lists.points.iter().enumerate() {
            pos[i * place % points] = [*x, *y + 0.01 * (7.0 * x).sin(), *z + 0.02 * (5.0 * y).cos()];
        }
        let spring = |i: usize| {
            let [tail, head] = lists.springs[i].map(|end| end * place % points);
            let k = i as f64;
            Spring {
                tail,
                head,
                stiffness: 100.0 + k,
                damping: 1.0 + (i % 3) as f64,
                rest_length: lists.rest_lengths[i],
            }
        };
        (pos, (0..count).map(|i| spring(i * order % count)).collect())
    }

    /// Forces of positions, of speeds and their means over a step, as a list and in patches.
    fn forces(
        pos: &[Vec3<f64>],
        springs: &[Spring<f64>],
        patches: Option<Patches<f64>>,
    ) -> [Vec<Vec3<f64>>; 3] {
        let n = pos.len();
        let (mass, fixed) = (vec![1.0; n], vec![false; n]);
        let plain = Body { mass: &mass, fixed: &fixed, springs, gravity: [0.0, 0.1, -9.81], ..Body::none() };
        let body = Body::new(Body { patches, air_drag: 0.1, ..plain }).expect("a body");
        let vel: Vec<Vec3<f64>> = pos.iter().map(|[x, y, z]| [*y, -*z, *x * *y]).collect();
        let dx: Vec<Vec3<f64>> = vel.iter().map(|v| v.map(|v| 0.1 * v)).collect();
        let way = MeanStep { h: 0.1, pos: [pos, pos, pos], dx: &dx, vel: &vel };
        let mut found = [(); 3].map(|()| vec![[0.0; 3]; n]);
        force::eval_elastic(&body, &body.elements(), pos, &mut found[0]).expect("forces");
        force::eval_viscous(&body, &body.elements(), pos, &vel, &mut found[1]);
        force::eval_mean(&body, &body.elements(), &way, &mut found[2]).expect("forces");
        found
    }

    #[test]
    fn patches_in_the_order_of_the_list_have_its_bits() {
        let (pos, springs) = body(false);
        let patched = Patched::new(&springs, pos.len()).expect("patches");
        let view = patched.view();
        assert!(view.ends.len() > 1, "some patches");
        assert!(forces(&pos, &springs, Some(view)) == forces(&pos, &springs, None));
    }

    #[test]
    fn springs_drawn_by_lot_are_put_beside_their_neighbours() {
        let (pos, springs) = body(true);
        let patched = Patched::new(&springs, pos.len()).expect("patches");
        let view = patched.view();
        assert!(
            (view.nodes.len() as f64) < JUMPS * springs.len() as f64,
            "{} nodes copied",
            view.nodes.len()
        );
        let (mut from, mut found) = ([0; 2], BTreeSet::new());
        for to in view.ends {
            let nodes = &view.nodes[from[0]..to[0]];
            assert!(nodes.len() <= NODES && nodes.iter().collect::<BTreeSet<_>>().len() == nodes.len());
            for i in from[1]..to[1] {
                let [tail, head] = view.springs[i].map(|end| nodes[usize::from(end)]);
                found.insert((tail, head, view.stiffness[i].to_bits(), view.rest_length[i].to_bits()));
            }
            from = *to;
        }
        let wanted: BTreeSet<_> = springs
            .iter()
            .map(|s| (s.tail, s.head, s.stiffness.to_bits(), s.rest_length.to_bits()))
            .collect();
        assert!(found == wanted, "each spring once");
        let (patches, list) = (forces(&pos, &springs, Some(view)), forces(&pos, &springs, None));
        let largest = list.iter().flatten().flatten().fold(0.0_f64, |largest, f| largest.max(f.abs()));
        let pairs = patches.iter().flatten().flatten().zip(list.iter().flatten().flatten());
        for (a, b) in pairs {
            assert!((a - b).abs() <= 1e-14 * largest, "{a} {b}");
        }
    }
}
