//! Chooses one definition per class so that the program is cheap: local search with reference counts.
//!
//! A class that nothing uses costs nothing. Switching a class to another definition frees what only the old one used
//! and adds what only the new one uses; the switch is made if it frees more. Switches that change nothing are made now
//! and then, by a deterministic sequence, to leave local minima; the best state found is kept.

use super::field::mix;
use super::graph::{ClassId, Definition, Graph, Signed};
use crate::id::Id;

/// Two of five switches that change nothing are made.
const IDLE_MOVES: (u64, u64) = (2, 5);
/// Such a switch may increase the round-off bound by at most this factor.
const IDLE_ERROR: f64 = 1.1;
/// Position of a class that is not in the order of evaluation.
const NOWHERE: u64 = u64::MAX;
/// Distance between neighbours after sorting: leaves room for classes that come into use in between.
const SPACING: u64 = 1 << 32;

/// State of the search.
pub(super) struct Extraction<'g> {
    pub graph: &'g mut Graph,
    roots: Vec<ClassId>,
    /// By class: number of definitions in use, and roots, that use it.
    uses: Vec<u32>,
    /// By class: position in an order of evaluation, greater than those of its operands.
    position: Vec<u64>,
    /// By class in use: weight of the longest chain of operations that ends in it.
    depth: Vec<u32>,
    /// By class: whether its definition may not change any more.
    locked: Vec<bool>,
    seen: Vec<u32>,
    round: u32,
    stack: Vec<ClassId>,
    /// The same for [`Extraction::place`] and [`Extraction::reaches`].
    path: Vec<ClassId>,
    /// Classes whose use count a trial has raised.
    tried: Vec<ClassId>,
    random: u64,
    cost: u32,
    /// The classes in use, as last sorted.
    order: Vec<ClassId>,
    /// Classes that were given positions since then.
    placed: Vec<ClassId>,
    /// Has a definition changed since then?
    changed: bool,
    /// If a class in use must move in the order, sort everything and recompute all depths? Otherwise that class alone
    /// moves.
    pub keeps_depths: bool,
}

impl<'g> Extraction<'g> {
    /// Starts from the current definitions.
    pub fn new(graph: &'g mut Graph, roots: &[Signed], locked: &[ClassId]) -> Self {
        let n = graph.classes.len();
        let mut search = Self {
            graph,
            roots: roots.iter().map(|r| r.class).collect(),
            uses: vec![0; n],
            position: vec![NOWHERE; n],
            depth: vec![0; n],
            locked: vec![false; n],
            seen: vec![0; n],
            round: 0,
            stack: Vec::new(),
            path: Vec::new(),
            tried: Vec::new(),
            random: 0x5EED,
            cost: 0,
            order: Vec::new(),
            placed: Vec::new(),
            changed: true,
            keeps_depths: true,
        };
        for class in locked {
            search.locked[class.index()] = true;
        }
        for root in search.roots.clone() {
            search.cost += search.add_use(root);
        }
        search.sort();
        search
    }

    /// Makes room for classes that were added to the graph; nothing uses them yet.
    pub fn grow(&mut self) {
        let n = self.graph.classes.len();
        self.uses.resize(n, 0);
        self.position.resize(n, NOWHERE);
        self.depth.resize(n, 0);
        self.locked.resize(n, false);
        self.seen.resize(n, 0);
    }

    /// Classes in use, operands first.
    pub fn live(&mut self) -> Vec<ClassId> {
        self.sort();
        self.order.clone()
    }

