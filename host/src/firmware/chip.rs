//! The chips for which images are built.

/// Properties of a chip that the checks and the emulator need.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Chip {
    /// Name.
    pub name: &'static str,
    /// Its name in file names and on the command line; `firmware/chips` has its memory layout under this name.
    pub short: &'static str,
    /// Rust target.
    pub target: &'static str,
    /// `-C target-cpu`.
    pub cpu: &'static str,
    /// Further options of the compiler.
    pub options: &'static str,
    /// The emulator's machine.
    pub machine: &'static str,
    /// Flash (bytes).
    pub flash: u64,
    /// RAM that the linker script uses (bytes).
    pub ram: u64,
    /// Clock (Hz).
    pub clock: u64,
    /// Does its floating-point unit have FPv5, which a Cortex-M4F's does not?
    pub has_fpv5: bool,
    /// Does it have double precision in hardware?
    pub has_double: bool,
}

/// STM32F405: Cortex-M4F at 168 MHz. Its 64 KiB of core-coupled RAM are not used: the emulator lacks them.
pub const STM32F405: Chip = Chip {
    name: "STM32F405",
    short: "m4",
    target: "thumbv7em-none-eabihf",
    cpu: "cortex-m4",
    options: "",
    machine: "netduinoplus2",
    flash: 1024 * 1024,
    ram: 128 * 1024,
    clock: 168_000_000,
    has_fpv5: false,
    has_double: false,
};

/// A Cortex-M7 of Arm's prototyping board MPS2 (application note 500).
pub const M7: Chip = Chip {
    name: "MPS2 with a Cortex-M7",
    short: "m7",
    cpu: "cortex-m7",
    machine: "mps2-an500",
    clock: 25_000_000,
    has_fpv5: true,
    has_double: true,
    ..STM32F405
};

/// A Cortex-M33 of the same board (application note 505), in its secure state.
pub const M33: Chip = Chip {
    name: "MPS2 with a Cortex-M33",
    short: "m33",
    target: "thumbv8m.main-none-eabihf",
    cpu: "cortex-m33",
    machine: "mps2-an505",
    clock: 20_000_000,
    has_fpv5: true,
    ..STM32F405
};

/// A RISC-V core (imafc) without a board here: the controller is built for it and measured. The checks do not read jump
/// tables, so it is built without any.
pub const RV32: Chip = Chip {
    name: "a RISC-V core (imafc)",
    short: "rv32",
    target: "riscv32imafc-unknown-none-elf",
    cpu: "generic-rv32",
    options: "-Cjump-tables=no",
    machine: "",
    has_fpv5: true,
    ..STM32F405
};

/// All chips that the emulator runs.
pub const ALL: [Chip; 3] = [STM32F405, M7, M33];

impl Chip {
    /// The chip of this short name.
    #[must_use]
    pub fn named(short: &str) -> Option<Self> {
        ALL.into_iter().find(|chip| chip.short == short)
    }
}
