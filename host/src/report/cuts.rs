//! Smooth parts of a motion: it is cut where commands, laws and loads switch, as a run cuts it.
//!
//! In: a mechanism's switches. Out: for a span of time, the parts of it between them. A method that steps over a switch
//! has order 1 there, and one that chooses its own step may not see a short pulse at all.

use crate::switches::Switches;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;

/// Times (s) just before and behind each switch, in order.
#[derive(Debug)]
pub(super) struct Cuts(Vec<[f64; 2]>);

impl Cuts {
    /// Those of the first `seconds`, looked for in parts of that length (s).
    ///
    /// # Errors
    /// The engine's.
    pub(super) fn of<S: Scalar>(switches: &mut Switches<S>, seconds: f64, part: f64) -> Result<Self, Fault> {
        let (mut found, mut t) = (Vec::new(), 0.0);
        while let Some(kink) = switches.next(t, seconds, part)? {
            // A switch just behind the end is none of the motion's; one must end behind the one before it.
            if kink[1] <= t {
                break;
            }
            found.push(kink);
            t = kink[1];
        }
        Ok(Self(found))
    }

    /// The smooth parts of `from..to`, each with its start and its end.
    pub(super) fn parts(&self, from: f64, to: f64) -> impl Iterator<Item = [f64; 2]> {
        let first = self.0.partition_point(|kink| kink[1] <= from);
        let inside = self.0[first..].iter().take_while(move |kink| kink[0] < to);
        let starts = std::iter::once(from).chain(inside.clone().map(|kink| kink[1]));
        let ends = inside.map(|kink| kink[0]).chain(std::iter::once(to));
        starts.zip(ends).map(|(start, end)| [start, end]).filter(|[start, end]| start < end)
    }
}

#[cfg(test)]
mod tests {
    use super::Cuts;

    #[test]
    fn a_span_is_cut_at_switches() {
        let cuts = Cuts(vec![[0.9, 1.1], [2.0, 2.1]]);
        let parts = |from, to| cuts.parts(from, to).collect::<Vec<_>>();
        assert_eq!(parts(0.0, 0.5), [[0.0, 0.5]]);
        assert_eq!(parts(0.0, 3.0), [[0.0, 0.9], [1.1, 2.0], [2.1, 3.0]]);
        // A span that ends or begins at a switch.
        assert_eq!(parts(0.0, 1.0), [[0.0, 0.9]]);
        assert_eq!(parts(1.0, 1.5), [[1.1, 1.5]]);
        assert_eq!(parts(1.1, 2.0), [[1.1, 2.0]]);
        assert_eq!(parts(2.0, 2.05), [] as [[f64; 2]; 0]);
    }
}
