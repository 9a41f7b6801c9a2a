//! The origin of a result, so that it can be reproduced: version, command, settings, seeds, and hashes (SHA-256) of the
//! plan and of the mesh that it names.
//!
//! In: a plan's file and settings. Out: members of a JSON object, or a line for a page.

use crate::hash::hash;
use crate::number::json_string;
use crate::plan::Read;
use crate::plan_file::PlanFile;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Cache: hashes of meshes, by path.
pub type Meshes = BTreeMap<PathBuf, String>;

/// The origin of a result.
#[derive(Clone, Debug)]
pub struct Origin {
    command: String,
    plan: String,
    mesh: Option<String>,
    /// All settings, in their order.
    pub settings: Vec<String>,
}

impl Origin {
    /// For a command that ran a plan with these `settings`.
    #[must_use]
    pub fn new(command: String, plan: &PlanFile, settings: Vec<String>, meshes: &mut Meshes) -> Self {
        let mesh = plan.mesh(&settings).map(|path| {
            // A mesh that cannot be read makes the run fail with its own error.
            let own = || crate::plan::mesh::bytes(&path).map(|bytes| hash(&bytes)).unwrap_or_default();
            meshes.entry(path.clone()).or_insert_with(own).clone()
        });
        Self { command, plan: plan.hash.clone(), mesh, settings }
    }

    /// Names and values in a fixed order, without the settings.
    #[must_use]
    pub fn pairs(&self) -> Vec<(&'static str, String)> {
        let mut pairs = vec![
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("command", self.command.clone()),
            ("plan_sha256", self.plan.clone()),
        ];
        pairs.extend(self.mesh.clone().map(|hash| ("mesh_sha256", hash)));
        pairs
    }

    /// As members of a JSON object, with a trailing comma.
    #[must_use]
    pub fn json(&self) -> String {
        let pairs: String = self
            .pairs()
            .iter()
            .map(|(name, value)| format!("\"{name}\": {}, ", json_string(value)))
            .collect();
        format!("{pairs}\"settings\": {}, ", list(&self.settings))
    }

    /// As a line of text.
    #[must_use]
    pub fn line(&self, read: &Read) -> String {
        let pairs: Vec<String> =
            self.pairs().iter().map(|(name, value)| format!("{} {value}", name.replace('_', " "))).collect();
        let settings = if self.settings.is_empty() { "none".to_owned() } else { self.settings.join(" ") };
        let seeds: String = seeds(read).iter().map(|(name, seed)| format!(", {name} {seed}")).collect();
        format!("{}, settings {settings}{seeds}.", pairs.join(", "))
    }
}

/// Texts as a JSON array.
#[must_use]
pub fn list(texts: &[String]) -> String {
    let texts: Vec<String> = texts.iter().map(|text| json_string(text)).collect();
    format!("[{}]", texts.join(", "))
}

/// Seeds of all noise in a plan.
#[must_use]
pub fn seeds(read: &Read) -> Vec<(&'static str, u64)> {
    let sensors = read.sensors.as_ref().map(|own| ("sensors.seed", own.seed));
    sensors.into_iter().chain(read.instruments.map(|own| ("instruments.seed", own.seed))).collect()
}

/// The same as members of a JSON object.
#[must_use]
pub fn seeds_json(read: &Read) -> String {
    let seeds: Vec<String> = seeds(read).iter().map(|(name, seed)| format!("\"{name}\": {seed}")).collect();
    format!("{{{}}}", seeds.join(", "))
}
