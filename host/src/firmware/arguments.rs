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

/// Build the program of a model or scene for the microcontroller, check its image, run it in the emulator, and
/// compare the result with the host's, bit for bit.
#[derive(clap::Args, Clone, Default, PartialEq, Eq, Debug)]
#[command(
    after_help = "Example:\n  cargo smartbed firmware\n  cargo smartbed firmware tile --steps 1000 --set M=8 --json\n  cargo smartbed firmware truss --set K=4000\n  cargo smartbed firmware tile_with_bladder\n  cargo smartbed firmware single_spring --fast\n  cargo smartbed firmware two_cubes --small\n  cargo smartbed firmware stiff_bladder --by-rows\n  cargo smartbed firmware stiff_bladder --at-rest --set T=1\n  cargo smartbed firmware --elf target/thumbv7em-none-eabihf/release/mine\n  cargo smartbed firmware --board\n  cargo smartbed firmware --board=can"
)]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/ or models/scenes/ [default: tile].
    pub model: Option<String>,
    /// Number of steps. Of a mechanism: steps of 1 ms [default: 10000]; of a scene: steps as its file says
    /// [default: all of the run, but for a last one that is shorter].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub steps: Option<u32>,
    /// Change a parameter of a model or a key of a scene, on the chip and on the host; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Build a mechanism with every parameter changeable and every answer computed in every step, to compare its cost
    /// with that of the usual image, which has only what it needs.
    #[arg(long)]
    pub everything: bool,
    /// Optimise the image for size: a scene takes little more than half of the flash, and up to two fifths more
    /// instructions per step. This is the default for scenes of fewer than 16 nodes. Not with --fast.
    #[arg(long)]
    pub small: bool,
    /// Optimise the image for speed, which is the default except for scenes of fewer than 16 nodes. Not with --small.
    #[arg(long, conflicts_with = "small")]
    pub fast: bool,
    /// Step the sheet of a scene of format 1 in one pass over its rows, with a tenth of the instructions; damping
    /// forces are computed from predicted speeds. Other scenes and models are refused, with the reason.
    #[arg(long)]
    pub by_rows: bool,
    /// For a sheet of a scene of format 1 whose pressure changes slowly: compute its equilibria between half of the
    /// scene's pressure and all of it on the host; the chip only interpolates between them, which takes about a
    /// thousandth of the time. The test run goes through these pressures and back. Not with --by-rows; other scenes
    /// and models are refused, with the reason.
    #[arg(long, conflicts_with = "by_rows")]
    pub at_rest: bool,
    /// Print the result as one JSON object.
    #[arg(long)]
    pub json: bool,
    /// Build the tile's controller for a real STM32F405 and check its image, as --elf does. It is not run, because
    /// the emulator does not have the board's pins. It communicates over a serial line (the default), or with
    /// `--board=can` over a CAN bus.
    #[arg(long, value_name = "BUS", num_args = 0..=1, require_equals = true, default_missing_value = "serial",
        conflicts_with_all = ["model", "steps", "set", "everything", "small", "fast", "by_rows", "at_rest", "inject", "elf"])]
    pub board: Option<Bus>,
    /// Check this image (an ELF file) instead of building one: flash, RAM, a bounded stack, and no recursion,
    /// indirect calls, panics, formatting, heap, double precision or fused multiply-add.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["model", "steps", "set", "everything", "small", "fast", "by_rows", "at_rest", "inject"])]
    pub elf: Option<PathBuf>,
    /// Build a defect into the image, which the checks must then find.
    #[arg(long, hide = true, value_parser = ["panic", "double", "recursion", "indirect"])]
    pub inject: Option<String>,
}
