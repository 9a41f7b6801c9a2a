//! The tile's log: the last events, numbered, with the tick of each.
//!
//! In: events. Out: entries by number. New entries replace the oldest; numbers are never reused before a restart, so a
//! supervisor that reads in time gets all entries, and notices those that it has missed. Permanent storage is its task.

use super::message::Event;
use heapless::Deque;

/// Most entries kept.
pub const ENTRIES: usize = 64;

/// The log.
#[derive(Clone, Debug, Default)]
pub struct Log {
    entries: Deque<(u32, Event), ENTRIES>,
    /// Number of the next entry.
    next: u32,
}

impl Log {
    /// Adds an event at this tick.
    pub fn add(&mut self, tick: u32, event: Event) {
        if self.entries.is_full() {
            self.entries.pop_front();
        }
        // There is room now.
        let _ = self.entries.push_back((tick, event));
        self.next = self.next.wrapping_add(1);
    }

    /// Number of entries so far.
    #[must_use]
    pub fn next(&self) -> u32 {
        self.next
    }

    /// The entry with this number, or the oldest one kept after it: number, tick and event.
    #[must_use]
    pub fn from(&self, number: u32) -> Option<(u32, u32, Event)> {
        let oldest = self.next.wrapping_sub(self.entries.len() as u32);
        let place = number.saturating_sub(oldest) as usize;
        let (tick, event) = self.entries.iter().nth(place)?;
        Some((oldest.wrapping_add(place as u32), *tick, *event))
    }
}

#[cfg(test)]
mod tests {
    use super::{ENTRIES, Log};
    use crate::link::message::Event;

    #[test]
    fn the_oldest_make_room_and_numbers_go_on() {
        let mut log = Log::default();
        assert_eq!(log.from(0), None);
        (0..100).for_each(|n| log.add(10 * n, Event::Faults(n)));
        let oldest = 100 - ENTRIES as u32;
        assert_eq!(log.from(0), Some((oldest, 10 * oldest, Event::Faults(oldest))));
        assert_eq!(log.from(99), Some((99, 990, Event::Faults(99))));
        assert_eq!((log.from(100), log.next()), (None, 100));
    }
}
