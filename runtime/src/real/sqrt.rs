//! Square roots, exactly rounded on every machine, so that host and chip agree bit for bit.
//!
//! core offers none on stable Rust. The instruction is reached by C's name on a Cortex-M with a
//! floating-point unit, by an intrinsic on x86-64; elsewhere libm rounds exactly too.

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

// Called by the name that C gives it, a root becomes the instruction where it stands: no call, no register moved.
#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
#[expect(unsafe_code, reason = "stable Rust reaches vsqrt by a foreign name only")]
mod machine {
    // What an unoptimised program calls. Crates that are derived carry this file too: weak where they link as objects,
    // asked for where a linker that optimises makes them one text.
    core::arch::global_asm!(
        ".ifndef sqrtf",
        ".section .text.sqrtf, \"ax\", %progbits",
        ".weak sqrtf",
        ".type sqrtf, %function",
        "sqrtf:",
        // vsqrt.f32 s0, s0: in numbers, because the assembler takes the target for one without a unit.
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
