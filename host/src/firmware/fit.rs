//! Fits a world to the chip: its sheets get the finest meshes for which RAM suffices.
//!
//! In: a scene of format 2, the settings of the command line, the RAM that an image takes besides the world. Out:
//! tables of the finest world that fits. Sheets whose `rows` or `columns` the command line sets, those of which the
//! scene names nodes or springs by number, and all other parts, are left as they are.

use crate::failure::Failure;
use crate::world::assembly::{Assembly, Contact, Kind, Law};
use crate::world::carried::CarriedWorld;
use crate::world::carried::tables::Demand;
use crate::world::engine::Engine as _;
use crate::{input, model_argument, output};
use smartbed_codegen::model::document::{self, Table, Value};
use std::path::Path;

/// RAM for a world, stack and static data (bytes): the rest of the chip's RAM is the controller's.
pub const RAM: usize = 96 * 1024;
/// RAM that an image takes besides the world, as long as none has been built (bytes).
const BESIDE: usize = 4 * 1024;

/// A world fitted to the chip.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fitted {
    /// Constant tables and equations in Rust.
    pub tables: String,
    /// Steps of the scene.
    pub steps: u32,
    /// Step (ns).
    pub step: u64,
    /// The memory that it needs.
    pub demand: Demand,
    /// Rows and columns of its sheets, if they were chosen here.
    pub rows: Option<usize>,
}

impl Fitted {
    /// The finest world that fits, for so many steps if they are given.
    ///
    /// # Errors
    /// [`Failure::Wrong`] for a wrong scene, and for one that the chip cannot step.
    pub fn new(path: &Path, set: &[String], asked: Option<u32>) -> Result<Self, Failure> {
        Self::with_room_for(path, set, asked, BESIDE)
    }

    /// The finest world that fits if an image takes this many bytes besides it.
    fn with_room_for(path: &Path, set: &[String], asked: Option<u32>, bytes: usize) -> Result<Self, Failure> {
        let wrong = |why: String| Failure::Wrong(format!("{}: {why}", path.display()));
        // An error with a place names the file itself.
        let named = |failure| if let Failure::Wrong(why) = failure { wrong(why) } else { failure };
        let sheets: Vec<String> = sheets(path)?.into_iter().filter(|name| !is_set(set, name)).collect();
        let read = |rows: Option<usize>| {
            let mut set = set.to_vec();
            for (name, rows) in rows.iter().flat_map(|rows| sheets.iter().map(move |name| (name, rows))) {
                set.extend(["rows", "columns"].map(|key| format!("parts.{name}.{key}={rows}")));
            }
            let mut assembly = model_argument::open_world(path, &set)?;
            // The default method for an undamped world takes too much memory on the chip.
            let lasting = |contact: &Contact| matches!(contact.law, Law::Moreau { .. });
            if assembly.run.method.is_none() && assembly.contacts.iter().any(lasting) {
                assembly.run.method = Some("moreau".to_owned());
            }
            Ok::<_, Failure>(assembly)
        };
        let mut rows = None;
        let written = read(None)?;
        // A mesh is chosen only without contacts, whose number would depend on it.
        if !sheets.is_empty() && written.contacts.is_empty() {
            // The memory of the carriers does not depend on the mesh: only that of the nodes is computed again.
            let plain = CarriedWorld::new(&written).map_err(named)?.demand(0).without(nodes(&written));
            for finer in 1.. {
                if plain.with(nodes(&read(Some(finer))?)).bytes() + bytes > RAM {
                    break;
                }
                rows = Some(finer);
            }
            if rows.is_none() {
                let why =
                    format!("not even sheets of one node fit into {} KB of RAM; leave parts out", RAM / 1024);
                return Err(wrong(why));
            }
        }
        let assembly = if rows.is_some() { read(rows)? } else { written };
        let mut world = CarriedWorld::new(&assembly).map_err(named)?;
        world.for_chip(&assembly).map_err(wrong)?;
        if assembly.run.settled
            && let Some(note) = world.settle().map_err(wrong)?.note()
        {
            output::say(&note);
        }
        if !assembly.sensors.is_empty() {
            output::say("note: the image has no sensors: they do not affect the motion");
        }
        let (all, whole) = (assembly.run.steps(), |n: usize| assembly.run.length(n) == assembly.run.step);
        let steps = if all > 0 && !whole(all) { all - 1 } else { all };
        let steps = asked.map_or(steps, |asked| asked as usize);
        let room = world.contact_room(steps).map_err(wrong)?;
        let demand = world.demand(room);
        if demand.bytes() + bytes > RAM {
            return Err(wrong(format!(
                "with room for {room} contacts it takes {} KB of RAM, {} are there; give its sheets fewer rows and columns",
                (demand.bytes() + bytes).div_ceil(1024),
                RAM / 1024
            )));
        }
        Ok(Self {
            tables: world.tables(&assembly, room).map_err(wrong)?,
            steps: u32::try_from(steps).unwrap_or(u32::MAX),
            step: nanoseconds(assembly.run.step),
            demand,
            rows,
        })
    }

