//! Steps groups of parts that are apart, each group by itself.
//!
//! In: a world, the length of a step. Out: the world after it. Parts joined by attachments form a component; components
//! whose bounding boxes are so near that they may touch within a few steps form a group. Each group is a [`Subset`]
//! with its own data, so that groups run on any number of threads with the same bits. A group in which everything has
//! been slower than `run.sleep` for a while is frozen until something comes near it or an input changes.

use super::reach::Reach;
use super::subset::Subset;
use super::{CarriedWorld, Place, words};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Event;
use smartbed_runtime::vec3;
use smartbed_runtime::world::Carrier;
use std::num::NonZero;
use std::thread;

/// Time (s) for which everything in a group must be slow before it is frozen.
const QUIET: f64 = 0.1;
/// Below this number of nodes in all groups, threads cost more time than they save.
const MANY_NODES: usize = 2_000;

/// The components of a world, and their grouping.
#[derive(Clone, Debug)]
pub(super) struct Islands {
    /// By part: its component; `None` if it is fixed in space.
    component: Vec<Option<usize>>,
    /// By component: its bounding box and fastest speed.
    reaches: Vec<Reach>,
    /// By component: whether a command may change its speed at once, so that its speed now says nothing of its reach.
    leaps: Vec<bool>,
    /// By component: time for which it has been slow (s).
    quiet: Vec<f64>,
    /// Components whose parts may touch.
    pairs: Vec<[usize; 2]>,
    groups: Vec<Island>,
    /// Speed below which a component counts as slow (m/s).
    sleep: Option<f64>,
    threads: usize,
}

/// A group of components that are stepped together.
#[derive(Clone, Debug)]
struct Island {
    components: Vec<usize>,
    subset: Subset,
    stands: bool,
}

impl Islands {
    /// For a world; `None` if it is a single component that is never frozen.
    pub(super) fn new(world: &CarriedWorld, sleep: Option<f64>) -> Option<Islands> {
        let component = components(world);
        let count = component.iter().flatten().max().map_or(0, |last| last + 1);
        if count < 2 && sleep.is_none() {
            return None;
        }
        let contacts = world.touching.iter().flat_map(|touching| &touching.parts);
        let mut pairs: Vec<[usize; 2]> = contacts
            .filter_map(|[a, b]| Some([component[*a]?, component[*b]?]))
            .filter(|[a, b]| a != b)
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let threads = thread::available_parallelism().map_or(1, NonZero::get);
        let (reaches, quiet, groups) = (vec![Reach::NOTHING; count], vec![0.0; count], Vec::new());
        let mut leaps = vec![false; count];
        for (part, place) in world.places.iter().enumerate() {
            if let (Place::Carrier(own, _), Some(component)) = (place, component[part])
                && matches!(&world.carriers[*own], HostCarrier::Mechanism(own) if own.switches.may_leap)
            {
                leaps[component] = true;
            }
        }
        Some(Islands { component, reaches, leaps, quiet, pairs, groups, sleep, threads })
    }

    /// The values that a checkpoint needs.
    pub(super) fn save(&self) -> &[f64] {
        if self.sleep.is_some() { &self.quiet } else { &[] }
    }

    /// From [`Islands::save`].
    pub(super) fn load(&mut self, numbers: &[f64]) {
        self.quiet.iter_mut().zip(numbers).for_each(|(to, from)| *to = *from);
        self.forget();
    }

    /// Discards the grouping, because the state was changed from outside.
    pub(super) fn forget(&mut self) {
        self.groups.clear();
    }

    /// Unfreezes the group of a part, because something acts on it differently now.
    pub(super) fn wake(&mut self, part: usize) {
        let Some(component) = self.component[part] else { return };
        for group in self.groups.iter_mut().filter(|group| group.components.contains(&component)) {
            group.stands = false;
            group.components.iter().for_each(|own| self.quiet[*own] = 0.0);
        }
        self.quiet[component] = 0.0;
    }

    /// Steps all groups; after an error the world is as before.
    pub(super) fn step(
        &mut self,
        whole: &mut CarriedWorld,
        h: f64,
        found: &mut Vec<Event>,
    ) -> Result<(), String> {
        self.group(whole, h)?;
        let moving = self.groups.iter_mut().filter(|group| !group.stands);
        let mut moving: Vec<&mut Subset> = moving.map(|group| &mut group.subset).collect();
        moving.iter_mut().for_each(|subset| subset.take(whole));
        let mut events = step_all(&mut moving, h, self.threads)?;
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        found.extend(events);
        if let Some(touching) = &mut whole.touching {
            touching.fall_silent();
        }
        whole.t += h;
        for group in &mut self.groups {
            if !group.stands {
                group.subset.give(whole);
                for (part, reach) in group.subset.reaches() {
                    if let Some(component) = self.component[part] {
                        self.reaches[component].join(&reach);
                    }
                }
            }
            group.subset.tell(whole);
        }
        self.rest(whole, h)
    }

