//! Square roots, exactly rounded on every machine, so that host and chip agree bit for bit.
//!
//! Stable core offers none. A Cortex-M with a floating-point unit gets its instruction through C's function name,
//! x86-64 through an intrinsic; elsewhere libm rounds exactly too.

/// Square root; NaN below 0.
#[inline(always)]
pub(super) fn sqrt_f32(x: f32) -> f32 {
    machine::sqrt_f32(x)
}

/// Square root; NaN below 0.
#[inline(always)]
pub(super) fn sqrt_f64(x: f64) -> f64 {
    machine::sqrt_f64(x)
}

#[cfg(target_arch = "x86_64")]
#[expect(unsafe_code, reason = "the intrinsics ask for SSE2")]
mod machine {
    use core::arch::x86_64::{
        _mm_cvtsd_f64, _mm_cvtss_f32, _mm_set_sd, _mm_set_ss, _mm_sqrt_sd, _mm_sqrt_ss,
    };

    #[inline(always)]
    pub fn sqrt_f32(x: f32) -> f32 {
        // SAFETY: every x86-64 has SSE2; no memory is touched.
        unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
    }

    #[inline(always)]
    pub fn sqrt_f64(x: f64) -> f64 {
        // SAFETY: every x86-64 has SSE2; no memory is touched.
        unsafe {
            let lane = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(lane, lane))
        }
    }
}

// The compiler knows C's `sqrtf` and inlines it as the instruction: no call, no registers moved.
#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
#[expect(unsafe_code, reason = "stable Rust reaches vsqrt by a foreign name only")]
mod machine {
    // The function for unoptimised builds, which do call it. Derived crates carry this file too: `.weak` lets several
    // copies link as objects, `.ifndef` several in one text, as link-time optimisation makes them.
    core::arch::global_asm!(
        ".ifndef sqrtf",
        ".section .text.sqrtf, \"ax\", %progbits",
        ".weak sqrtf",
        ".type sqrtf, %function",
        "sqrtf:",
        // vsqrt.f32 s0, s0 as a number, because the assembler assumes a target without a floating-point unit.
        ".inst.w 0xeeb10ac0",
        "bx lr",
        ".size sqrtf, . - sqrtf",
        ".text",
        ".endif",
    );
    // SAFETY: C's function, defined above: argument and result are in s0, nothing else is read or written.
    unsafe extern "C" {
        safe fn sqrtf(x: f32) -> f32;
    }

    #[inline(always)]
    pub fn sqrt_f32(x: f32) -> f32 {
        sqrtf(x)
    }

    #[inline(always)]
    pub fn sqrt_f64(x: f64) -> f64 {
        libm::sqrt(x)
    }
}

#[cfg(not(any(
    target_arch = "x86_64",
    all(target_arch = "arm", target_os = "none", target_abi = "eabihf")
)))]
mod machine {
    pub use libm::{sqrt as sqrt_f64, sqrtf as sqrt_f32};
}
