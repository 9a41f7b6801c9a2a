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

/// Runs the kernel as this machine does it fastest.
#[inline(always)]
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(wider) = x86::Wider::known() {
        return wider.run(kernel);
    }
    kernel.run()
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::Kernel;

    cpufeatures::new!(avx2, "avx2");
    cpufeatures::new!(avx512, "avx512f", "avx512vl", "avx512dq", "avx512bw");

    /// Instructions that machine and operating system have been asked for.
    pub enum Wider {
        Avx2,
        Avx512,
    }

    impl Wider {
        /// The widest that they know; asked once.
        #[inline(always)]
        pub fn known() -> Option<Self> {
            if avx512::get() { Some(Wider::Avx512) } else { avx2::get().then_some(Wider::Avx2) }
        }

        /// The kernel with them.
        #[expect(unsafe_code, reason = "the compiler cannot know that the machine has been asked")]
        #[inline(always)]
        pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
            match self {
                // SAFETY: `known` is the only maker of this value, where the machine has said yes.
                Wider::Avx2 => unsafe { avx2_run(kernel) },
                // SAFETY: as above.
                Wider::Avx512 => unsafe { avx512_run(kernel) },
            }
        }
    }

    #[target_feature(enable = "avx2")]
    fn avx2_run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }

    #[target_feature(enable = "avx512f,avx512vl,avx512dq,avx512bw")]
    fn avx512_run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }
}
