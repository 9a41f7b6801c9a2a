//! Refuses rigid parts that overlap at the start, which no contact law could undo.

use crate::world::assembly::{Assembly, Law, Rigid};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::source::Span;
use smartbed_runtime::rigid::narrow::{Placed, features};
use smartbed_runtime::rigid::scene::Part;

/// An overlap below this share of the parts' size is attributed to rounding of the text's numbers.
const ROUNDING: f64 = 1e-9;

/// Checks every pair of which at least one part can move.
pub(super) fn check(assembly: &Assembly, span: impl Fn(&str) -> Option<Span>, found: &mut Diagnostics) {
    // The position of a shape on a port is not known before the mechanism is assembled.
    let rigid: Vec<(&str, &Rigid)> = assembly.rigid().filter(|(_, rigid)| rigid.on.is_none()).collect();
    for (n, (one_name, one)) in rigid.iter().enumerate() {
        for (other_name, other) in &rigid[n + 1..] {
            if one.body.is_none() && other.body.is_none() {
                continue;
            }
            let is_pair = |between: [usize; 2]| {
                let names = between.map(|part| assembly.parts[part].name.as_str());
                names == [*one_name, *other_name] || names == [*other_name, *one_name]
            };
            let law = assembly.contacts.iter().find(|contact| is_pair(contact.between)).map(|own| own.law);
            let depth = depth(one, other);
            // What pushes by the depth may begin there.
            if depth > ROUNDING && !matches!(law, Some(Law::Force(_))) {
                let place = span(one_name).unwrap_or_default();
                let error = Diagnostic::error(format!(
                    "`{one_name}` and `{other_name}` overlap by {depth:.3e} m at the start"
                ));
                let mut error = error.label(place, "starts inside the other");
                if let Some(other) = span(other_name).filter(|s| *s != place) {
                    error = error.label(other, "this one");
                }
                let apart = match !assembly.is_rigid() && law.is_some() {
                    true => "; or have them moved apart: start = \"settled\" under [run]",
                    false => "",
                };
                found.push(error.help(format!(
                    "move one of them: start = {{ position = [x, y, z] }} or start = {{ height = \"20_mm\" }}{apart}"
                )));
            }
        }
    }
}

/// Depth of the overlap (m); 0 if they are apart.
fn depth(one: &Rigid, other: &Rigid) -> f64 {
    let frame = |r: &Rigid| Part { shape: r.shape, body: r.body }.frame(&r.start);
    let (a, b) = (frame(one), frame(other));
    let near =
        features(Placed { shape: &one.shape, frame: &a }, Placed { shape: &other.shape, frame: &b }, 0.0);
    near.iter().map(|feature| -feature.gap).fold(0.0, f64::max)
}
