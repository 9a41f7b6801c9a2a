//! Reduces register pressure by moving single steps of an order.
//!
//! In: an order of steps, each after those whose values it uses. Out: an order with less register overflow, if one is
//! found. A step is moved past its neighbours, one after the other, until it meets one that it depends on or that
//! depends on it; an exchange of two neighbours changes the number of live values at one place only. A move that is
//! worse by no more than a threshold is kept, and the threshold falls to zero (threshold accepting: Dueck & Scheuer
//! 1990). Deterministic: the same moves on every machine.

/// Number of live values that costs nothing: of 32 registers the compiler needs some for values inside a statement.
const ROOM: usize = 24;
/// Number of moves tried, per step.
const MOVES: usize = 200;
/// By how much a move may be worse at the beginning.
const THRESHOLD: usize = 4;
/// Stands for "no place".
const NEVER: usize = usize::MAX;

/// An order, with the lifetimes of its values.
struct Walk<'s> {
    makes: Vec<&'s [usize]>,
    reads: Vec<&'s [usize]>,
    order: Vec<usize>,
    /// By value: the places in the order where it is used first and last.
    first: Vec<usize>,
    last: Vec<usize>,
    /// By value: is it an argument, made by no step?
    is_argument: Vec<bool>,
    /// By place: number of values alive after it.
    waiting: Vec<usize>,
}

/// A better order than `order`, or the same one. `steps` gives for each step the values that it makes and those that it
/// uses; `values` is their number. Arguments are alive from their first use on; results are written out at once.
pub(super) fn refine(order: &[usize], steps: &[(&[usize], &[usize])], values: usize) -> Vec<usize> {
    let mut walk = Walk::new(order.to_vec(), steps, values);
    let n = order.len();
    if n < 2 || walk.waiting.iter().all(|&waiting| waiting <= ROOM) {
        return walk.order;
    }
    let mut random = 0x9E37_79B9_7F4A_7C15_u64;
    let mut below = |n: usize| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random % n as u64) as usize
    };
    let (mut gained, trials) = (0_isize, MOVES * n);
    for trial in 0..trials {
        let threshold = THRESHOLD * (trials - trial) / trials;
        let (from, is_forward, most) = (below(n), below(2) == 0, 1 << below(9));
        let (place, change) = walk.move_on(from, is_forward, most);
        if change > threshold.cast_signed() {
            walk.move_on(place, !is_forward, place.abs_diff(from));
        } else {
            gained -= change;
        }
    }
    if gained > 0 { walk.order } else { order.to_vec() }
}

impl<'s> Walk<'s> {
    fn new(order: Vec<usize>, steps: &[(&'s [usize], &'s [usize])], values: usize) -> Self {
        let (makes, reads) = steps.iter().copied().unzip();
        let mut walk = Self {
            makes,
            reads,
            first: vec![NEVER; values],
            last: vec![NEVER; values],
            is_argument: vec![true; values],
            waiting: vec![0; order.len()],
            order,
        };
        for (place, &step) in walk.order.iter().enumerate() {
            walk.makes[step].iter().for_each(|&value| walk.is_argument[value] = false);
            for &value in walk.reads[step] {
                walk.first[value] = walk.first[value].min(place);
                walk.last[value] = place;
            }
        }
        (0..walk.order.len()).for_each(|place| walk.waiting[place] = walk.waiting_behind(place));
        walk
    }

    /// Number of values alive after a place, from that before it.
    fn waiting_behind(&self, place: usize) -> usize {
        let step = self.order[place];
        let before = place.checked_sub(1).map_or(0, |before| self.waiting[before]);
        let made = self.makes[step].iter().filter(|&&value| self.last[value] != NEVER).count();
        let begun = |value: &&usize| self.is_argument[**value] && self.first[**value] == place;
        let begun = self.reads[step].iter().filter(begun).count();
        let done = self.reads[step].iter().filter(|&&value| self.last[value] == place).count();
        before + made + begun - done
    }

