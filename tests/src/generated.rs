//! The emitted Rust of every model and scalar, compiled here, with names for the tests.

use crate::subject::{Engine, Names, Subject};
use smartbed_runtime::real::{Real, counting::Counting};

/// One emitted file as a module, and its mechanism as a subject.
macro_rules! emitted {
    ($module:ident, $scalar:ty, $mechanism:ident, $file:literal) => {
        #[doc = concat!("Emitted: ", $file, ".")]
        pub mod $module {
            include!(concat!(env!("OUT_DIR"), "/", $file, ".rs"));
        }

        impl Subject<$scalar> for $module::$mechanism {
            fn names(&self) -> Names {
                let of = |names: &[&str]| names.iter().map(ToString::to_string).collect();
                Names {
                    q: of(&$module::Q_NAMES),
                    u: of(&$module::U_NAMES),
                    inputs: of(&$module::INPUT_NAMES),
                    outputs: of(&$module::OUTPUT_NAMES),
                }
            }

            fn set_parameter(&mut self, name: &str, value: f64) {
                let index = $module::PARAMETER_NAMES.iter().position(|known| *known == name);
                let index = index.unwrap_or_else(|| panic!("no tunable parameter `{name}`"));
                assert!(self.set_parameter(index, <$scalar as Real>::from_f64(value)), "{name}");
            }

            fn outputs(&mut self, q: &[$scalar], u: &[$scalar], inputs: &[$scalar]) -> Vec<$scalar> {
                let zero = <$scalar as Real>::ZERO;
                let state = (q.try_into().expect("n_q"), u.try_into().expect("n_u"));
                let inputs = inputs.try_into().expect("n_inputs");
                $module::outputs(zero, state.0, state.1, inputs, self.prepared()).to_vec()
            }
        }
    };
}

emitted!(pendulum3_f64, f64, Pendulum3, "pendulum3_f64");
emitted!(pendulum3_f32, f32, Pendulum3, "pendulum3_f32");
emitted!(pendulum3_counting, Counting, Pendulum3, "pendulum3_counting");
emitted!(fourbar_f64, f64, Fourbar, "fourbar_f64");
emitted!(fourbar_f32, f32, Fourbar, "fourbar_f32");
emitted!(fourbar_counting, Counting, Fourbar, "fourbar_counting");
emitted!(fourbar_accurate_f64, f64, Fourbar, "fourbar_accurate_f64");
emitted!(fourbar_accurate_f32, f32, Fourbar, "fourbar_accurate_f32");
emitted!(fourbar_accurate_counting, Counting, Fourbar, "fourbar_accurate_counting");
emitted!(tile_f64, f64, Tile, "tile_f64");
emitted!(tile_f32, f32, Tile, "tile_f32");
emitted!(tile_counting, Counting, Tile, "tile_counting");
emitted!(tile_minimal_f64, f64, TileMinimal, "tile_minimal_f64");
emitted!(tile_minimal_f32, f32, TileMinimal, "tile_minimal_f32");
emitted!(tile_minimal_counting, Counting, TileMinimal, "tile_minimal_counting");
emitted!(tile_loaded_f64, f64, Tile, "tile_loaded_f64");
emitted!(tile_loaded_f32, f32, Tile, "tile_loaded_f32");
emitted!(tile_minimal_loaded_f64, f64, TileMinimal, "tile_minimal_loaded_f64");
emitted!(tile_minimal_loaded_f32, f32, TileMinimal, "tile_minimal_loaded_f32");
emitted!(parallelogram_f64, f64, Parallelogram, "parallelogram_f64");
emitted!(parallelogram_f32, f32, Parallelogram, "parallelogram_f32");
emitted!(arm6_f64, f64, Arm6, "arm6_f64");
emitted!(bicycle_f64, f64, Bicycle, "bicycle_f64");
emitted!(pendulum10_f64, f64, Pendulum10, "pendulum10_f64");

/// The compiled model in f64.
///
/// # Panics
/// If the model is not among those compiled.
#[must_use]
pub fn double(model: &str) -> Box<dyn Subject<f64>> {
    match model {
        "pendulum3" => Box::new(pendulum3_f64::Pendulum3::default()),
        "fourbar" => Box::new(fourbar_f64::Fourbar::default()),
        "fourbar accurate" => Box::new(fourbar_accurate_f64::Fourbar::default()),
        "tile" => Box::new(tile_f64::Tile::default()),
        "tile_minimal" => Box::new(tile_minimal_f64::TileMinimal::default()),
        "arm6" => Box::new(arm6_f64::Arm6::default()),
        "bicycle" => Box::new(bicycle_f64::Bicycle::default()),
        "pendulum10" => Box::new(pendulum10_f64::Pendulum10::default()),
        "tile loaded" => Box::new(tile_loaded_f64::Tile::default()),
        "tile_minimal loaded" => Box::new(tile_minimal_loaded_f64::TileMinimal::default()),
        _ => panic!("{:?}: `{model}` is not in build.rs", Engine::Compiled),
    }
}

/// The compiled model in f32.
///
/// # Panics
/// If the model is not among those compiled.
#[must_use]
pub fn single(model: &str) -> Box<dyn Subject<f32>> {
    match model {
        "pendulum3" => Box::new(pendulum3_f32::Pendulum3::default()),
        "fourbar" => Box::new(fourbar_f32::Fourbar::default()),
        "fourbar accurate" => Box::new(fourbar_accurate_f32::Fourbar::default()),
        "tile" => Box::new(tile_f32::Tile::default()),
        "tile_minimal" => Box::new(tile_minimal_f32::TileMinimal::default()),
        "tile loaded" => Box::new(tile_loaded_f32::Tile::default()),
        "tile_minimal loaded" => Box::new(tile_minimal_loaded_f32::TileMinimal::default()),
        _ => panic!("{:?}: `{model}` is not in build.rs", Engine::Compiled),
    }
}

/// The compiled model on the counting scalar.
///
/// # Panics
/// If the model is not among those compiled.
#[must_use]
pub fn counting(model: &str) -> Box<dyn Subject<Counting>> {
    match model {
        "pendulum3" => Box::new(pendulum3_counting::Pendulum3::default()),
        "fourbar" => Box::new(fourbar_counting::Fourbar::default()),
        "fourbar accurate" => Box::new(fourbar_accurate_counting::Fourbar::default()),
        "tile" => Box::new(tile_counting::Tile::default()),
        "tile_minimal" => Box::new(tile_minimal_counting::TileMinimal::default()),
        _ => panic!("{:?}: `{model}` is not in build.rs", Engine::Compiled),
    }
}