    /// Makes `passes` sweeps over all classes; the graph is left with the cheapest definitions found.
    pub fn run(&mut self, passes: usize) {
        // No other class ever changes its definition.
        let has_choice = |class: &ClassId| self.graph.classes[*class].definition(1).is_some();
        let choices: Vec<ClassId> = self.graph.classes.ids().filter(has_choice).collect();
        let mut best = (self.cost, self.definitions(&choices));
        for pass in 0..passes {
            let last = pass + 1 == passes;
            let mut order = self.live();
            match pass {
                0 | 2 => {}
                _ if pass % 2 == 1 => order.reverse(),
                _ => self.shuffle(&mut order),
            }
            for class in order {
                self.improve(class, !last);
            }
            if self.cost < best.0 {
                best = (self.cost, self.definitions(&choices));
            }
        }
        for (class, definition) in choices.into_iter().zip(best.1) {
            self.changed |= self.graph.classes[class].current != definition;
            self.graph.classes[class].current = definition;
        }
    }

    fn definitions(&self, classes: &[ClassId]) -> Vec<Definition> {
        classes.iter().map(|&class| self.graph.classes[class].current).collect()
    }

    fn draw(&mut self) -> u64 {
        self.random = self.random.wrapping_add(1);
        mix(self.random)
    }

    fn shuffle(&mut self, order: &mut [ClassId]) {
        for k in (1..order.len()).rev() {
            let other = (self.draw() % (k as u64 + 1)) as usize;
            order.swap(k, other);
        }
    }

    /// Adds a use of a class; returns the cost of everything that comes into use by it.
    fn add_use(&mut self, class: ClassId) -> u32 {
        let mut weight = 0;
        self.stack.push(class);
        while let Some(class) = self.stack.pop() {
            self.uses[class.index()] += 1;
            if self.uses[class.index()] == 1 {
                let definition = &self.graph.classes[class].current;
                weight += definition.cost();
                self.stack.extend(definition.reads());
            }
        }
        weight
    }

    /// Removes a use of a class; returns the cost of everything that goes out of use.
    fn drop_use(&mut self, class: ClassId) -> u32 {
        let mut weight = 0;
        self.stack.push(class);
        while let Some(class) = self.stack.pop() {
            self.uses[class.index()] -= 1;
            if self.uses[class.index()] == 0 {
                let definition = &self.graph.classes[class].current;
                weight += definition.cost();
                self.stack.extend(definition.reads());
            }
        }
        weight
    }

    /// Cost of a definition and of everything it would bring into use; `None` if that exceeds `most`.
    fn weight_of(&mut self, definition: &Definition, most: u32) -> Option<u32> {
        let mut weight = definition.cost();
        self.stack.extend(definition.reads());
        while weight <= most
            && let Some(class) = self.stack.pop()
        {
            self.uses[class.index()] += 1;
            self.tried.push(class);
            if self.uses[class.index()] == 1 {
                let definition = &self.graph.classes[class].current;
                weight += definition.cost();
                self.stack.extend(definition.reads());
            }
        }
        self.stack.clear();
        for class in self.tried.drain(..) {
            self.uses[class.index()] -= 1;
        }
        (weight <= most).then_some(weight)
    }

    /// Switches a class in use to a cheaper definition, or now and then to one of equal cost.
    fn improve(&mut self, class: ClassId, idle_moves: bool) {
        let has_choice = self.graph.classes[class].definition(1).is_some();
        if self.uses[class.index()] == 0 || self.locked[class.index()] || !has_choice {
            return;
        }
        let old = self.graph.classes[class].current;
        let freed: u32 = old.cost() + old.reads().map(|c| self.drop_use(c)).sum::<u32>();
        let mut best: Option<(i64, Definition)> = None;
        for k in 0.. {
            let Some(new) = self.graph.classes[class].definition(k) else { break };
            if new == old {
                continue;
            }
            // Most definitions cost more; only the others are worth the search for a cycle.
            let most = best.map_or(freed, |(gain, _)| freed - gain as u32);
            let Some(added) = self.weight_of(&new, most) else { continue };
            let gain = i64::from(freed) - i64::from(added);
            let better = match best {
                None => true,
                Some((most, other)) if gain == most => {
                    let (mine, others) = (self.depth_of(&new), self.depth_of(&other));
                    let even = mine == others && new.error <= other.error;
                    mine < others || (even && self.draw() & 1 == 0)
                }
                Some((most, _)) => gain > most,
            };
            if better && !self.reaches(&new, class) {
                best = Some((gain, new));
            }
        }
        let taken = best.filter(|&(gain, ref new)| {
            let idle = if idle_moves {
                new.error <= IDLE_ERROR && self.draw() % IDLE_MOVES.1 < IDLE_MOVES.0
            } else {
                self.depth_of(new) < self.depth_of(&old)
            };
            gain > 0 || (gain == 0 && idle)
        });
        let (gain, definition) = taken.unwrap_or((0, old));
        definition.reads().for_each(|c| {
            self.add_use(c);
        });
        self.cost = (i64::from(self.cost) - gain) as u32;
        if taken.is_some() {
            self.graph.classes[class].current = definition;
            self.changed = true;
            if !self.place(class) {
                self.sort();
            }
        }
    }

