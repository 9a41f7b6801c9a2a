//! Scene text of format 2 -> [`Assembly`]: settings, parts, joins, run; reports all errors with their places.
//!
//! `value` reads numbers with units, `settings` applies `--set`; `mechanism`, `flexible` and `rigid` read one kind of
//! part each, `join` attachments, `contact` contacts and `law` their laws, `view` the options of pictures; `names` checks that rows can tell
//! parts and pairs apart, `overlap` the initial positions of rigid parts; `repeated` gives each copy of a grid its
//! sensors and controllers.

mod command;
mod contact;
mod controller;
mod flexible;
mod join;
mod law;
mod mechanism;
mod names;
mod overlap;
mod repeated;
mod rigid;
mod sensor;
pub mod settings;
pub(crate) mod value;
mod view;

pub use mechanism::Find;

use super::assembly::{Assembly, GRAVITY, Kind, Part, Run};
use super::places::Places;
use super::places::whole;
use crate::scene::fields::is_too_much;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::{self, Key, Table, Value, wrong_kind};
use smartbed_codegen::source::{Source, Span};
use std::path::{Path, PathBuf};
use value::{Bound, count, number, vector};

/// Most copies of a part.
const MOST_COPIES: usize = 10_000;
/// Most nodes of all flexible parts; one takes about two kilobytes of memory.
const MOST_NODES: usize = 200_000;
/// Most steps of a run.
const MOST_STEPS: f64 = 1e9;

/// Reads a scene; `settings` are those of `--set`; `find` locates the file of a model that is not beside the scene.
///
/// # Errors
/// All errors in it.
pub fn parse(path: &str, text: &str, settings: &[String], find: Find<'_>) -> Result<Assembly, Diagnostics> {
    parse_for(path, text, settings, find, false)
}

/// Reads a scene that is settled first, whatever its `[run]` says: parts may overlap.
///
/// # Errors
/// All errors in it.
pub fn parse_to_settle(
    path: &str,
    text: &str,
    settings: &[String],
    find: Find<'_>,
) -> Result<Assembly, Diagnostics> {
    let assembly = parse_for(path, text, settings, find, true)?;
    Ok(Assembly { run: Run { settled: true, ..assembly.run }, ..assembly })
}

fn parse_for(
    path: &str,
    text: &str,
    settings: &[String],
    find: Find<'_>,
    to_settle: bool,
) -> Result<Assembly, Diagnostics> {
    let source = Source::new(path, text);
    let mut found = Diagnostics::new(source.clone());
    if is_too_much(text) {
        let error = Diagnostic::error("the scene has more values than there is memory for");
        found.push(
            error.label(Span::default(), "").help("repeat parts by `grid`, take shapes in place of lists"),
        );
        return Err(found);
    }
    let table = match document::parse(text, 0) {
        Ok(table) => table,
        Err(items) => return Err(Diagnostics { source, items }),
    };
    let table = settings::apply(table, settings, &mut found);
    let find = |name: &str| model_beside(Path::new(path), name).map_or_else(|| find(name), Ok);
    let Some((mut assembly, contacts)) = read(path, &table, &find, to_settle, &mut found) else {
        return Err(found);
    };
    assembly.places = Places::new(found.source.clone(), table, contacts);
    found.finish(assembly)
}

/// The file of a model in the scene's own folder, if it exists.
fn model_beside(scene: &Path, name: &str) -> Option<PathBuf> {
    let folder = scene.parent()?;
    let files = [name.to_owned(), format!("{name}.toml")].map(|file| folder.join(file));
    files.into_iter().find(|file| file.is_file() && file != scene)
}

