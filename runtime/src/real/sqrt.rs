//! Square roots, exactly rounded on every machine, so that host and chip agree bit for bit.
//!
//! core offers none on stable Rust. The instruction is reached by assembly on a Cortex-M with a
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

// The hard-float ABI says that there is a unit, and that argument and result are in s0.
#[cfg(all(target_arch = "arm", target_os = "none", target_abi = "eabihf"))]
#[expect(unsafe_code, reason = "stable Rust reaches vsqrt by assembly only")]
mod machine {
    /// A name of this crate's own: crates that are derived carry this file, and link into one image.
    macro_rules! symbol {
        () => {
            concat!("smartbed_vsqrt_f32_", env!("CARGO_CRATE_NAME"))
        };
    }
    core::arch::global_asm!(
        concat!(".section .text.", symbol!(), ", \"ax\", %progbits"),
        concat!(".global ", symbol!()),
        concat!(".type ", symbol!(), ", %function"),
        concat!(symbol!(), ":"),
        // vsqrt.f32 s0, s0: in numbers, because the assembler takes the target for one without a unit.
        ".inst.w 0xeeb10ac0",
        "bx lr",
        concat!(".size ", symbol!(), ", . - ", symbol!()),
        ".text",
    );
    // SAFETY: the symbol is defined above with this signature, reads s0 and writes s0 only.
    unsafe extern "C" {
        #[link_name = concat!("smartbed_vsqrt_f32_", env!("CARGO_CRATE_NAME"))]
        safe fn smartbed_vsqrt_f32(x: f32) -> f32;
    }

    #[inline(always)]
    pub fn sqrt_f32(x: f32) -> f32 {
        smartbed_vsqrt_f32(x)
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
