//! A supervisor's CAN controller: one bus, several tiles, one talk with each.
//!
//! In: frames, which their identifiers assign to a tile's talk; bodies for tiles. Out: frames, of all tiles in turn,
//! and bodies with the tile that sent them. A stop has priority over everything else, and ends the messages under way
//! to the tiles that it stops, whoever sends it. Storage is the caller's: as many talks as tiles.

use super::bus::Arrival;
use super::can::{Controller, FRAMES, Port, STOP, is_data, names, stops};
use super::frame::Body;
use super::isotp::Data;
use super::talk::Talk;
use embedded_can::Frame;

/// A controller with the talks over it.
#[derive(Debug)]
pub struct Hub<'a, C> {
    port: Port<C>,
    talks: &'a mut [Talk],
    /// The talk whose turn is first.
    first: usize,
    /// Data of a stop to be sent.
    stop: Option<Data>,
}

impl<'a, C: Controller> Hub<'a, C> {
    /// This controller, and a talk with each tile.
    pub fn new(controller: C, talks: &'a mut [Talk]) -> Self {
        Self { port: Port::new(controller), talks, first: 0, stop: None }
    }

    /// Stops the tiles with these numbers (at most eight), or all tiles if the list is empty; it is sent before
    /// anything else, and messages under way to these tiles are not completed. The caller drops what it still holds for
    /// them: commands signed before the stop must not follow it. Returns false if there are more than eight.
    #[must_use]
    pub fn stop(&mut self, tiles: &[u8]) -> bool {
        let data = Data::from_slice(tiles).ok();
        let fits = data.is_some();
        if fits {
            let stopped = self.talks.iter_mut().filter(|talk| names(tiles, talk.tile()));
            stopped.for_each(Talk::break_off);
        }
        // Two pending stops become one for all tiles: never fewer than requested.
        self.stop = if self.stop.is_some() && fits { Some(Data::new()) } else { data.or(self.stop.take()) };
        fits
    }

    /// Hands over the bodies received by now (ms), with the index of the tile's talk, and the stops that somebody else
    /// has sent to a tile: the caller drops what it still holds for that.
    pub fn receive(&mut self, now: u32, mut take: impl FnMut(usize, Arrival)) {
        let Self { port, talks, .. } = self;
        port.receive(|frame| {
            for (place, talk) in talks.iter_mut().enumerate() {
                if is_data(frame, talk.receives()) {
                    if let Some(body) = talk.take(frame.data(), now) {
                        take(place, Arrival::Body(body));
                    }
                } else if stops(frame, talk.tile()) {
                    talk.break_off();
                    take(place, Arrival::Stop);
                }
            }
        });
    }

    /// Sends as much of what `collect` returns for each talk as is possible now (ms): one frame of each, in turns.
    pub fn transmit(&mut self, now: u32, mut collect: impl FnMut(usize) -> Option<Body>) {
        if !self.port.is_on(now) {
            self.talks.iter_mut().for_each(Talk::break_off);
            return;
        }
        if let Some(data) = self.stop.take()
            && !self.port.send(STOP, &data)
        {
            self.stop = Some(data);
            return;
        }
        let count = self.talks.len();
        let mut sent = 0;
        for place in (self.first..count).chain(0..self.first.min(count)) {
            let Some(talk) = self.talks.get_mut(place) else { return };
            match self.port.send_next(talk, now, || collect(place)) {
                Some(true) if sent + 1 < FRAMES => sent += 1,
                Some(is_sent) => {
                    // The next turn starts with the talk that found no room, else with the one after the last.
                    self.first = place + usize::from(is_sent);
                    return;
                }
                None => (),
            }
        }
    }

    /// Messages lost so far, and frames that the controller lost.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.talks.iter().fold(self.port.lost(), |sum, talk| sum.saturating_add(talk.lost()))
    }
}