/// The assembly, and by contact the place of its `between`.
fn read(
    path: &str,
    table: &Table,
    find: Find<'_>,
    to_settle: bool,
    found: &mut Diagnostics,
) -> Option<(Assembly, Vec<Span>)> {
    let scene = Fields::of("scene", table.span, table);
    match scene.get("format") {
        Some(Value::Number(2.0, _)) => {}
        Some(other) => found.push(wrong_kind("format", "2, for it has `parts`", other)),
        None => found.push(
            Diagnostic::error("the scene has no `format`").label(table.span, "").help("add format = 2"),
        ),
    }
    let title = scene.text("title", found).map_or_else(|| path.to_owned(), |text| text.text.clone());
    let gravity = vector(&scene, "gravity", "m/s^2", found).unwrap_or(GRAVITY);
    let named = scene.table("parts", found);
    let (parts, mut attached) = parts(named.map_or(&[][..], |t| &t.entries), find, found);
    let mut parts = parts?;
    let mut attachments = Vec::new();
    // Shapes on ports first: nothing is attached to them.
    attached.sort_by_key(|(number, _)| !matches!(parts[*number].kind, Kind::Rigid(_)));
    for (number, value) in attached {
        match parts[number].kind {
            Kind::Rigid(_) => join::on(&value, number, &mut parts, found),
            _ => attachments.extend(join::attach(&value, number, &mut parts, found)),
        }
    }
    let (mut contacts, mut pairs, mut laws) = (Vec::new(), Vec::new(), Vec::new());
    for item in scene.array("contacts", found).map_or(&[][..], |(items, _)| items) {
        match item {
            Value::Table(table) => {
                contacts.extend(contact::contact(table, &parts, &contacts, found));
                let place = |key: &str| table.get(key).map_or(table.span, Value::span);
                pairs.resize(contacts.len(), place("between"));
                laws.resize(
                    contacts.len(),
                    place(if table.get("force").is_some() { "force" } else { "impact" }),
                );
            }
            other => found.push(wrong_kind("contacts", "tables, each under [[contacts]]", other)),
        }
    }
    law::refuse_mixed(&contacts, &laws, found);
    let observed = scene.table("sensors", found).map_or(&[][..], |table| &table.entries);
    let sensors = observed.iter().filter_map(|(key, value)| sensor::read(key, value, found)).collect();
    let sensors = repeated::sensors(sensors, &parts);
    let controlled = scene.table("controllers", found).map_or(&[][..], |table| &table.entries);
    let controllers =
        controlled.iter().filter_map(|(key, value)| controller::read(key, value, &parts, found)).collect();
    let controllers = repeated::controllers(controllers, &sensors, &parts);
    let run = run(&scene, found);
    let view = scene.table("view", found).map(|table| view::read(table, &parts, found)).unwrap_or_default();
    scene.finish(found);
    let (run, places) = (run?, Places::default());
    let assembly =
        Assembly { title, gravity, parts, attachments, contacts, sensors, controllers, run, view, places };
    let spans = |name: &str| {
        named.and_then(|t| t.entries.iter().find(|(key, _)| key.name == whole(name))).map(|(key, _)| key.span)
    };
    names::check(&assembly, spans, found);
    // Rest is searched for by a step that moves parts apart; rigid parts alone have none.
    if assembly.is_rigid() || !(to_settle || assembly.run.settled) {
        overlap::check(&assembly, spans, found);
    }
    if assembly.run.settled
        && let Some(part) = assembly.parts.iter().find(|part| part.starts_in_motion())
    {
        let (what, help) = match part.kind {
            Kind::Mechanism(_) => (
                "speeds of a start have",
                "leave them out, or give 0 where the model's own [start] has them: start = { NAME = 0 }",
            ),
            _ => ("`velocity` and `spin` have", "leave its `velocity` and `spin` out"),
        };
        let error = Diagnostic::error(format!("{what} no effect with start = \"settled\""));
        let place = spans(&part.name).unwrap_or_default();
        let help = format!("{help}; or begin where the scene says: start = \"given\" under [run]");
        found.push(error.label(place, "it starts in motion").help(help));
    }
    Some((assembly, pairs))
}

/// The value of `attach` for each part that has one.
type Attached = Vec<(usize, Value)>;

