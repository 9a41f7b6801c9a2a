//! The chip that the image is built for.

/// What the checks and the emulator need to know of a chip.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Chip {
    /// Name.
    pub name: &'static str,
    /// Rust target.
    pub target: &'static str,
    /// `-C target-cpu`.
    pub cpu: &'static str,
    /// Machine of the emulator.
    pub machine: &'static str,
    /// Flash (bytes).
    pub flash: u64,
    /// RAM that the linker script uses (bytes).
    pub ram: u64,
    /// Clock (Hz).
    pub clock: u64,
}

/// STM32F405: Cortex-M4F at 168 MHz. Its 64 KiB of core-coupled RAM are not used: the emulator lacks them.
pub const STM32F405: Chip = Chip {
    name: "STM32F405",
    target: "thumbv7em-none-eabihf",
    cpu: "cortex-m4",
    machine: "netduinoplus2",
    flash: 1024 * 1024,
    ram: 128 * 1024,
    clock: 168_000_000,
};