    /// Moves a step by at most `most` places; returns its new place and the change of the register overflow.
    fn move_on(&mut self, from: usize, is_forward: bool, most: usize) -> (usize, isize) {
        let (mut place, mut change) = (from, 0);
        for _ in 0..most {
            let earlier = if is_forward { Some(place) } else { place.checked_sub(1) };
            let Some(more) = earlier.and_then(|earlier| self.exchange(earlier)) else { break };
            change += more;
            place = if is_forward { place + 1 } else { place - 1 };
        }
        (place, change)
    }

    /// Exchanges the steps at a place and after it, unless the second depends on the first; returns the change of the
    /// overflow.
    fn exchange(&mut self, place: usize) -> Option<isize> {
        let (a, b) = (self.order[place], *self.order.get(place + 1)?);
        if self.makes[a].iter().any(|made| self.reads[b].contains(made)) {
            return None;
        }
        for &value in self.reads[a] {
            if self.first[value] == place && !self.reads[b].contains(&value) {
                self.first[value] = place + 1;
            }
            if self.last[value] == place {
                self.last[value] = place + 1;
            }
        }
        for &value in self.reads[b] {
            if self.first[value] == place + 1 {
                self.first[value] = place;
            }
            if self.last[value] == place + 1 && !self.reads[a].contains(&value) {
                self.last[value] = place;
            }
        }
        self.order.swap(place, place + 1);
        let overfull = |waiting: usize| waiting.saturating_sub(ROOM).cast_signed();
        let before = overfull(self.waiting[place]);
        self.waiting[place] = self.waiting_behind(place);
        Some(overfull(self.waiting[place]) - before)
    }
}

#[cfg(test)]
mod tests {
    use super::{ROOM, Walk, refine};

    /// Makes so many values, then reads them in pairs, in order of making.
    fn wide(n: usize) -> Vec<(Vec<usize>, Vec<usize>)> {
        let made = (0..n).map(|value| (vec![value], vec![]));
        made.chain((0..n / 2).map(|pair| (vec![n + pair], vec![2 * pair, 2 * pair + 1]))).collect()
    }

    #[test]
    fn values_are_made_when_they_are_needed_and_never_before_what_they_need() {
        let steps = wide(100);
        let borrowed: Vec<(&[usize], &[usize])> = steps.iter().map(|(m, r)| (&m[..], &r[..])).collect();
        let order: Vec<usize> = (0..steps.len()).collect();
        let better = refine(&order, &borrowed, 150);
        let mut places = vec![0; order.len()];
        better.iter().enumerate().for_each(|(place, &step)| places[step] = place);
        assert!((0..50).all(|pair| places[100 + pair] > places[2 * pair].max(places[2 * pair + 1])));
        let overfull = |order: Vec<usize>| -> usize {
            let walk = Walk::new(order, &borrowed, 150);
            walk.waiting.iter().map(|waiting| waiting.saturating_sub(ROOM)).sum()
        };
        assert_eq!(overfull(order.clone()), 2_926 + 1_406);
        assert!(overfull(better.clone()) < 100, "{better:?}");
        assert_eq!(better, refine(&order, &borrowed, 150));
    }

    #[test]
    fn what_exchanges_have_changed_is_what_a_new_count_finds() {
        let steps = wide(40);
        let borrowed: Vec<(&[usize], &[usize])> = steps.iter().map(|(m, r)| (&m[..], &r[..])).collect();
        let mut walk = Walk::new((0..steps.len()).collect(), &borrowed, 60);
        for from in 0..60 {
            walk.move_on((17 * from) % 60, from % 3 == 0, 1 + from % 7);
        }
        let anew = Walk::new(walk.order.clone(), &borrowed, 60);
        assert_eq!((&walk.first, &walk.last, &walk.waiting), (&anew.first, &anew.last, &anew.waiting));
    }
}
