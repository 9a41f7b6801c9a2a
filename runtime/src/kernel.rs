//! Loops over many nodes, compiled a second time for wider registers and chosen when the program runs.
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

/// Runs the kernel as this machine does it fastest.
#[inline(always)]
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if x86::has_avx2() {
        return x86::run(kernel);
    }
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::Kernel;

    cpufeatures::new!(avx2, "avx2");

    /// Whether machine and operating system know AVX2; asked once.
    #[inline(always)]
    pub fn has_avx2() -> bool {
        avx2::get()
    }

    /// The kernel with AVX2; call where [`has_avx2`] holds.
    #[expect(unsafe_code, reason = "the compiler cannot know that the machine has been asked")]
    #[inline(always)]
    pub fn run<K: Kernel>(kernel: K) -> K::Output {
        // SAFETY: `super::run` asks `has_avx2` first.
        unsafe { wide(kernel) }
    }

    #[target_feature(enable = "avx2")]
    fn wide<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }
}
