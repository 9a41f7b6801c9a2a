//! Contacts among some of a world's parts, for stepping these separately.
//!
//! In: the contacts of the whole, parts, a map of indices. Out: the contacts of these parts alone; after a step the
//! whole is told the contact forces.

use super::{Located, Pairs, Touching};
use crate::world::pushed::Pushed;
use smartbed_runtime::world::{Pair, Thing};

impl Touching {
    /// The pairs among these parts and with parts fixed in space, with things renumbered by `moved`; also which pairs
    /// of the whole they are.
    pub(in crate::world) fn among(
        &self,
        parts: &[usize],
        moved: impl Fn(&Thing<f64>) -> Thing<f64>,
        size: [usize; 4],
    ) -> (Self, Vec<usize>) {
        let belongs = |pair: usize, side: usize| parts.contains(&self.parts[pair][side]);
        let is_own = |pair: usize| {
            let own = [0, 1].map(|side| belongs(pair, side) || !self.moves[pair][side]);
            own == [true; 2] && (belongs(pair, 0) || belongs(pair, 1))
        };
        let own: Vec<usize> = (0..self.pairs.len()).filter(|pair| is_own(*pair)).collect();
        let mut numbers: Vec<usize> = own.iter().flat_map(|pair| self.pairs[*pair].things).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let number = |thing: usize| numbers.iter().position(|own| *own == thing);
        let pairs = own.iter().map(|pair| {
            let of = &self.pairs[*pair];
            Pair { things: of.things.map(|thing| number(thing).unwrap_or(0)), ..*of }
        });
        let located = self.located.as_ref();
        let laws = |of: &Located<f64>| (own.iter().map(|pair| of.kinds[*pair]).collect(), of.method);
        let mut subset = Self::with(
            (
                numbers.iter().map(|thing| moved(&self.things[*thing])).collect(),
                self.of_parts.iter().map(|thing| thing.and_then(number)).collect(),
            ),
            Pairs {
                pairs: pairs.collect(),
                parts: own.iter().map(|pair| self.parts[*pair]).collect(),
                moves: own.iter().map(|pair| self.moves[*pair]).collect(),
            },
            located.map(laws),
            size,
        );
        for (number, pair) in own.iter().enumerate() {
            subset.pushed.take(number, &self.pushed, *pair);
        }
        subset.active = own.iter().map(|pair| self.active[*pair]).collect();
        if let (Some(to), Some(of)) = (&mut subset.located, located) {
            to.overlaps = own.iter().map(|pair| of.overlaps[*pair]).collect();
        }
        (subset, own)
    }

    /// Forgets what pushed in the last step, before parts of it are heard.
    pub(in crate::world) fn fall_silent(&mut self) {
        self.forces.clear();
        self.pushed = Pushed::new(self.pairs.len());
        if let Some(located) = &mut self.located {
            located.pressed = false;
        }
    }

    /// Adds the contact forces that a step of some pairs, with these indices here, has found.
    pub(in crate::world) fn hear(&mut self, of: &Touching, pairs: &[usize]) {
        self.forces.extend(of.forces.iter().cloned());
        for (own, pair) in pairs.iter().enumerate() {
            self.pushed.take(*pair, &of.pushed, own);
            self.active[*pair] = of.active[own];
            if let (Some(to), Some(of)) = (&mut self.located, &of.located) {
                to.overlaps[*pair] = of.overlaps[own];
            }
        }
    }

    /// The thing that a part is.
    pub(in crate::world) fn thing_of(&self, part: usize) -> Option<Thing<f64>> {
        self.of_parts[part].map(|thing| self.things[thing])
    }
}
