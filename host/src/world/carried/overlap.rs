//! Refuses a start at which parts overlap: a contact law would push them out with energy that no one has put in.
//!
//! In: a world at its start. Out: an error with both parts, the depth and the place. A start that is settled first is
//! not asked: the relaxation moves parts out of one another.

use super::{CarriedWorld, words};
use crate::failure::Failure;
use crate::world::assembly::Assembly;
use smartbed_codegen::diagnostic::Diagnostic;

impl CarriedWorld {
    /// Refuses the deepest overlap of two parts.
    pub(super) fn refuse_overlaps(&mut self, assembly: &Assembly) -> Result<(), Failure> {
        let Some(touching) = self.touching.take_if(|own| !own.pairs.is_empty()) else { return Ok(()) };
        let (t, x) = (self.t, self.x.clone());
        let found = self.with(|island| touching.overlaps(island, t, &x));
        self.touching = Some(touching);
        let deepest = found.map_err(words)?.into_iter().max_by(|a, b| a.depth.total_cmp(&b.depth));
        let Some(overlap) = deepest else { return Ok(()) };
        let [one, other] = overlap.parts.map(|part| self.names[part].as_str());
        let [x, y, z] = overlap.point;
        let places = &assembly.places;
        let error = Diagnostic::error(format!(
            "`{one}` and `{other}` overlap by {:.3e} m at the start, near ({x:.4}, {y:.4}, {z:.4}) m",
            overlap.depth
        ));
        let [first, second] = [one, other].map(|name| places.part(name, "start"));
        let mut error = error.label(first, "starts inside the other");
        if second != first {
            error = error.label(second, "this one");
        }
        Err(places.failure(error.help(
            "move one of them by its `start`, or write start = \"settled\" under [run] to have them moved apart",
        )))
    }
}
