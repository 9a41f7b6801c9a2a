//! Detects whether the tile's clock runs as fast as the supervisor's.
//!
//! In: the supervisor's clock in its beats, and the tile's time. Out: whether they agree.
//! Both clocks are compared over windows of two seconds or more. A beat may be some milliseconds late, so the
//! smallest deviation that is detected with certainty is 1.5 %.

/// Shortest window that is judged (ms).
const WINDOW: u32 = 2000;
/// A longer window is restarted (ms), because beats were missing.
const LONGEST: u32 = 10_000;
/// Largest difference between the delays of a window's first and last beat (ms).
const DELAY: u32 = 10;

/// Comparison of two clocks.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Clock {
    /// Supervisor's and tile's time at the start of the window.
    start: Option<(u32, u32)>,
}

impl Clock {
    /// Takes a beat; returns false if the clocks have drifted apart.
    pub fn take(&mut self, theirs: u32, ours: u32) -> bool {
        let Some((their_start, our_start)) = self.start else {
            self.start = Some((theirs, ours));
            return true;
        };
        let (their_way, our_way) = (theirs.wrapping_sub(their_start), ours.wrapping_sub(our_start));
        if our_way > LONGEST {
            self.start = Some((theirs, ours));
            return true;
        }
        let apart = their_way.abs_diff(our_way);
        let is_right = apart <= DELAY + our_way / 100;
        if our_way >= 2 * WINDOW || (our_way >= WINDOW && !is_right) {
            self.start = Some((theirs, ours));
        }
        our_way < WINDOW || is_right
    }

    /// Restarts the comparison after a silence: the next beat is the first.
    pub fn forget(&mut self) {
        self.start = None;
    }
}

#[cfg(test)]
mod tests {
    use super::Clock;

    /// Ten minutes of beats every 200 ms, each up to 5 ms late, with the supervisor's clock this much faster: when is
    /// it found?
    fn found(rate: f64) -> Option<u32> {
        let mut clock = Clock::default();
        (0..3000_u32).map(|n| n * 200).find(|sent| {
            let late = sent.wrapping_mul(2_654_435_761) >> 29;
            !clock.take((f64::from(*sent) * rate) as u32 + 7, sent + late.min(5))
        })
    }

    #[test]
    fn two_per_cent_are_found_and_half_a_per_cent_is_not() {
        for rate in [1.02, 0.98] {
            assert!(found(rate).is_some_and(|at| at <= 4000), "{rate}: {:?}", found(rate));
        }
        for rate in [1.0, 1.005, 0.995] {
            assert_eq!(found(rate), None, "{rate}");
        }
    }

    #[test]
    fn silence_begins_anew() {
        let mut clock = Clock::default();
        assert!(clock.take(0, 0) && clock.take(1_000_000, 20_000), "a pause is no drift");
        clock.forget();
        assert!(clock.take(5, 23_000) && clock.take(2505, 25_500));
    }
}
