//! `[view]` of a scene: which parts pictures leave out, and colours.

use crate::scene::fields::Fields;
use serde_json::Value;
use smartbed_codegen::model::colour::{self, COLOURS};

/// Parts that can be left out.
const PARTS: [&str; 5] = ["springs", "points", "surface", "ground", "forces"];
/// Parts whose colour can be chosen; by default springs and surface are coloured by their strain.
const COLOURED: [&str; 2] = ["springs", "surface"];

/// Options for pictures of a scene.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct View {
    /// Parts left out.
    pub hidden: Vec<&'static str>,
    /// Colours (red, green, blue) by part.
    pub colours: Vec<(&'static str, [u8; 3])>,
}

/// Reads `[view]`.
///
/// # Errors
/// An unknown part or colour.
pub(super) fn read(fields: &Fields) -> Result<View, String> {
    let mut view = View::default();
    let Some([hide, colours]) = fields.table("view", ["hide", "colours"])? else { return Ok(view) };
    let wrong = |message: String| fields.error("view", &message);
    if let Some(hide) = hide {
        let expected = || wrong(format!("`hide`: expected a list of {}, found {hide}", PARTS.join(", ")));
        for item in hide.as_array().ok_or_else(expected)? {
            let name = item.as_str().ok_or_else(expected)?;
            let part = PARTS.iter().find(|part| **part == name);
            let unknown =
                || wrong(format!("`hide`: unknown part `{name}`{}", crate::suggest::help(name, PARTS)));
            view.hidden.push(part.ok_or_else(unknown)?);
        }
    }
    if let Some(colours) = colours {
        let Some(colours) = colours.as_object() else {
            return Err(wrong(format!(
                "`colours`: expected a table such as {{ surface = \"sky\" }}, found {colours}"
            )));
        };
        for (name, value) in colours {
            let Some(part) = COLOURED.iter().find(|part| *part == name) else {
                let help = crate::suggest::help(name, COLOURED);
                return Err(wrong(format!("`colours`: unknown part `{name}`{help}")));
            };
            view.colours.push((part, rgb(value).ok_or_else(|| wrong(unknown_colour(value)))?));
        }
    }
    Ok(view)
}

fn rgb(value: &Value) -> Option<[u8; 3]> {
    colour::parse(value.as_str()?)
}

fn unknown_colour(value: &Value) -> String {
    let names = COLOURS.map(|(name, _)| name);
    format!("`colours`: {value} is no colour; expected {}, or \"#rrggbb\"", names.join(", "))
}

#[cfg(test)]
mod tests {
    use crate::scene::read::parse;

    const SCENE: &str = "format = 1\nshape = \"cube\"\nT = 0.1\n[view]\n";

    fn read(view: &str) -> Result<super::View, String> {
        parse("s.toml", &format!("{SCENE}{view}"), &[]).map(|scene| scene.view)
    }

    #[test]
    fn parts_and_colours_are_read_or_refused_with_their_place() {
        let view = read("hide = [\"points\"]\ncolours = { surface = \"sky\", springs = \"#010203\" }")
            .expect("a scene");
        assert_eq!(view.hidden, ["points"]);
        assert_eq!(view.colours, [("springs", [1, 2, 3]), ("surface", [86, 180, 233])]);
        for (text, words) in [
            ("hide = [\"point\"]", "unknown part `point`; did you mean `points`"),
            ("hide = \"points\"", "expected a list of springs"),
            ("colours = { ground = \"red\" }", "unknown part `ground`"),
            ("colours = { surface = \"red\" }", "\"red\" is no colour; expected black, orange"),
            ("colors = {}", "unknown key `colors`; did you mean `colours`"),
        ] {
            let error = read(text).expect_err(text);
            assert!(error.starts_with("s.toml:4: `view`: ") && error.contains(words), "{error}");
        }
    }
}
