//! Keys and values of a scene's text (TOML or JSON), and of settings on the command line, which override them; each
//! error names its file and line, or its setting.

use super::keys::ALIASES;
use crate::input::MOST_MARKS;
use crate::json::Unique;
use serde_json::{Map, Value};
use smartbed_codegen::model::marks;
use std::collections::{BTreeMap, BTreeSet};

/// Does a text have more values than its parser has memory for?
#[must_use]
pub fn is_too_much(text: &str) -> bool {
    marks(text) > MOST_MARKS
}

/// The keys and values of a scene, and their places in the text.
#[derive(Clone, Debug)]
pub struct Fields {
    path: String,
    text: String,
    map: Map<String, Value>,
    /// For keys that the text spells differently, or that come from a setting: how they are written there.
    written: BTreeMap<String, Written>,
}

#[derive(Clone, Debug)]
enum Written {
    /// In the text, by this name.
    Text(String),
    /// On the command line: the setting.
    Setting(String),
}

impl Fields {
    /// Parses TOML, or JSON if the path ends in `.json` (a table `geometry` is merged into the keys).
    ///
    /// # Errors
    /// The parser's message, with file and line.
    pub fn parse(path: &str, text: &str) -> Result<Fields, String> {
        if is_too_much(text) {
            let marks = marks(text);
            return Err(format!(
                "{path}: {marks} values, keys and lines; at most {MOST_MARKS} are taken: take a coarser body"
            ));
        }
        let mut map = if path.ends_with(".json") {
            let Unique(value) =
                serde_json::from_str(text).map_err(|e| format!("{path}:{}:{}: {e}", e.line(), e.column()))?;
            let Value::Object(map) = value else { return Err(format!("{path}: expected an object")) };
            map
        } else {
            let table: toml::Table = toml::from_str(text).map_err(|e: toml::de::Error| {
                let line = e.span().map_or(1, |s| text[..s.start.min(text.len())].lines().count().max(1));
                format!("{path}:{line}: {}", e.message())
            })?;
            table.into_iter().map(|(key, value)| (key, of_toml(value))).collect()
        };
        if let Some(Value::Object(geometry)) = map.remove("geometry") {
            for (key, value) in geometry {
                if map.insert(key.clone(), value).is_some() {
                    return Err(format!("{path}: `{key}`: given twice, inside `geometry` and beside it"));
                }
            }
        }
        let mut fields =
            Fields { path: path.to_string(), text: text.to_string(), map, written: BTreeMap::new() };
        for (alias, key) in ALIASES {
            if let Some(value) = fields.map.remove(alias) {
                if fields.map.contains_key(key) {
                    return Err(
                        fields.error(alias, &format!("means the same as `{key}`; leave one of them out"))
                    );
                }
                fields.map.insert(key.to_owned(), value);
                fields.written.insert(key.to_owned(), Written::Text(alias.to_owned()));
            }
        }
        Ok(fields)
    }

    /// Keys and values read from another text: messages are `KEY: what is wrong`, to which the caller adds the place.
    #[must_use]
    pub fn of_map(map: Map<String, Value>) -> Fields {
        Fields { path: String::new(), text: String::new(), map, written: BTreeMap::new() }
    }

    /// Sets a key: `name=value` as in `--set`, or an option of its own, `--name=value`. The value is TOML, JSON or a
    /// bare word. Returns the key.
    ///
    /// # Errors
    /// If the setting does not have this form.
    pub fn set(&mut self, setting: &str) -> Result<String, String> {
        let (words, assignment) = match setting.strip_prefix("--") {
            Some(option) => (setting.replacen('=', " ", 1), option),
            None => (format!("--set {setting}"), setting),
        };
        let parts = assignment.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
        let Some((name, value)) = parts.filter(|(name, _)| !name.is_empty()) else {
            return Err(format!("--set {setting}: expected NAME=VALUE, for example --set C=10"));
        };
        let key = ALIASES.iter().find(|(alias, _)| *alias == name).map_or(name, |(_, key)| key).to_owned();
        self.map.insert(key.clone(), value_of(value));
        self.written.insert(key.clone(), Written::Setting(words));
        Ok(key)
    }

    /// All keys.
    pub fn keys(&self) -> impl Iterator<Item = &String> {
        self.map.keys()
    }

    /// Removes a key.
    pub fn remove(&mut self, key: &str) {
        self.map.remove(key);
    }

    /// Is the text JSON?
    #[must_use]
    pub fn is_json(&self) -> bool {
        self.path.ends_with(".json")
    }

