//! Arguments of `smartbed firmware`.

use std::path::PathBuf;

/// What a board talks over.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Bus {
    /// A serial line.
    Serial,
    /// A CAN bus.
    Can,
}

/// Generate, build for the microcontroller, check, and run in the emulator.
#[derive(clap::Args, Clone, Default, PartialEq, Eq, Debug)]
#[command(
    after_help = "Example:\n  cargo smartbed firmware\n  cargo smartbed firmware tile --steps 1000 --set M=8 --json\n  cargo smartbed firmware truss --set K=4000\n  cargo smartbed firmware tile_with_bladder\n  cargo smartbed firmware single_spring --fast\n  cargo smartbed firmware two_cubes --small\n  cargo smartbed firmware stiff_bladder --by-rows\n  cargo smartbed firmware stiff_bladder --at-rest --set T=1\n  cargo smartbed firmware --elf target/thumbv7em-none-eabihf/release/mine\n  cargo smartbed firmware --board\n  cargo smartbed firmware --board=can"
)]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/ or models/scenes/ [default: tile].
    pub model: Option<String>,
    /// Number of steps: of 1 ms [default: 10000], of a scene its own [default: all].
    #[arg(long, value_name = "N")]
    pub steps: Option<u32>,
    /// Changes a parameter, on the chip and on the host; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Every parameter of a mechanism tunable, every answer computed in every step: what leaving out saves.
    #[arg(long)]
    pub everything: bool,
    /// Optimise for size: a scene takes little more than half of the flash, and up to two fifths more instructions. A scene
    /// of fewer than 16 nodes is, without being asked: it loses less than 3 %.
    #[arg(long)]
    pub small: bool,
    /// Optimise for speed, however small the scene.
    #[arg(long, conflicts_with = "small")]
    pub fast: bool,
    /// Step the sheet of a scene row by row, dampers by predicted speeds: a tenth of the instructions.
    #[arg(long)]
    pub by_rows: bool,
    /// The sheet of a scene at rest at each pressure, from half of the scene's to all of it and back, found beforehand: a
    /// thousandth of the time, for pressures that change slowly.
    #[arg(long, conflicts_with = "by_rows")]
    pub at_rest: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
    /// Build the controller for a real STM32F405 and judge its image; the emulator lacks the board's pins. It talks
    /// over a serial line, with `--board=can` over a CAN bus.
    #[arg(long, value_name = "BUS", num_args = 0..=1, require_equals = true, default_missing_value = "serial",
        conflicts_with_all = ["model", "steps", "set", "everything", "small", "fast", "by_rows", "at_rest", "inject", "elf"])]
    pub board: Option<Bus>,
    /// Judge this image instead of building one: size, stack bound, and every rule of an image.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["model", "steps", "set", "everything", "small", "fast", "by_rows", "at_rest", "inject"])]
    pub elf: Option<PathBuf>,
    /// Build a defect into the image, which the checks must then find.
    #[arg(long, hide = true, value_parser = ["panic", "double", "recursion", "indirect"])]
    pub inject: Option<String>,
}
