//! A setting of a figure, NAME=NUMBER.

use crate::failure::Failure;

/// The number after the `=`.
pub(super) fn value_of(setting: &str) -> Result<f64, Failure> {
    let value = setting.split_once('=').and_then(|(_, v)| v.trim().parse::<f64>().ok());
    let wrong = || Failure::Wrong(format!("--set {setting}: expected NAME=NUMBER"));
    value.filter(|v| v.is_finite()).ok_or_else(wrong)
}

/// The name before the `=`.
pub(super) fn name_of(setting: &str) -> &str {
    setting.split('=').next().unwrap_or_default().trim()
}