    /// An error message about a key.
    #[must_use]
    pub fn error(&self, key: &str, message: &str) -> String {
        let name = match self.written.get(key) {
            Some(Written::Setting(setting)) => return format!("{setting}: {message}"),
            Some(Written::Text(name)) => name,
            None if self.path.is_empty() => return format!("{key}: {message}"),
            None => key,
        };
        let starts = |line: &str| {
            let line = line.trim_start().trim_start_matches(['"', '[']);
            line.strip_prefix(name).is_some_and(|rest| {
                let rest = rest.trim_start_matches('"').trim_start();
                rest.starts_with(['=', ':', ']', '.'])
            })
        };
        match self.text.lines().position(starts) {
            Some(line) => format!("{}:{}: `{name}`: {message}", self.path, line + 1),
            None => format!("{}: `{name}`: {message}", self.path),
        }
    }

    /// The value of a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.map.get(key)
    }

    /// A number, or `default` if the key is missing.
    ///
    /// # Errors
    /// Not a finite number.
    pub fn number(&self, key: &str, default: f64) -> Result<f64, String> {
        match self.get(key) {
            None => Ok(default),
            Some(value) => {
                let help = || as_number(value).map_or(String::new(), |x| format!("; write {x:?}"));
                let message = || format!("expected a number, found {value}{}", help());
                finite(value).ok_or_else(|| self.error(key, &message()))
            }
        }
    }

    /// A number that is not negative.
    ///
    /// # Errors
    /// Negative, or not a number.
    pub fn not_negative(&self, key: &str, default: f64) -> Result<f64, String> {
        let x = self.number(key, default)?;
        if x >= 0.0 { Ok(x) } else { Err(self.error(key, &format!("expected a number >= 0, found {x}"))) }
    }

    /// A number above 0.
    ///
    /// # Errors
    /// 0, negative, or not a number.
    pub fn positive(&self, key: &str, default: f64) -> Result<f64, String> {
        let x = self.number(key, default)?;
        if x > 0.0 { Ok(x) } else { Err(self.error(key, &format!("expected a number > 0, found {x}"))) }
    }

    /// A count of at least `least`.
    ///
    /// # Errors
    /// Not a whole number, or too small.
    pub fn count(&self, key: &str, default: usize, least: usize) -> Result<usize, String> {
        let Some(value) = self.get(key) else { return Ok(default) };
        let count = value.as_u64().and_then(|n| usize::try_from(n).ok()).filter(|n| *n >= least);
        let whole = as_number(value).filter(|x| x.fract() == 0.0 && *x >= least as f64 && *x < 1e15);
        let help = || whole.map_or(String::new(), |x| format!("; write {x}"));
        let message = || format!("expected a whole number >= {least}, found {value}{}", help());
        count.ok_or_else(|| self.error(key, &message()))
    }

    /// A word, or `default`.
    ///
    /// # Errors
    /// Not a string.
    pub fn word<'a>(&'a self, key: &str, default: &'a str) -> Result<&'a str, String> {
        match self.get(key) {
            None => Ok(default),
            Some(value) => {
                value.as_str().ok_or_else(|| self.error(key, &format!("expected a word, found {value}")))
            }
        }
    }

    /// True or false.
    ///
    /// # Errors
    /// Neither.
    pub fn flag(&self, key: &str) -> Result<bool, String> {
        match self.get(key) {
            None => Ok(false),
            Some(v) => {
                v.as_bool().ok_or_else(|| self.error(key, &format!("expected true or false, found {v}")))
            }
        }
    }

    /// A table with no other entries than these, as pairs.
    ///
    /// # Errors
    /// Not a table, or another entry.
    pub fn table<const N: usize>(
        &self,
        key: &str,
        entries: [&str; N],
    ) -> Result<Option<[Option<&Value>; N]>, String> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let expected = format!("expected a table of {}", entries.join(" and "));
        let Some(table) = value.as_object() else {
            return Err(self.error(key, &format!("{expected}, found {value}")));
        };
        match table.keys().find(|k| !entries.contains(&k.as_str())) {
            Some(other) => {
                let help = crate::suggest::help(other, entries);
                Err(self.error(key, &format!("unknown key `{other}`{help}")))
            }
            None => Ok(Some(entries.map(|entry| table.get(entry)))),
        }
    }

    /// A vector, or a number for its z component.
    ///
    /// # Errors
    /// Neither.
    pub fn vector(&self, key: &str) -> Result<[f64; 3], String> {
        match self.get(key) {
            None => Ok([0.0; 3]),
            Some(value) => finite(value).map(|z| [0.0, 0.0, z]).or_else(|| row(value)).ok_or_else(|| {
                let expected = "expected a number (its z component) or three numbers";
                self.error(key, &format!("{expected}, found {value}"))
            }),
        }
    }

    /// `count` numbers: one for all, or a list of that length.
    ///
    /// # Errors
    /// Neither.
    pub fn numbers(&self, key: &str, default: f64, count: usize) -> Result<Vec<f64>, String> {
        let expected = || self.error(key, &format!("expected a number >= 0 or a list of {count} of them"));
        let list = match self.get(key) {
            Some(Value::Array(items)) => items.iter().map(finite).collect::<Option<Vec<f64>>>(),
            _ => Some(vec![self.number(key, default)?; count]),
        };
        let fits = |list: &Vec<f64>| list.len() == count && list.iter().all(|x| *x >= 0.0);
        list.filter(fits).ok_or_else(expected)
    }

    /// A list of rows of N numbers.
    ///
    /// # Errors
    /// Some row is not.
    pub fn rows<const N: usize>(&self, key: &str) -> Result<Option<Vec<[f64; N]>>, String> {
        self.list(key, &format!("expected a list of rows of {N} numbers"), row)
    }

    /// A list of rows of N whole numbers.
    ///
    /// # Errors
    /// Some row is not.
    pub fn whole_rows<const N: usize>(&self, key: &str) -> Result<Option<Vec<[usize; N]>>, String> {
        let row = |value: &Value| -> Option<[usize; N]> {
            let items: Option<Vec<usize>> = value.as_array()?.iter().map(whole).collect();
            items?.try_into().ok()
        };
        self.list(key, &format!("expected a list of rows of {N} whole numbers >= 0"), row)
    }

    /// A list of point numbers below `points`, each once.
    ///
    /// # Errors
    /// Not a list, or a point that does not exist.
    pub fn points(&self, key: &str, points: usize) -> Result<Option<Vec<usize>>, String> {
        let list = self.list(key, "expected a list of point numbers, for example [0, 2]", whole)?;
        let mut named = BTreeSet::new();
        for p in list.iter().flatten() {
            if *p >= points {
                return Err(
                    self.error(key, &format!("names point {p}, but the points are 0 to {}", points - 1))
                );
            }
            if !named.insert(*p) {
                return Err(self.error(key, &format!("names point {p} twice")));
            }
        }
        Ok(list)
    }

    /// A list whose items are all valid; the message names the first that is not.
    fn list<T>(
        &self,
        key: &str,
        expected: &str,
        read: impl Fn(&Value) -> Option<T>,
    ) -> Result<Option<Vec<T>>, String> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let items = value.as_array().ok_or_else(|| self.error(key, &format!("{expected}, found {value}")))?;
        let wrong = |(n, item): (usize, &Value)| self.error(key, &format!("{expected}; entry {n} is {item}"));
        let read = |(n, item)| read(item).ok_or_else(|| wrong((n, item)));
        items.iter().enumerate().map(read).collect::<Result<Vec<T>, String>>().map(Some)
    }
}

