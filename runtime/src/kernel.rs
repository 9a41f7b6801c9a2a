//! Loops over many nodes, compiled anew for wider registers and chosen when the program runs.
//!
//! In: a [`Kernel`], a loop as a value. Out: what it returns, the same bits on every machine: wider registers hold more
//! numbers side by side, no operation is fused or reordered. Microcontrollers have the plain loop alone.

/// A loop whose body the compiler can lay side by side; `run` must be `#[inline(always)]` with all that it calls, or it
/// keeps the instructions of the oldest machine.
pub trait Kernel {
    /// What it returns.
    type Output;
    /// The loop.
    fn run(self) -> Self::Output;
}

/// Nodes, springs or facets handled at a time: enough to fill registers, few enough for the nearest cache (or, on a
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

/// Runs the kernel as this machine does it fastest.
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
        // SAFETY: the machine has said that it knows these instructions.
        return unsafe { run_avx512(kernel) };
    } else if widest >= Registers::Avx2 && avx2::get() {
        // SAFETY: as above.
        return unsafe { run_avx2(kernel) };
    }
    let _ = widest;
    kernel.run()
}

// Machine and operating system are asked once.
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