    /// Groups the components that are near one another; a group with the same members as before keeps its data.
    fn group(&mut self, whole: &mut CarriedWorld, h: f64) -> Result<(), String> {
        if self.groups.is_empty() {
            let (t, x) = (whole.t, whole.x.clone());
            whole.with(|mut island| island.place(t, &x)).map_err(words)?;
            let everything: Vec<usize> = (0..self.component.len()).collect();
            self.reaches.fill(Reach::NOTHING);
            for (part, reach) in whole.subset(&everything).reaches() {
                if let Some(component) = self.component[part] {
                    self.reaches[component].join(&reach);
                }
            }
        }
        let gravity = vec3::norm(whole.fixed.gravity);
        let near = |[a, b]: &&[usize; 2]| {
            self.leaps[*a] || self.leaps[*b] || self.reaches[*a].is_near(&self.reaches[*b], h, gravity)
        };
        let groups = joined(self.reaches.len(), self.pairs.iter().filter(near).copied());
        if self.groups.iter().map(|group| &group.components).eq(&groups) {
            self.forget_reaches();
            return Ok(());
        }
        let mut old: Vec<Island> = std::mem::take(&mut self.groups);
        for components in groups {
            let known = old.iter().position(|group| group.components == components);
            self.groups.push(match known {
                Some(known) => old.swap_remove(known),
                None => {
                    let own = |part: &usize| self.component[*part].is_some_and(|c| components.contains(&c));
                    let parts: Vec<usize> = (0..self.component.len()).filter(own).collect();
                    let subset = whole.subset(&parts);
                    let slow = components.iter().all(|component| self.quiet[*component] >= QUIET);
                    let stands = slow && self.sleep.is_some() && !subset.is_driven();
                    Island { components, subset, stands }
                }
            });
        }
        self.forget_reaches();
        Ok(())
    }

    /// Discards the bounding boxes of moving groups, which their next step computes anew.
    fn forget_reaches(&mut self) {
        for group in self.groups.iter().filter(|group| !group.stands) {
            group.components.iter().for_each(|own| self.reaches[*own] = Reach::NOTHING);
        }
    }

    /// Freezes groups that have been slow for long enough; their remaining kinetic energy is booked as damping.
    fn rest(&mut self, whole: &mut CarriedWorld, h: f64) -> Result<(), String> {
        let Some(least) = self.sleep else { return Ok(()) };
        for group in self.groups.iter_mut().filter(|group| !group.stands) {
            let is_slow = group.subset.fastest() < least;
            for own in &group.components {
                self.quiet[*own] = if is_slow { self.quiet[*own] + h } else { 0.0 };
            }
            let is_quiet = group.components.iter().all(|own| self.quiet[*own] >= QUIET);
            if is_quiet && !group.subset.is_driven() {
                group.subset.stop(whole)?;
                group.stands = true;
            }
        }
        Ok(())
    }
}

/// Steps each subset by itself, on this number of threads; events are in the order of the subsets.
fn step_all(moving: &mut [&mut Subset], h: f64, threads: usize) -> Result<Vec<Event>, String> {
    let nodes: usize = moving.iter().map(|subset| subset.points()).sum();
    let threads = if nodes < MANY_NODES { 1 } else { threads.min(moving.len()) };
    let share = moving.len().div_ceil(threads.max(1)).max(1);
    let step = |subsets: &mut [&mut Subset]| -> Result<Vec<Event>, String> {
        let mut events = Vec::new();
        for subset in subsets {
            subset.world.breathing(h, |world| world.move_on(h, &mut events))?;
        }
        Ok(events)
    };
    if threads < 2 {
        return step(moving);
    }
    let results: Vec<_> = thread::scope(|scope| {
        let running: Vec<_> = moving.chunks_mut(share).map(|own| scope.spawn(move || step(own))).collect();
        running.into_iter().map(thread::ScopedJoinHandle::join).collect()
    });
    let mut events = Vec::new();
    for result in results {
        events.extend(result.map_err(|_| "a thread that stepped parts ended early".to_owned())??);
    }
    Ok(events)
}

/// By part: its component. Attachments join parts; a surface on a port belongs to the mechanism that carries it.
fn components(world: &CarriedWorld) -> Vec<Option<usize>> {
    let carriers: Vec<usize> = (world.carriers.iter()).flat_map(|own| [own.n_ports()]).collect();
    let mut owner_of_port = Vec::new();
    for (carrier, ports) in carriers.iter().enumerate() {
        let part =
            world.places.iter().position(|place| matches!(place, Place::Carrier(own, _) if *own == carrier));
        owner_of_port.extend(std::iter::repeat_n(part, *ports));
    }
    let moves = |part: usize| !world.is_still(part);
    let of_port = |port: usize| owner_of_port.get(port).copied().flatten();
    let shapes = world.places.iter().enumerate().filter_map(|(part, place)| match place {
        Place::Shape(port, ..) => Some([part, of_port(*port)?]),
        _ => None,
    });
    let attachments = world.fixed.attachments.iter().filter_map(|held| {
        let nodes = world
            .places
            .iter()
            .position(|place| matches!(place, Place::Nodes(own, ..) if own.contains(&held.node)));
        Some([nodes?, of_port(held.port)?])
    });
    let joints: Vec<[usize; 2]> = shapes.chain(attachments).collect();
    let own = joints.iter().filter(|[a, b]| moves(*a) && moves(*b)).copied();
    let groups = joined(world.places.len(), own);
    let mut component = vec![None; world.places.len()];
    let moving = groups.into_iter().filter(|group| group.iter().any(|part| moves(*part)));
    for (number, group) in moving.enumerate() {
        group.into_iter().for_each(|part| component[part] = Some(number));
    }
    component
}

/// Connected components of n items joined by pairs, each in ascending order, sorted by their first members.
fn joined(n: usize, pairs: impl Iterator<Item = [usize; 2]>) -> Vec<Vec<usize>> {
    let mut group: Vec<usize> = (0..n).collect();
    let find = |group: &[usize], mut one: usize| {
        while group[one] != one {
            one = group[one];
        }
        one
    };
    for [a, b] in pairs {
        let (a, b) = (find(&group, a), find(&group, b));
        group[a.max(b)] = a.min(b);
    }
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut number = vec![usize::MAX; n];
    for one in 0..n {
        let first = find(&group, one);
        if number[first] == usize::MAX {
            number[first] = groups.len();
            groups.push(Vec::new());
        }
        groups[number[first]].push(one);
    }
    groups
}
