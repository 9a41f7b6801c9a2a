//! Loops over many nodes, compiled for several register widths; the widest that the machine has is chosen at run time.
//!
//! In: a [`Kernel`], a loop as a value. Out: its result, the same bits on every machine: wider registers hold more
//! numbers side by side, no operation is fused or reordered. Microcontrollers have the plain loop alone.

/// A loop that the compiler can vectorise; `run` and all that it calls must be `#[inline(always)]`, or they keep the
/// instructions of the oldest machine.
pub trait Kernel {
    /// Result of the loop.
    type Output;
    /// The loop.
    fn run(self) -> Self::Output;
}

/// Nodes, springs or facets handled at a time: enough to fill registers, few enough for the first-level cache (or, on a
/// microcontroller, for the stack).
pub const BLOCK: usize = if cfg!(target_os = "none") { 4 } else { 64 };

/// Registers that a kernel is compiled for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Debug)]
pub enum Registers {
    /// Those of the oldest machine.
    Plain,
    /// 32 bytes.
    Avx2,
    /// 64 bytes.
    Avx512,
}

/// Runs the kernel with the widest registers of this machine.
#[inline(always)]
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    run_within(Registers::Avx512, kernel)
}

/// Runs the kernel with the widest registers that the machine has, none wider than those given.
#[cfg_attr(
    target_arch = "x86_64",
    expect(unsafe_code, reason = "the compiler cannot know that the machine has been asked")
)]
#[inline(always)]
pub fn run_within<K: Kernel>(widest: Registers, kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if widest >= Registers::Avx512 && avx512::get() {
        // SAFETY: the processor has been asked and supports these instructions.
        return unsafe { run_avx512(kernel) };
    } else if widest >= Registers::Avx2 && avx2::get() {
        // SAFETY: as above.
        return unsafe { run_avx2(kernel) };
    }
    let _ = widest;
    kernel.run()
}

// Support is asked for once and remembered.
#[cfg(target_arch = "x86_64")]
cpufeatures::new!(avx2, "avx2");
#[cfg(target_arch = "x86_64")]
cpufeatures::new!(avx512, "avx512f", "avx512vl", "avx512dq", "avx512bw");

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run()
}