fn parts(entries: &[(Key, Value)], find: Find<'_>, found: &mut Diagnostics) -> (Option<Vec<Part>>, Attached) {
    let (mut parts, mut attached, mut whole, mut nodes) = (Vec::new(), Vec::new(), true, 0);
    for (key, value) in entries {
        let Value::Table(table) = value else {
            found.push(wrong_kind(&key.name, "a table of its own: [parts.NAME]", value));
            whole = false;
            continue;
        };
        if key.name.is_empty() || key.name.contains(['[', '.', ' ']) {
            let error = Diagnostic::error("a part's name is one word");
            found.push(error.label(key.span, "this is none").help("letters, digits, _ and -"));
        }
        if key.name == "sensors" {
            let error = Diagnostic::error("no part is called `sensors`");
            let error = error.label(key.span, "columns `sensors.NAME` are the readings of sensors");
            found.push(error.help("another name"));
        }
        let places = copies(key, grid(table, entries, entries.len()), found);
        for (suffix, offset) in places {
            match part(key, table, offset, find, found) {
                Some(kind) => {
                    nodes += if let Kind::Flexible(body) = &kind { body.lists.points.len() } else { 0 };
                    if nodes > MOST_NODES {
                        let error = Diagnostic::error(format!(
                            "the flexible parts have more than {MOST_NODES} nodes"
                        ));
                        found.push(
                            error
                                .label(key.span, "with this one")
                                .help("take coarser bodies, or fewer copies"),
                        );
                        return (None, attached);
                    }
                    if let Some(value) = table.get("attach").or(table.get("on")) {
                        attached.push((parts.len(), value.clone()));
                    }
                    parts.push(Part { name: format!("{}{suffix}", key.name), kind });
                }
                None => {
                    whole = false;
                    break;
                }
            }
        }
    }
    if entries.is_empty() {
        let error = Diagnostic::error("the scene has no parts");
        found.push(error.label(Span::default(), "").help("add [parts.NAME] with rigid, shape or mechanism"));
        whole = false;
    }
    (whole.then_some(parts), attached)
}

/// The `grid` of a part: its own, or that of a part which it is attached to, or which that one is attached to.
fn grid<'t>(table: &'t Table, entries: &'t [(Key, Value)], links: usize) -> Option<&'t Value> {
    if let Some(own) = table.get("grid") {
        return Some(own);
    }
    let links = links.checked_sub(1)?;
    let targets: Vec<&Value> = match (table.get("attach"), table.get("on")) {
        (Some(Value::Array(items, _)), _) => {
            let to = |item: &'t Value| if let Value::Table(item) = item { item.get("to") } else { None };
            items.iter().filter_map(to).collect()
        }
        (None, Some(on)) => vec![on],
        _ => return None,
    };
    targets.into_iter().find_map(|target| {
        let Value::Text(target) = target else { return None };
        let name = target.text.split('.').next()?;
        let (_, carrier) = entries.iter().find(|(key, _)| key.name == name)?;
        let Value::Table(carrier) = carrier else { return None };
        grid(carrier, entries, links)
    })
}

