//! Cycles of one instruction on a Cortex-M4F, as an interval.
//!
//! In: the halfwords of an instruction. Out: fewest and most cycles, after the Cortex-M4 Technical Reference Manual
//! (r0p1, sections 3.3.1 and 7.2.3) for memory without wait states. A taken branch costs [`REFILL`] more. Not modelled:
//! flash wait states, bus contention. Shared with the emulator's plug-in, so it must not depend on any crate.

/// Fewest and most cycles of refilling the pipeline after a taken branch.
pub const REFILL: (u64, u64) = (1, 3);

/// Fewest and most cycles, not counting the refill after a taken branch.
#[must_use]
pub fn cycles(first: u16, second: u16) -> (u64, u64) {
    let (a, b) = (u32::from(first), u32::from(second));
    if first >> 11 < 0b11101 {
        return narrow(a);
    }
    match a {
        _ if a & 0xEC00 == 0xEC00 => coprocessor(a, b),
        _ if a & 0xFE40 == 0xE800 => list(b.count_ones()), // ldm, stm, push.w, pop.w
        _ if a & 0xFFF0 == 0xE8D0 && b & 0xE0 == 0 => (2, 2), // tbb, tbh
        _ if a & 0xFE40 == 0xE840 => (2, 3),               // ldrd, strd and exclusives
        _ if a & 0xFE00 == 0xF800 => (1, 2),               // ldr, str of any width
        _ if a & 0xFFD0 == 0xFB90 => (2, 12),              // sdiv, udiv
        _ => (1, 1),
    }
}

fn narrow(i: u32) -> (u64, u64) {
    match i {
        _ if i & 0xFE00 == 0xB400 || i & 0xFE00 == 0xBC00 => list((i & 0x1FF).count_ones()),
        _ if i & 0xF000 == 0xC000 => list((i & 0xFF).count_ones()),
        _ if i & 0xF800 == 0x4800 || matches!(i >> 12, 5..=9) => (1, 2), // ldr, str
        _ if i & 0xFF00 == 0xBF00 && i & 15 != 0 => (0, 1),              // it may fold away
        _ => (1, 1),
    }
}

fn coprocessor(a: u32, b: u32) -> (u64, u64) {
    if b & 0xE00 != 0xA00 {
        return (1, 2);
    }
    let double = b & 0x100 != 0;
    if a & 0x0F00 != 0x0E00 {
        return match a {
            _ if a & 0xFF20 == 0xED00 => {
                if double {
                    (2, 3)
                } else {
                    (1, 2)
                }
            } // vldr, vstr
            _ if a & 0xFFE0 == 0xEC40 => (2, 2), // vmov of two words
            _ => list(b & 0xFF),                 // vldm, vstm, vpush, vpop
        };
    }
    match a & 0xB0 {
        _ if b & 0x10 != 0 => (1, 2),                        // vmov, vmrs
        0x80 => (14, 14),                                    // vdiv
        0x00 | 0x10 | 0x90 | 0xA0 => (3, 4),                 // vmla, vnmla, vfnma, vfma
        0xB0 if a & 15 == 1 && b & 0xC0 == 0xC0 => (14, 14), // vsqrt
        _ => (1, 2), // 1, and 1 more when the next instruction needs the result
    }
}

/// Cycles of a transfer of several words.
fn list(words: u32) -> (u64, u64) {
    let cycles = 1 + u64::from(words);
    (cycles, cycles)
}

#[cfg(test)]
mod tests {
    use super::cycles;

    #[test]
    fn by_the_manual() {
        let cases: [(&str, [u16; 2], (u64, u64)); 20] = [
            ("adds r0, r0, r1", [0x1840, 0], (1, 1)),
            ("push {r4, r5, r6, r7, lr}", [0xB5F0, 0], (6, 6)),
            ("pop {r4, pc}", [0xBD10, 0], (3, 3)),
            ("push.w {r4-r11, lr}", [0xE92D, 0x4FF0], (10, 10)),
            ("ldr r0, [r1]", [0x6808, 0], (1, 2)),
            ("ldr.w r0, [r1]", [0xF8D1, 0x0000], (1, 2)),
            ("ldrd r0, r1, [r2]", [0xE9D2, 0x0100], (2, 3)),
            ("udiv r0, r1, r2", [0xFBB1, 0xF0F2], (2, 12)),
            ("it eq", [0xBF08, 0], (0, 1)),
            ("nop", [0xBF00, 0], (1, 1)),
            ("vadd.f32 s0, s0, s1", [0xEE30, 0x0A20], (1, 2)),
            ("vmul.f32 s0, s0, s1", [0xEE20, 0x0A20], (1, 2)),
            ("vmla.f32 s0, s0, s1", [0xEE00, 0x0A20], (3, 4)),
            ("vfma.f32 s0, s1, s2", [0xEEA0, 0x0A81], (3, 4)),
            ("vdiv.f32 s0, s0, s1", [0xEE80, 0x0A20], (14, 14)),
            ("vsqrt.f32 s0, s0", [0xEEB1, 0x0AC0], (14, 14)),
            ("vneg.f32 s0, s0", [0xEEB1, 0x0A40], (1, 2)),
            ("vldr s0, [r0]", [0xED90, 0x0A00], (1, 2)),
            ("vldr d0, [r0]", [0xED90, 0x0B00], (2, 3)),
            ("vpush {d8-d15}", [0xED2D, 0x8B10], (17, 17)),
        ];
        for (text, [first, second], expected) in cases {
            assert_eq!(cycles(first, second), expected, "{text}");
        }
    }
}
