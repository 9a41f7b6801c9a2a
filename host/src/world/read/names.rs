//! Checks that parts, pairs and attachments have different names, by which rows and accounts tell them apart.

use crate::world::assembly::Assembly;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::source::Span;
use std::collections::HashMap;

/// Reports the first two of one name: a part `ball-ground` beside the pair of `ball` and `ground`.
pub(super) fn check(assembly: &Assembly, spans: impl Fn(&str) -> Option<Span>, found: &mut Diagnostics) {
    let name = |part: usize| assembly.parts[part].name.as_str();
    let parts = assembly.parts.iter().map(|part| {
        let own = part.name.as_str();
        (own.to_owned(), format!("part `{own}`"), own)
    });
    let pairs = assembly.contacts.iter().map(|contact| {
        let [one, other] = contact.between.map(name);
        (format!("{one}-{other}"), format!("the pair of `{one}` and `{other}`"), one)
    });
    let attachments = assembly.attachments.iter().map(|held| {
        let to = [Some(name(held.to)), held.port.as_deref()].into_iter().flatten().collect::<Vec<_>>();
        let (own, to) = (name(held.part), to.join("."));
        (format!("{own}@{to}"), format!("the attachment of `{own}` to `{to}`"), own)
    });
    let mut seen: HashMap<String, String> = HashMap::new();
    for (name, what, part) in parts.chain(pairs).chain(attachments) {
        // Several attachments of one part to one frame are one seam.
        if let Some(first) = seen.get(&name).filter(|first| **first != what) {
            let error =
                Diagnostic::error(format!("{first} and {what} have one name in rows and accounts, `{name}`"));
            let place = spans(part).unwrap_or_default();
            return found.push(error.label(place, "named here").help("give one of these parts another name"));
        }
        seen.insert(name, what);
    }
}
