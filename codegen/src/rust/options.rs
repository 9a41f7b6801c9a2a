//! Options of an emitted file: the scalar, the functions, the processor for which statements are ordered.

use super::layout;
use crate::program::answer::Function;

/// The scalar of an emitted file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum ScalarType {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    #[default]
    F64,
    /// Any type that implements the runtime's `Real`, by its path, such as lanes or a counting scalar.
    Path(String),
}

impl ScalarType {
    /// Is it single precision, or lanes of it?
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
    /// Path of the runtime crate, or of the module that provides its numbers.
    pub runtime: String,
    /// Only these functions, without glue; if empty, all functions of the program, with glue.
    pub functions: Vec<Function>,
    /// The processor that will run the code. By default a host for f64, a microcontroller for any other scalar.
    pub core: Option<Core>,
    /// Adds two functions to a complete file, `begin_step` and `rates_near`, for steps whose evaluations share work
    /// (`ode::shared_work` of the runtime).
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

/// The processor that runs the emitted code. It determines the order of statements, never a bit of a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Core {
    /// A microcontroller: in-order execution, few registers, no vector instructions.
    CortexM4,
    /// A host: out-of-order execution within a window; two sines in the time of one.
    Host,
}

impl EmitOptions {
    /// The processor for which the statements are ordered.
    #[must_use]
    pub fn core(&self) -> Core {
        let usual = if self.scalar == ScalarType::F64 { Core::Host } else { Core::CortexM4 };
        self.core.unwrap_or(usual)
    }
}

impl ScalarType {
    /// The scalar's path in Rust.
    pub(super) fn path(&self) -> &str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Path(path) => path.trim(),
        }
    }

    /// A bound that the scalar can hold: in f32 a finite one is at most its largest number, and 0 only if it is 0.
    pub(super) fn within(&self, bound: f64) -> f64 {
        match self {
            Self::F32 if bound.is_finite() && bound != 0.0 => {
                let size = bound.abs().clamp(f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX));
                size.copysign(bound)
            }
            _ => bound,
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
            // Rounded once to f32; printed as the shortest text that reads back as the same number.
            (Self::F32, None) => layout::text(format_args!("{:?}_f32", value as f32)),
            (Self::F64, None) => layout::text(format_args!("{value:?}_f64")),
            (Self::Path(_), None) => format!("<S as Real>::from_f64({value:?}_f64)"),
            (Self::Path(_), Some(name)) => {
                format!("<S as Real>::from_f64({})", name.replace("S::", "f64::"))
            }
        };
        if text.starts_with('-') { format!("({text})") } else { text }
    }
}