    /// Fits the world again after its image has been measured; `None` if that gives no other mesh. `taken` is the
    /// image's RAM, stack and static data.
    ///
    /// # Errors
    /// As [`Fitted::new`].
    pub fn again(&self, path: &Path, set: &[String], taken: usize) -> Result<Option<Self>, Failure> {
        let beside = taken.saturating_sub(self.demand.bytes());
        let better = Self::with_room_for(path, set, Some(self.steps), beside)?;
        Ok((self.rows.is_some() && better.rows != self.rows).then_some(better))
    }
}

/// A time (s) in ns.
#[must_use]
pub fn nanoseconds(seconds: f64) -> u64 {
    (seconds * 1e9).round() as u64
}

/// Number of nodes of a world: all, and the free ones.
fn nodes(assembly: &Assembly) -> [usize; 2] {
    let bodies = assembly.parts.iter().filter_map(|part| match &part.kind {
        Kind::Flexible(body) => Some(&body.lists.fixed),
        _ => None,
    });
    bodies.fold([0, 0], |[all, free], fixed| {
        [all + fixed.len(), free + fixed.iter().filter(|fixed| !**fixed).count()]
    })
}

/// Names of the scene's sheets of any mesh: numbers of nodes and springs belong to the mesh as written.
fn sheets(path: &Path) -> Result<Vec<String>, Failure> {
    let text = input::text(&path.display().to_string())?;
    // Errors in the text are reported when it is read as a scene.
    let Ok(table) = document::parse(&text, 0) else { return Ok(Vec::new()) };
    let Some(Value::Table(parts)) = table.get("parts") else { return Ok(Vec::new()) };
    let is_sheet = |part: &Table| {
        matches!(part.get("shape"), Some(Value::Text(shape)) if shape.text == "sheet") && !has_numbers(part)
    };
    let sheets =
        parts.entries.iter().filter(|(_, value)| matches!(value, Value::Table(part) if is_sheet(part)));
    Ok(sheets.map(|(key, _)| key.name.clone()).collect())
}

/// Does a part name nodes by number, or give each node or spring a value of its own?
fn has_numbers(part: &Table) -> bool {
    let is_list = |value: Option<&Value>| matches!(value, Some(Value::Array(..)));
    let attached = match part.get("attach") {
        Some(Value::Array(items, _)) => items.as_slice(),
        _ => &[],
    };
    let by_number = |item: &Value| match item {
        Value::Table(table) => is_list(table.get("nodes")) || is_list(table.get("facets")),
        _ => false,
    };
    ["fixed", "mass", "masses", "K", "C", "rest_lengths"].iter().any(|key| is_list(part.get(key)))
        || attached.iter().any(by_number)
}

/// Does the command line set the mesh of this sheet?
fn is_set(set: &[String], name: &str) -> bool {
    let keys = ["rows", "columns"].map(|key| format!("parts.{name}.{key}"));
    set.iter()
        .any(|change| change.split('=').next().is_some_and(|path| keys.iter().any(|key| key == path.trim())))
}

#[cfg(test)]
mod tests {
    use super::sheets;

    #[test]
    fn sheets_with_numbers_of_nodes_keep_their_mesh() {
        let file = std::env::temp_dir().join(format!("smartbed_fit_{}.toml", std::process::id()));
        let of = |more: &str| {
            let text = format!("format = 2\n[parts.net]\nshape = \"sheet\"\n{more}\n");
            std::fs::write(&file, text).expect("written");
            sheets(&file).expect("read")
        };
        assert_eq!(of("mass = \"5_g\"\nattach = [{ nodes = \"rim\", to = \"a.b\" }]"), ["net"]);
        for more in ["fixed = [4]", "mass = [1, 2]", "attach = [{ nodes = [4], to = \"ball\" }]"] {
            assert_eq!(of(more), [] as [&str; 0], "{more}");
        }
        std::fs::remove_file(&file).expect("removed");
    }
}
