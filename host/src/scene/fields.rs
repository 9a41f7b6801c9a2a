//! Keys and values of a scene text (TOML or JSON), each error with file and line.

use serde_json::{Map, Value};

/// A scene text taken apart, with what is needed to say where something stands.
#[derive(Clone, Debug)]
pub struct Fields {
    path: String,
    text: String,
    map: Map<String, Value>,
}

impl Fields {
    /// Parses TOML, or JSON where the path ends in `.json` (then `geometry` is opened and foreign keys are let be).
    ///
    /// # Errors
    /// What the parser says, with file and line.
    pub fn parse(path: &str, text: &str) -> Result<Fields, String> {
        let mut map: Map<String, Value> = if path.ends_with(".json") {
            serde_json::from_str(text).map_err(|e| format!("{path}:{}:{}: {e}", e.line(), e.column()))?
        } else {
            toml::from_str(text).map_err(|e: toml::de::Error| {
                let line = e.span().map_or(1, |s| text[..s.start.min(text.len())].lines().count().max(1));
                format!("{path}:{line}: {}", e.message())
            })?
        };
        if let Some(Value::Object(geometry)) = map.remove("geometry") {
            map.extend(geometry);
        }
        Ok(Fields { path: path.to_string(), text: text.to_string(), map })
    }

    /// Sets a key as `--set name=value` does.
    ///
    /// # Errors
    /// Not of the form name=value.
    pub fn set(&mut self, assignment: &str) -> Result<(), String> {
        let Some((name, value)) = assignment.split_once('=') else {
            return Err(format!("--set {assignment}: expected name=value, for example --set C=10"));
        };
        let value = serde_json::from_str(value).unwrap_or_else(|_| Value::String(value.to_string()));
        self.map.insert(name.trim().to_string(), value);
        Ok(())
    }

    /// Refuses keys outside `known`.
    ///
    /// # Errors
    /// The first unknown key.
    pub fn refuse_unknown(&self, known: &str) -> Result<(), String> {
        match self.map.keys().find(|k| !known.split_whitespace().any(|w| w == k.as_str())) {
            Some(key) => Err(self.error(key, &format!("unknown key; a scene knows {}", known))),
            None => Ok(()),
        }
    }

    /// Refuses `--set` of a name outside `known`.
    ///
    /// # Errors
    /// The name.
    pub fn refuse_unknown_name(&self, assignment: &str, known: &str) -> Result<(), String> {
        let name = assignment.split('=').next().unwrap_or_default().trim();
        if known.split_whitespace().any(|w| w == name) {
            return Ok(());
        }
        Err(format!("--set {name}: unknown name; a scene knows {}", known))
    }

    /// An error message about a key.
    #[must_use]
    pub fn error(&self, key: &str, message: &str) -> String {
        let starts = |line: &str| {
            let line = line.trim_start().trim_start_matches('"');
            line.strip_prefix(key).is_some_and(|rest| {
                let rest = rest.trim_start_matches('"').trim_start();
                rest.starts_with('=') || rest.starts_with(':')
            })
        };
        match self.text.lines().position(starts) {
            Some(line) => format!("{}:{}: `{key}`: {message}", self.path, line + 1),
            None => format!("{}: `{key}`: {message}", self.path),
        }
    }

    /// The value of a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.map.get(key).filter(|v| !v.is_null())
    }

    /// A number, or `default` where the key is missing.
    ///
    /// # Errors
    /// Not a finite number.
    pub fn number(&self, key: &str, default: f64) -> Result<f64, String> {
        match self.get(key) {
            None => Ok(default),
            Some(value) => value
                .as_f64()
                .filter(|x| x.is_finite())
                .ok_or_else(|| self.error(key, &format!("expected a number, found {value}"))),
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

    /// A count of at least `least`.
    ///
    /// # Errors
    /// Not a whole number, or too small.
    pub fn count(&self, key: &str, default: usize, least: usize) -> Result<usize, String> {
        let Some(value) = self.get(key) else { return Ok(default) };
        let count = value.as_u64().and_then(|n| usize::try_from(n).ok()).filter(|n| *n >= least);
        count.ok_or_else(|| self.error(key, &format!("expected a whole number >= {least}, found {value}")))
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

    /// `count` numbers: one for all, or a list of that length.
    ///
    /// # Errors
    /// Neither.
    pub fn numbers(&self, key: &str, default: f64, count: usize) -> Result<Vec<f64>, String> {
        let expected = || self.error(key, &format!("expected a number >= 0 or a list of {count} of them"));
        let list = match self.get(key) {
            Some(Value::Array(items)) => {
                items.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>().ok_or_else(expected)?
            }
            _ => vec![self.number(key, default)?; count],
        };
        if list.len() == count && list.iter().all(|x| *x >= 0.0 && x.is_finite()) {
            Ok(list)
        } else {
            Err(expected())
        }
    }

    /// A list of rows of N numbers.
    ///
    /// # Errors
    /// Some row is not.
    pub fn rows<const N: usize>(&self, key: &str) -> Result<Option<Vec<[f64; N]>>, String> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let row = |v: &Value| -> Option<[f64; N]> {
            let items: Vec<f64> = v.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
            items.try_into().ok()
        };
        let rows = value.as_array().and_then(|items| items.iter().map(row).collect::<Option<Vec<_>>>());
        rows.map(Some).ok_or_else(|| self.error(key, &format!("expected a list of rows of {N} numbers")))
    }

    /// A list of point numbers below `points`.
    ///
    /// # Errors
    /// Not a list, or a point that does not exist.
    pub fn points(&self, key: &str, points: usize) -> Result<Option<Vec<usize>>, String> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let list = value.as_array().and_then(|items| {
            items.iter().map(|v| v.as_u64().and_then(|n| usize::try_from(n).ok())).collect::<Option<Vec<_>>>()
        });
        let list =
            list.ok_or_else(|| self.error(key, "expected a list of point numbers, for example [0, 2]"))?;
        match list.iter().find(|p| **p >= points) {
            Some(p) => {
                Err(self.error(key, &format!("names point {p}, but the points are 0 to {}", points - 1)))
            }
            None => Ok(Some(list)),
        }
    }
}
