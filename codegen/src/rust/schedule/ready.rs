//! The steps that may come next while an order is made, the one that lets the fewest values live first.
//!
//! In: ranks, and the growth of each step (the change in the number of live values). Out: one step after the other, by
//! growth and then by rank. A growth is one of a few numbers, so each has a set of ranks as bits.

/// Most values that a step makes, and most that it uses.
pub(super) const MOST_VALUES: usize = 4;

/// The steps that may come next, ordered by growth (the change in the number of live values) and rank.
pub(super) struct Ready<'r> {
    ranks: &'r [usize],
    /// By rank: its step.
    steps: Vec<usize>,
    growth: Vec<Option<isize>>,
    /// By growth, the least first: the ranks of its steps.
    queues: [Ranks; GROWTHS],
    /// Steps whose growth must be recomputed: it has changed, or they have become ready.
    pub(super) refresh: Vec<usize>,
}

/// A step lets at most all that it uses die, and at most all that it makes and uses come to life.
const GROWTHS: usize = 3 * MOST_VALUES + 1;

impl<'r> Ready<'r> {
    pub(super) fn new(ranks: &'r [usize]) -> Self {
        let mut steps = vec![0; ranks.len() + 1];
        ranks.iter().enumerate().for_each(|(step, &rank)| steps[rank] = step);
        let queues = std::array::from_fn(|_| Ranks::default());
        Self { ranks, steps, growth: vec![None; ranks.len()], queues, refresh: Vec::new() }
    }

    fn queue(&mut self, growth: isize) -> &mut Ranks {
        &mut self.queues[(growth + MOST_VALUES.cast_signed()).cast_unsigned()]
    }

    /// Records that the growth of those of the steps that are ready has changed.
    pub(super) fn touch(&mut self, steps: &[usize]) {
        self.refresh.extend(steps.iter().filter(|&&step| self.growth[step].is_some()));
    }

    pub(super) fn set(&mut self, step: usize, growth: isize) {
        let (old, rank) = (self.growth[step].replace(growth), self.ranks[step]);
        if old != Some(growth) {
            self.queue(growth).insert(rank);
            old.into_iter().for_each(|old| self.queue(old).remove(rank));
        }
    }

    pub(super) fn update(&mut self, growth: impl Fn(usize) -> isize) {
        let mut refresh = std::mem::take(&mut self.refresh);
        for step in refresh.drain(..) {
            self.set(step, growth(step));
        }
        self.refresh = refresh;
    }

    pub(super) fn pop(&mut self) -> Option<usize> {
        let step = self.steps[self.queues.iter_mut().find_map(Ranks::pop)?];
        self.growth[step] = None;
        Some(step)
    }
}

/// A set of ranks as bits: there are few, and the least is asked for.
#[derive(Default)]
struct Ranks {
    words: Vec<u64>,
    /// Words before this one are 0.
    first: usize,
}

impl Ranks {
    fn insert(&mut self, rank: usize) {
        let word = rank / 64;
        if self.words.len() <= word {
            self.words.resize(word + 1, 0);
        }
        self.words[word] |= 1 << (rank % 64);
        self.first = self.first.min(word);
    }

    fn remove(&mut self, rank: usize) {
        self.words[rank / 64] &= !(1 << (rank % 64));
    }

    fn pop(&mut self) -> Option<usize> {
        while *self.words.get(self.first)? == 0 {
            self.first += 1;
        }
        let word = &mut self.words[self.first];
        let bit = word.trailing_zeros() as usize;
        *word &= *word - 1;
        Some(64 * self.first + bit)
    }
}
