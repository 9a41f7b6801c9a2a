//! A world with contacts measured with laws of the other kind, too: touches located in time, or `moreau`.
//!
//! In: a subject and what was measured of it. Out: its points with the other kind's methods, whose names are others,
//! over the same time. Different laws move differently: the error of a point is against the finest of its own law, and
//! a note tells how far both are apart.

use super::measure::{self, Measured};
use super::plan::Plan;
use super::reference::{self, Truth};
use super::subject::{Exchanged, Subject};
use crate::world::Assembly;
use crate::world::assembly::{Kind, Law};
use smartbed_runtime::rigid::law::{self, Kind as Impact};

/// The assembly with contacts of the other kind, of the same e and friction, and what is exchanged; none where a law
/// has no counterpart, as force laws, and compensation beside flexible parts, to whose springs it gives the energy.
pub(super) fn laws(assembly: &Assembly) -> Option<(&'static str, Assembly)> {
    let mut other = assembly.clone();
    // Each kind has methods of its own.
    other.run.method = None;
    let mut words = None;
    for contact in &mut other.contacts {
        let is_flexible = |part: &usize| matches!(assembly.parts[*part].kind, Kind::Flexible(_));
        (contact.law, words) = match contact.law {
            Law::Force(_) => return None,
            Law::Located(own)
                if own.kind() == Impact::Compensation && contact.between.iter().any(is_flexible) =>
            {
                return None;
            }
            Law::Located(own) => {
                let (restitution, friction) = (own.restitution(), own.friction());
                (
                    Law::Moreau { restitution, friction },
                    Some("impact = \"moreau\" in place of laws that locate touches"),
                )
            }
            Law::Moreau { restitution, friction } => {
                let own = law::Law::stronge(restitution, friction).ok()?;
                (Law::Located(own), Some("impact = \"stronge\" in place of \"moreau\""))
            }
        };
    }
    words.map(|words| (words, other))
}

/// Adds the points of the other kind, over the same time, and a note about them.
pub(super) fn measure(subject: &dyn Subject, truth: &Truth, plan: &Plan, measured: &mut Measured) {
    let Some(Exchanged { words, subject: other }) = subject.exchanged() else { return };
    let made = other.and_then(|other| {
        let own = reference::make(other.as_ref(), truth.seconds, false, plan.reference)?;
        Ok((measure::measure(other.as_ref(), &own, plan), own))
    });
    let (found, own) = match made {
        Ok(found) => found,
        Err(why) => return measured.notes.push(format!("{words}: not measured: {why}")),
    };
    let mut methods: Vec<&str> = found.points.iter().map(|point| point.method.as_str()).collect();
    methods.dedup();
    if !methods.is_empty() {
        measured.notes.push(format!(
            "{}: with {words}, errors against {} (known to {:.1e}); the two references differ by up to {:.1e}",
            methods.join(", "),
            own.reference.text,
            own.reference.agreement,
            truth.trace.difference(&own.trace)
        ));
    }
    measured.points.extend(found.points);
    measured.notes.extend(found.notes);
}