/// A finite number.
#[must_use]
pub fn finite(value: &Value) -> Option<f64> {
    value.as_f64().filter(|x| x.is_finite())
}

/// The number that a value stands for, as one in quotes does, or `.5`, which is none in TOML.
fn as_number(value: &Value) -> Option<f64> {
    finite(value).or_else(|| value.as_str()?.trim().parse().ok().filter(|x: &f64| x.is_finite()))
}

/// N finite numbers.
#[must_use]
pub fn row<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let items: Option<Vec<f64>> = value.as_array()?.iter().map(finite).collect();
    items?.try_into().ok()
}

fn whole(value: &Value) -> Option<usize> {
    value.as_u64().and_then(|n| usize::try_from(n).ok())
}

/// A value on the command line. Whatever is neither JSON nor TOML is a word; JSON's null counts as a word, too.
fn value_of(text: &str) -> Value {
    let json = serde_json::from_str(text).ok().filter(|value: &Value| !value.is_null());
    let toml =
        || toml::from_str::<toml::Table>(&format!("value = {text}")).ok()?.remove("value").map(of_toml);
    json.or_else(toml).unwrap_or_else(|| Value::String(text.to_owned()))
}

/// TOML has infinities, NaN and dates, JSON does not: they become strings, which no reader accepts as a number.
fn of_toml(value: toml::Value) -> Value {
    match value {
        toml::Value::String(text) => Value::String(text),
        toml::Value::Integer(n) => Value::from(n),
        toml::Value::Float(x) if x.is_finite() => Value::from(x),
        toml::Value::Float(x) => Value::String(x.to_string()),
        toml::Value::Boolean(b) => Value::Bool(b),
        toml::Value::Datetime(date) => Value::String(date.to_string()),
        toml::Value::Array(items) => Value::Array(items.into_iter().map(of_toml).collect()),
        toml::Value::Table(table) => Value::Object(table.into_iter().map(|(k, v)| (k, of_toml(v))).collect()),
    }
}
