//! What is emitted: the scalar, the functions, the processor that the order of statements is meant for.

use crate::program::answer::Function;

/// The scalar of an emitted file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum ScalarType {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    #[default]
    F64,
    /// Any type that implements the runtime's `Real`, by its path: lanes, a counting scalar.
    Path(String),
}

impl ScalarType {
    /// Single precision, or lanes of it?
    #[must_use]
    pub fn is_single(&self) -> bool {
        match self {
            Self::F32 => true,
            Self::F64 => false,
            Self::Path(path) => path.rsplit("::").next().is_some_and(|name| name.starts_with("f32")),
        }
    }
}

/// What is emitted and how.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EmitOptions {
    /// The scalar.
    pub scalar: ScalarType,
    /// Path of the runtime crate or of the module that carries its numbers.
    pub runtime: String,
    /// Only these functions, and no glue; all that the program has, with glue, if empty.
    pub functions: Vec<Function>,
    /// What runs the code, if not what usually computes with the scalar: a host with f64, a microcontroller with
    /// any other.
    pub core: Option<Core>,
    /// Two functions more in a complete file, for steps whose evaluations share work (`ode::shared_work` of the runtime):
    /// `begin_step` and `rates_near`.
    pub shared_work: bool,
}

impl Default for EmitOptions {
    fn default() -> Self {
        Self {
            scalar: ScalarType::F64,
            runtime: "smartbed_runtime".to_owned(),
            functions: Vec::new(),
            core: None,
            shared_work: false,
        }
    }
}

/// What runs the emitted code: it decides the order of statements, never a bit of a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Core {
    /// A microcontroller: one instruction after the other, few registers, no vector instructions.
    CortexM4,
    /// A host: whatever is ready, within a window; two sines in the time of one.
    Host,
}

impl EmitOptions {
    /// The processor that the statements are ordered for.
    #[must_use]
    pub fn core(&self) -> Core {
        let usual = if self.scalar == ScalarType::F64 { Core::Host } else { Core::CortexM4 };
        self.core.unwrap_or(usual)
    }
}

impl ScalarType {
    /// Its path in Rust.
    pub(super) fn path(&self) -> &str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Path(path) => path.trim(),
        }
    }

    /// A constant of the scalar: a literal, or a conversion for other scalars.
    pub(super) fn literal(&self, value: f64) -> String {
        let special = match value {
            v if v.is_nan() => Some("S::NAN"),
            v if v == f64::INFINITY => Some("S::INFINITY"),
            v if v == f64::NEG_INFINITY => Some("S::NEG_INFINITY"),
            _ => None,
        };
        let text = match (self, special) {
            (Self::F32 | Self::F64, Some(name)) => name.to_owned(),
            // Rounded once to f32; the shortest text that reads back as that number.
            (Self::F32, None) => format!("{:?}_f32", value as f32),
            (Self::F64, None) => format!("{value:?}_f64"),
            (Self::Path(_), None) => format!("<S as Real>::from_f64({value:?}_f64)"),
            (Self::Path(_), Some(name)) => {
                format!("<S as Real>::from_f64({})", name.replace("S::", "f64::"))
            }
        };
        if text.starts_with('-') { format!("({text})") } else { text }
    }
}
