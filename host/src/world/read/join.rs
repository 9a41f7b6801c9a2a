//! Reads the connections of parts: attachments of nodes to ports and bodies, shapes on ports.

use super::value::one_of;
use crate::world::assembly::{Attachment, Kind, Part, Rigid};
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{Table, Text, Value, wrong_kind};
use smartbed_codegen::source::Span;

/// The indices, `[0,0]`, of a part that is a copy of the repeated part of this name.
pub(super) fn copy_of<'p>(name: &str, part: &'p Part) -> Option<&'p str> {
    part.name.strip_prefix(name).filter(|rest| rest.starts_with('['))
}

/// Indices of the parts that a name refers to: the part itself, or all copies of its grid.
pub(super) fn parts_named(name: &str, parts: &[Part]) -> Vec<usize> {
    let is = |part: &Part| part.name == name || copy_of(name, part).is_some();
    parts.iter().enumerate().filter(|(_, part)| is(part)).map(|(n, _)| n).collect()
}

/// Reports the name of a part that does not exist.
pub(super) fn unknown_part(name: &str, span: Span, parts: &[Part], found: &mut Diagnostics) {
    let copy = parts.iter().find(|part| part.name.starts_with(&format!("{name}[")));
    let help = match copy {
        Some(copy) => format!(
            "`{name}` is repeated with another `grid`; leave that of this part out, or name one of the copies, such as `{}`",
            copy.name
        ),
        None => crate::suggest::help(name, parts.iter().map(|p| p.name.as_str())),
    };
    let error = Diagnostic::error(format!("there is no part `{name}`"));
    found.push(error.label(span, "unknown part").help(help.trim_start_matches("; ").to_owned()));
}

/// Reads `attach = [{ nodes = "rim", to = "tile.platform" }]` of part `number`; its nodes become fixed and lose their
/// mass.
pub(super) fn attach(
    items: &Value,
    number: usize,
    parts: &mut [Part],
    found: &mut Diagnostics,
) -> Vec<Attachment> {
    let Value::Array(items, _) = items else {
        found.push(
            wrong_kind("attach", "a list of tables", items)
                .help("attach = [{ nodes = \"rim\", to = \"tile.platform\" }]"),
        );
        return Vec::new();
    };
    // The rim is what the shape holds, not what an earlier entry attached.
    let held = match &parts[number].kind {
        Kind::Flexible(body) => body.lists.fixed.clone(),
        _ => Vec::new(),
    };
    let mut joined: Vec<Attachment> = Vec::new();
    for item in items {
        let Value::Table(table) = item else {
            found.push(wrong_kind("attach", "a list of tables", item));
            continue;
        };
        let fields = Fields::of("attach", table.span, table);
        let nodes = nodes(&fields, table, (&parts[number], &held), found);
        let target = fields.need("to", "\"tile.platform\"", found).and_then(|to| match to {
            Value::Text(text) => target(text, number, parts, found),
            other => {
                found.push(wrong_kind("to", "PART.PORT or a rigid PART in quotes", other));
                None
            }
        });
        fields.finish(found);
        let (Some(nodes), Some((to, port))) = (nodes, target) else { continue };
        if let Some(node) = named_twice(joined.iter().flat_map(|own| &own.nodes).chain(&nodes)) {
            let error =
                Diagnostic::error(format!("node {node} of `{}` is attached twice", parts[number].name));
            found.push(
                error.label(table.span, "here again").help("one frame holds a node: name each node once"),
            );
            continue;
        }
        if let Kind::Flexible(body) = &mut parts[number].kind {
            for node in &nodes {
                (body.lists.fixed[*node], body.lists.masses[*node]) = (true, 0.0);
            }
        }
        joined.push(Attachment { part: number, nodes, to, port });
    }
    joined
}

/// The first of some nodes that was there before.
fn named_twice<'n>(nodes: impl Iterator<Item = &'n usize>) -> Option<usize> {
    let mut seen = std::collections::HashSet::new();
    nodes.copied().find(|node| !seen.insert(*node))
}

/// Nodes by number, those of facets by number, or those of a group: `rim` (what the shape holds fixed), `base` (what
/// closes a sheet below).
fn nodes(
    fields: &Fields<'_>,
    table: &Table,
    (part, held): (&Part, &[bool]),
    found: &mut Diagnostics,
) -> Option<Vec<usize>> {
    let Kind::Flexible(body) = &part.kind else { return None };
    let (value, what, count) = match (fields.get("nodes"), fields.get("facets")) {
        (Some(value), None) => (value, "nodes", body.lists.points.len()),
        (None, Some(value)) => (value, "facets", body.lists.facets.len()),
        _ => {
            let error = Diagnostic::error("an attachment needs either `nodes` or `facets`");
            found.push(
                error
                    .label(table.span, "one of the two")
                    .help("nodes = \"rim\", nodes = [0, 3] or facets = \"base\""),
            );
            return None;
        }
    };
    let chosen: Vec<usize> = match value {
        Value::Text(group) => {
            let base = base_nodes(body);
            let nodes: Vec<usize> =
                match one_of(&group.text, group.span, ("group of nodes", &["rim", "base"]), found)? {
                    "base" => base,
                    // Both in rising order.
                    _ => (0..held.len()).filter(|n| held[*n] && base.binary_search(n).is_err()).collect(),
                };
            if nodes.is_empty() {
                let error = Diagnostic::error(format!("`{}` has no nodes `{}`", part.name, group.text));
                let help = "a sheet has a rim, and with base = \"40_mm\" a base; of other shapes name nodes by number: nodes = [0, 1]";
                found.push(error.label(group.span, "an empty group").help(help));
                return None;
            }
            nodes
        }
        Value::Array(items, _) => {
            let read = |item: &Value| match item {
                Value::Number(n, _) if n.fract() == 0.0 && *n >= 0.0 && *n < count as f64 => {
                    Some(*n as usize)
                }
                _ => None,
            };
            match items.iter().map(read).collect::<Option<Vec<usize>>>() {
                Some(numbers) if !numbers.is_empty() && what == "nodes" => numbers,
                Some(numbers) if !numbers.is_empty() => corners(&body.lists.facets, &numbers),
                numbers => {
                    let error = Diagnostic::error(format!("`{what}` must be numbers of {what}"));
                    let label = if numbers.is_some() { "there are none" } else { "one of them is none" };
                    let help = match count.checked_sub(1) {
                        Some(last) => format!("the {what} of `{}` are 0 to {last}", part.name),
                        None => format!("`{}` has no {what}", part.name),
                    };
                    found.push(error.label(value.span(), label).help(help));
                    return None;
                }
            }
        }
        other => {
            found.push(wrong_kind(what, "\"rim\", \"base\" or a list of numbers", other));
            return None;
        }
    };
    Some(chosen)
}

