//! Says which moves a run cannot show, and which pressures are ordered anew too early, with their places.
//!
//! In: a plan with the place of each of its moves, its policy. Out: an error where equilibria would miss a move without
//! a word, a warning where one order of a pressure cuts another short, as the tiles' controller lets it.

use super::policy::Chosen;
use crate::number::six_digits;
use smartbed_bed::plan::moments::{overridden, unseen};
use smartbed_bed::plan::{Clock, Plan};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::source::Span;

/// Checks the moves of a plan, of which each stands at one of `places`, and those of its policy, which has a place too.
pub(super) fn check(plan: &Plan, places: &[Span], policy: Option<(&Chosen, Span)>, found: &mut Diagnostics) {
    for [earlier, later, tile] in overridden(plan) {
        let [end, at] =
            [plan.moves[earlier].at + plan.moves[earlier].over, plan.moves[later].at].map(six_digits);
        let what = format!(
            "the pressure of tile {} is ordered anew at {at} s, while an order for it lasts until {end} s",
            tile + 1
        );
        let warning = Diagnostic::warning(what).label(places[later], "it goes on from here");
        found
            .push(warning.help("the tiles' controller lets it; a later `at`, if the first is to be reached"));
    }
    // A motion has steps between its moments.
    if plan.clock != Clock::QuasiStatic {
        return;
    }
    let every = plan.every;
    let mut refuse = |tile: usize, from: f64, to: f64, span: Span| {
        let what = format!("a move of tile {} is taken back between two equilibria", tile + 1);
        let [from, to, length] = [from, to, to - from].map(six_digits);
        let place = format!("from {from} s to {to} s, equilibria stand every {every} s");
        let help = format!("run.every below {length} s, or a longer move");
        found.push(Diagnostic::error(what).label(span, place).help(help));
    };
    if let Some(own) = unseen(plan) {
        refuse(own.tile, own.from, own.to, places[own.index]);
    }
    let Some((chosen, span)) = policy else { return };
    let relief = chosen.relief();
    let alone = Plan { moves: chosen.scheduled(plan), ..plan.clone() };
    if let Some(own) = unseen(&alone) {
        refuse(own.tile, own.from, own.to, span);
    } else if relief.is_some_and(|relief| relief <= every) && every <= plan.seconds {
        let place = format!("let down, held and filled within {} s", relief.unwrap_or_default());
        let what = format!("the planner relieves a tile between two equilibria, which stand every {every} s");
        let help = "a shorter run.every, or a longer policy.hold or policy.ramp";
        found.push(Diagnostic::error(what).label(span, place).help(help));
    }
}