    /// Gives positions to classes that came into use with the definition of `class`, and new ones to its operands that
    /// stand after it; false if the whole order must be sorted instead.
    fn place(&mut self, class: ClassId) -> bool {
        let limit = self.position[class.index()];
        self.path.clear();
        self.path.extend(self.graph.classes[class].current.reads());
        while let Some(&c) = self.path.last() {
            let i = c.index();
            if self.position[i] < limit {
                self.path.pop();
                continue;
            }
            if self.position[i] != NOWHERE && self.keeps_depths {
                return false;
            }
            let definition = self.graph.classes[c].current;
            let waiting = self.path.len();
            self.path.extend(definition.reads().filter(|r| self.position[r.index()] >= limit));
            if self.path.len() > waiting {
                continue;
            }
            let below = definition.reads().map(|r| self.position[r.index()]).max().unwrap_or(0);
            if below + 1 >= limit {
                return false;
            }
            if self.position[i] == NOWHERE {
                self.placed.push(c);
            }
            self.position[i] = below + (limit - below) / 2;
            self.depth[i] = self.depth_of(&definition);
        }
        true
    }

    /// Weight of the longest chain of operations that ends in a definition.
    fn depth_of(&self, definition: &Definition) -> u32 {
        let below = definition.reads().map(|c| self.depth[c.index()]).max().unwrap_or(0);
        below + definition.operation.weight()
    }

    /// Would `definition` make `class` depend on itself, through the current definitions?
    fn reaches(&mut self, definition: &Definition, class: ClassId) -> bool {
        self.round += 1;
        let place = self.position[class.index()];
        self.path.clear();
        self.path.extend(definition.reads());
        while let Some(c) = self.path.pop() {
            if c == class {
                return true;
            }
            let i = c.index();
            // A class earlier in the order of evaluation cannot depend on this one.
            if self.seen[i] != self.round && (self.position[i] == NOWHERE || self.position[i] > place) {
                self.path.extend(self.graph.classes[c].current.reads());
            }
            self.seen[i] = self.round;
        }
        false
    }

    /// Sorts the classes in use, operands first, and computes their depths.
    fn sort(&mut self) {
        if !self.changed {
            return;
        }
        self.changed = false;
        self.round += 1;
        for class in self.order.drain(..).chain(self.placed.drain(..)) {
            self.position[class.index()] = NOWHERE;
        }
        let mut stack: Vec<(ClassId, bool)> = self.roots.iter().rev().map(|&c| (c, false)).collect();
        while let Some((class, operands_done)) = stack.pop() {
            let i = class.index();
            let definition = &self.graph.classes[class].current;
            if operands_done {
                self.depth[i] = self.depth_of(definition);
                self.order.push(class);
                self.position[i] = self.order.len() as u64 * SPACING;
            } else if self.seen[i] != self.round {
                self.seen[i] = self.round;
                stack.push((class, true));
                for read in definition.reads() {
                    if self.seen[read.index()] != self.round {
                        stack.push((read, false));
                    }
                }
            }
        }
    }
}