/// The nodes of some facets, in rising order.
fn corners(facets: &[[usize; 4]], numbers: &[usize]) -> Vec<usize> {
    numbers.iter().flat_map(|n| facets[*n]).collect::<std::collections::BTreeSet<_>>().into_iter().collect()
}

/// Nodes of facets without springs: those below a sheet.
fn base_nodes(body: &crate::world::assembly::Flexible) -> Vec<usize> {
    let mut below = vec![false; body.lists.points.len()];
    body.lists.facets.iter().flatten().for_each(|node| below[*node] = true);
    body.lists.springs.iter().flatten().for_each(|node| below[*node] = false);
    (0..below.len()).filter(|n| below[*n]).collect()
}

/// `tile.platform`: a part and its port; for a rigid part its name alone.
fn target(
    text: &Text,
    from: usize,
    parts: &[Part],
    found: &mut Diagnostics,
) -> Option<(usize, Option<String>)> {
    let (name, port) = match text.text.split_once('.') {
        Some((name, port)) => (name, Some(port)),
        None => (text.text.as_str(), None),
    };
    // A copy in a grid is attached to the copy with the same indices.
    let copy = parts[from].name.find('[').map_or("", |at| &parts[from].name[at..]);
    let beside = format!("{name}{copy}");
    let own =
        parts.iter().position(|p| p.name == beside).or_else(|| parts.iter().position(|p| p.name == name));
    let Some(number) = own else {
        unknown_part(name, text.span, parts, found);
        return None;
    };
    match (&parts[number].kind, port) {
        (Kind::Mechanism(mechanism), Some(port)) => {
            let ports = &mechanism.model.ports;
            if ports.iter().any(|p| p.name == port) {
                return Some((number, Some(port.to_owned())));
            }
            let error = Diagnostic::error(format!("the model of `{name}` has no port `{port}`"));
            let help = crate::suggest::help(port, ports.iter().map(|p| p.name.as_str()));
            let help =
                format!("declare it in the model: [ports] {port} = {{ frame = ..., point = ... }}{help}");
            found.push(error.label(text.span, "missing frame").help(help));
        }
        (Kind::Mechanism(mechanism), None) => {
            let known: Vec<&str> = mechanism.model.ports.iter().map(|p| p.name.as_str()).collect();
            let error = Diagnostic::error(format!("`{name}` is a mechanism: expected one of its ports"));
            found.push(
                error
                    .label(text.span, "a port is missing")
                    .help(format!("write {name}.PORT; its ports are: {}", known.join(", "))),
            );
        }
        (Kind::Rigid(Rigid { on: Some((carrier, port)), .. }), None) => {
            let port = format!("{}.{port}", parts[*carrier].name);
            let error =
                Diagnostic::error(format!("`{name}` is the shape of `{port}`: it has no frame of its own"));
            found.push(error.label(text.span, "expected that port").help(format!("write to = \"{port}\"")));
        }
        (Kind::Rigid(_), None) => return Some((number, None)),
        (Kind::Rigid(_), Some(_)) => {
            let error = Diagnostic::error(format!("`{name}` is a rigid body and has no ports"));
            found.push(error.label(text.span, "its own axes hold").help(format!("write to = \"{name}\"")));
        }
        (Kind::Flexible(_), _) => {
            let error =
                Diagnostic::error(format!("`{name}` is flexible: it has no frame that could hold nodes"));
            found.push(
                error
                    .label(text.span, "no frame")
                    .help("attach to a port of a mechanism, or to a rigid part"),
            );
        }
    }
    None
}

/// `on = "arm.tool"` of a rigid part: the port that carries it.
pub(super) fn on(text: &Value, number: usize, parts: &mut [Part], found: &mut Diagnostics) {
    let Value::Text(text) = text else {
        return found.push(wrong_kind("on", "PART.PORT in quotes", text));
    };
    match target(text, number, parts, found) {
        Some((part, Some(port))) => {
            if let Kind::Rigid(rigid) = &mut parts[number].kind {
                rigid.on = Some((part, port));
            }
        }
        Some((_, None)) => {
            let error = Diagnostic::error("`on` names a rigid part; expected a port of a mechanism");
            found.push(error.label(text.span, "this is a rigid part").help("write on = \"MECHANISM.PORT\""));
        }
        None => {}
    }
}