/// Copies of a part by `grid = { count = [7, 4], pitch = ["0.4_m", "0.4_m"] }`: the name and displacement of each.
fn copies(key: &Key, grid: Option<&Value>, found: &mut Diagnostics) -> Vec<(String, [f64; 3])> {
    let single = vec![(String::new(), [0.0; 3])];
    let grid = match grid {
        None => return single,
        Some(Value::Table(grid)) => grid,
        Some(other) => {
            let error = wrong_kind("grid", "a table", other);
            found.push(error.help("grid = { count = [7, 4], pitch = [\"0.4_m\", \"0.4_m\"] }"));
            return single;
        }
    };
    let fields = Fields::of("grid", grid.span, grid);
    let count = fields.need("count", "[7, 4]", found).and_then(|v| value::list::<2>(v, "count", "", found));
    let pitch = fields
        .need("pitch", "[\"0.4_m\", \"0.4_m\"]", found)
        .and_then(|v| value::list::<2>(v, "pitch", "m", found));
    fields.finish(found);
    let (Some(count), Some(pitch)) = (count, pitch) else { return single };
    if count.iter().any(|n| *n < 1.0 || n.fract() != 0.0) || count[0] * count[1] > MOST_COPIES as f64 {
        let error =
            Diagnostic::error(format!("`{}` is repeated {} x {} times", key.name, count[0], count[1]));
        found.push(
            error
                .label(grid.span, format!("whole numbers >= 1, {MOST_COPIES} copies at most"))
                .help("correct `count`"),
        );
        return single;
    }
    let (rows, columns) = (count[0] as usize, count[1] as usize);
    let copy = |n: usize| {
        let (i, j) = (n / columns, n % columns);
        (format!("[{i},{j}]"), [i as f64 * pitch[0], j as f64 * pitch[1], 0.0])
    };
    (0..rows * columns).map(copy).collect()
}

/// Reads one part, by the key that states its kind.
fn part(key: &Key, table: &Table, offset: [f64; 3], find: Find<'_>, found: &mut Diagnostics) -> Option<Kind> {
    // The position of an attached part follows from its attachment: its copies are not displaced.
    let offset = if table.get("attach").or(table.get("on")).is_some() { [0.0; 3] } else { offset };
    let fields = Fields::of(&key.name, key.span, table);
    let kinds = ["mechanism", "shape", "points", "rigid"].map(|kind| table.get(kind).is_some());
    match kinds {
        [true, false, false, false] => {
            let read = mechanism::read(&fields, offset, find, found);
            let _ = fields.get("grid");
            if read.is_some() {
                fields.finish(found);
            }
            read.map(|m| Kind::Mechanism(Box::new(m)))
        }
        [false, false, false, true] => {
            let read = rigid::read(&fields, offset, found);
            let _ = fields.get("grid");
            if read.is_some() {
                fields.finish(found);
            }
            read.map(Kind::Rigid)
        }
        [false, true, false, false] | [false, false, true, false] => {
            flexible::read((&key.name, key.span), table, offset, found).map(|f| Kind::Flexible(Box::new(f)))
        }
        _ => {
            let error =
                Diagnostic::error(format!("the kind of part `{}` is not given, or given twice", key.name));
            let help = "give it one of: mechanism = \"tile\", shape = \"sheet\" (flexible; or points), rigid = \"sphere\"";
            found.push(error.label(key.span, "exactly one key must say what it is").help(help));
            None
        }
    }
}

fn run(scene: &Fields<'_>, found: &mut Diagnostics) -> Option<Run> {
    let mut run = Run { seconds: 1.0, step: 1e-3, every: 1, method: None, settled: false, sleep: None };
    let Some(table) = scene.table("run", found) else { return Some(run) };
    let fields = Fields::of("run", table.span, table);
    run.seconds = number(&fields, "seconds", "s", Bound::NotNegative, found).unwrap_or(run.seconds);
    run.step = number(&fields, "step", "s", Bound::Positive, found).unwrap_or(run.step);
    run.every = count(&fields, "every", 1, found).unwrap_or(run.every);
    if let Some(start) = fields.text("start", found) {
        run.settled = value::one_of(&start.text, start.span, ("start", &["given", "settled"]), found)
            == Some("settled");
    }
    run.method = fields.text("method", found).map(|text| text.text.clone());
    run.sleep = number(&fields, "sleep", "m/s", Bound::Positive, found);
    fields.finish(found);
    if run.seconds / run.step > MOST_STEPS {
        let error = Diagnostic::error(format!(
            "{} s in steps of {} s are more than {MOST_STEPS:e} steps",
            run.seconds, run.step
        ));
        found.push(error.label(table.span, "this run").help("take a larger step"));
        return None;
    }
    Some(run)
}
