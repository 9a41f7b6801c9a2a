//! Decodes Thumb-2 as far as the checks of an image need it: stack, calls, floating-point hazards.
//!
//! In: halfwords at an address. Out: the effect of the instruction on the stack and on the flow of control. Encodings
//! after the ARMv7-M Architecture Reference Manual, chapter A7. Invariant: decoding is total; an instruction that is
//! not recognised is [`Kind::Other`], and every instruction that lowers sp, calls, or jumps through a register is
//! recognised. Shared with the emulator's plug-in, so it must not depend on any crate.

/// Effects of an instruction, as far as the checks need them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Lowers sp by this number of bytes.
    Stack(u32),
    /// Lowers sp, or sets it from a register, by an amount that is not in the instruction.
    VariableStack,
    /// Calls this address (`bl`).
    Call(u32),
    /// Jumps to this address (`b`, `cbz`, ...): a tail call if it leaves its function.
    Jump(u32),
    /// Calls through a register.
    IndirectCall,
    /// Jumps through a register or a loaded word; not a return, not a table branch.
    IndirectJump,
    /// Arithmetic in double precision: undefined on a Cortex-M4F.
    Double,
    /// An instruction of the FPv5 unit: undefined on a Cortex-M4F.
    Fpv5,
    /// Fused multiply-add: rounds once, whereas the host rounds twice.
    Fused,
    /// Loads a constant of single precision from the literal pool after the code.
    Constant,
    /// Anything else.
    Other,
}

/// A decoded instruction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Instruction {
    /// Size in bytes: 2 or 4.
    pub size: u32,
    /// What it does.
    pub kind: Kind,
}

/// Does this first halfword start a 32-bit instruction?
#[must_use]
pub fn is_wide(first: u16) -> bool {
    first >> 11 >= 0b11101
}

/// Decodes the instruction `first`, `second` at `address`; `second` is ignored by 16-bit ones.
#[must_use]
pub fn decode(address: u32, first: u16, second: u16) -> Instruction {
    if is_wide(first) {
        Instruction { size: 4, kind: wide(address, u32::from(first), u32::from(second)) }
    } else {
        Instruction { size: 2, kind: narrow(address, u32::from(first)) }
    }
}

/// Value of the `bits`-bit two's complement number `x`.
fn signed(x: u32, bits: u32) -> u32 {
    ((x << (32 - bits)).cast_signed() >> (32 - bits)).cast_unsigned()
}

/// Target of a branch: the pc reads as the instruction's address + 4.
fn relative(address: u32, offset: u32) -> u32 {
    address.wrapping_add(4).wrapping_add(offset)
}

fn narrow(address: u32, i: u32) -> Kind {
    const LR: u32 = 14;
    const FRAME_POINTER: u32 = 7;
    let register = i >> 3 & 15;
    match i {
        _ if i & 0xFE00 == 0xB400 => Kind::Stack(4 * (i & 0x1FF).count_ones()),
        _ if i & 0xFF80 == 0xB080 => Kind::Stack(4 * (i & 0x7F)),
        _ if i & 0xFF87 == 0x4685 && register != FRAME_POINTER => Kind::VariableStack,
        _ if i & 0xFF87 == 0x4485 => Kind::VariableStack,
        _ if i & 0xFF87 == 0x4780 => Kind::IndirectCall,
        _ if i & 0xFF87 == 0x4700 && register != LR => Kind::IndirectJump,
        _ if i & 0xFF87 == 0x4687 && register != LR => Kind::IndirectJump,
        _ if i & 0xF800 == 0xE000 => Kind::Jump(relative(address, signed((i & 0x7FF) << 1, 12))),
        _ if i & 0xF000 == 0xD000 && i >> 8 & 15 < 14 => {
            Kind::Jump(relative(address, signed((i & 0xFF) << 1, 9)))
        }
        _ if i & 0xF500 == 0xB100 => Kind::Jump(relative(address, (i >> 9 & 1) << 6 | (i >> 3 & 31) << 1)),
        _ => Kind::Other,
    }
}

fn wide(address: u32, a: u32, b: u32) -> Kind {
    match a {
        _ if a & 0xF800 == 0xF000 && b & 0x8000 != 0 => branch(address, a, b),
        // stmdb sp!, {...}; str rt, [sp, #-n]!; strd rt, rt2, [sp, #-n]!
        0xE92D => Kind::Stack(4 * b.count_ones()),
        0xF84D if b & 0xF00 == 0xD00 => Kind::Stack(b & 0xFF),
        0xE96D => Kind::Stack(4 * (b & 0xFF)),
        // vpush: both register sizes count words in the immediate
        _ if a & 0xFFBF == 0xED2D && b & 0xE00 == 0xA00 => Kind::Stack(4 * (b & 0xFF)),
        // sub.w sp, sp, #modified; subw sp, sp, #plain; sub.w sp, sp, rm
        _ if a & 0xFBEF == 0xF1AD && b & 0x8F00 == 0x0D00 => Kind::Stack(modified_immediate(a, b)),
        _ if a & 0xFBFF == 0xF2AD && b & 0x8F00 == 0x0D00 => Kind::Stack(plain_immediate(a, b)),
        _ if a & 0xFFEF == 0xEBAD && b & 0x0F00 == 0x0D00 => Kind::VariableStack,
        // ldr.w pc, [...]: `pop {pc}` is the form [sp], #4
        _ if a & 0xFF70 == 0xF850 && b >> 12 == 15 && (a, b) != (0xF85D, 0xFB04) => Kind::IndirectJump,
        _ => float(a, b),
    }
}

/// `bl`, `b.w` and `b<cond>.w`.
fn branch(address: u32, a: u32, b: u32) -> Kind {
    let sign = a >> 10 & 1;
    let (j1, j2) = (b >> 13 & 1, b >> 11 & 1);
    if b & 0x1000 != 0 {
        let (i1, i2) = (1 ^ j1 ^ sign, 1 ^ j2 ^ sign);
        let offset = sign << 24 | i1 << 23 | i2 << 22 | (a & 0x3FF) << 12 | (b & 0x7FF) << 1;
        let target = relative(address, signed(offset, 25));
        return if b & 0x4000 != 0 { Kind::Call(target) } else { Kind::Jump(target) };
    }
    if b & 0x4000 == 0 && a >> 6 & 15 < 14 {
        let offset = sign << 20 | j2 << 19 | j1 << 18 | (a & 0x3F) << 12 | (b & 0x7FF) << 1;
        return Kind::Jump(relative(address, signed(offset, 21)));
    }
    Kind::Other
}

/// Floating-point data processing (coprocessors 10: single, 11: double).
fn float(a: u32, b: u32) -> Kind {
    if a & 0xFF3F == 0xED1F && b & 0xF00 == 0xA00 {
        return Kind::Constant; // vldr s, [pc, #n]
    }
    if b & 0xE00 != 0xA00 || b & 0x10 != 0 {
        return Kind::Other; // another coprocessor, or a transfer to a core register
    }
    match a {
        _ if a & 0xFF00 == 0xFE00 => Kind::Fpv5,
        _ if a & 0xFF00 != 0xEE00 => Kind::Other,
        _ if b & 0x100 != 0 => Kind::Double,
        _ if a & 0xFFBF == 0xEEB7 && b & 0xC0 == 0xC0 => Kind::Double, // vcvt.f64.f32
        _ if a & 0xFFBE == 0xEEB6 && b & 0x40 != 0 && a & 1 == 0 => Kind::Fpv5, // vrint
        _ if a & 0xFFB0 == 0xEEA0 || a & 0xFFB0 == 0xEE90 => Kind::Fused,
        _ => Kind::Other,
    }
}

/// The i:imm3:imm8 of a 32-bit instruction.
fn plain_immediate(a: u32, b: u32) -> u32 {
    (a >> 10 & 1) << 11 | (b >> 12 & 7) << 8 | b & 0xFF
}

/// `ThumbExpandImm`: a byte, a repeated byte, or a byte with its top bit set rotated right.
fn modified_immediate(a: u32, b: u32) -> u32 {
    let code = plain_immediate(a, b);
    let byte = code & 0xFF;
    match code >> 8 {
        0 => byte,
        1 => byte << 16 | byte,
        2 => byte << 24 | byte << 8,
        3 => byte << 24 | byte << 16 | byte << 8 | byte,
        _ => (0x80 | code & 0x7F).rotate_right(code >> 7),
    }
}

#[cfg(test)]
mod tests {
    use super::{Kind, decode};

    /// Hand-assembled: (halfwords, meaning) at address 0x0800_1000.
    const CASES: [(&str, [u16; 2], Kind); 32] = [
        ("push {r4, r5, r6, r7, lr}", [0xB5F0, 0], Kind::Stack(20)),
        ("push {r0}", [0xB401, 0], Kind::Stack(4)),
        ("sub sp, #508", [0xB0FF, 0], Kind::Stack(508)),
        ("add sp, #508", [0xB07F, 0], Kind::Other),
        ("pop {r4, pc}", [0xBD10, 0], Kind::Other),
        ("push.w {r4-r11, lr}", [0xE92D, 0x4FF0], Kind::Stack(36)),
        ("str.w r11, [sp, #-4]!", [0xF84D, 0xBD04], Kind::Stack(4)),
        ("strd r0, r1, [sp, #-16]!", [0xE96D, 0x0104], Kind::Stack(16)),
        ("vpush {d8-d15}", [0xED2D, 0x8B10], Kind::Stack(64)),
        ("vpush {s16}", [0xED2D, 0x8A01], Kind::Stack(4)),
        ("sub.w sp, sp, #1024", [0xF5AD, 0x6D80], Kind::Stack(1024)),
        ("sub.w sp, sp, #768", [0xF5AD, 0x7D40], Kind::Stack(768)),
        ("subw sp, sp, #1023", [0xF2AD, 0x3DFF], Kind::Stack(1023)),
        ("sub.w sp, sp, r4", [0xEBAD, 0x0D04], Kind::VariableStack),
        ("mov sp, r4", [0x46A5, 0], Kind::VariableStack),
        ("mov sp, r7", [0x46BD, 0], Kind::Other),
        ("bl .+4", [0xF000, 0xF800], Kind::Call(0x0800_1004)),
        ("bl .-4096", [0xF7FE, 0xFFFE], Kind::Call(0x0800_0000)),
        ("b.w .+0x2004", [0xF002, 0xB800], Kind::Jump(0x0800_3004)),
        ("b .", [0xE7FE, 0], Kind::Jump(0x0800_1000)),
        ("beq .+8", [0xD002, 0], Kind::Jump(0x0800_1008)),
        ("cbnz r0, .+4", [0xB900, 0], Kind::Jump(0x0800_1004)),
        ("blx r3", [0x4798, 0], Kind::IndirectCall),
        ("bx lr", [0x4770, 0], Kind::Other),
        ("bx r3", [0x4718, 0], Kind::IndirectJump),
        ("ldr.w pc, [r0]", [0xF8D0, 0xF000], Kind::IndirectJump),
        ("vldr s2, [pc, #228]", [0xED9F, 0x1A39], Kind::Constant),
        ("vadd.f64 d0, d0, d1", [0xEE30, 0x0B01], Kind::Double),
        ("vcvt.f64.f32 d0, s0", [0xEEB7, 0x0AC0], Kind::Double),
        ("vadd.f32 s0, s0, s1", [0xEE30, 0x0A20], Kind::Other),
        ("vfma.f32 s0, s1, s2", [0xEEA0, 0x0A81], Kind::Fused),
        ("vmov d0, r0, r1", [0xEC41, 0x0B10], Kind::Other),
    ];

    #[test]
    fn decodes_what_it_must_recognise() {
        for (text, [first, second], kind) in CASES {
            assert_eq!(decode(0x0800_1000, first, second).kind, kind, "{text}");
        }
    }

    #[test]
    fn more_floating_point() {
        let kind = |first, second| decode(0, first, second).kind;
        assert_eq!(kind(0xEE20, 0x0A20), Kind::Other, "vmul.f32");
        assert_eq!(kind(0xEE00, 0x0A20), Kind::Other, "vmla.f32 rounds twice");
        assert_eq!(kind(0xEEB1, 0x0AC0), Kind::Other, "vsqrt.f32");
        assert_eq!(kind(0xEEB7, 0x0BC0), Kind::Double, "vcvt.f32.f64");
        assert_eq!(kind(0xEEB8, 0x0AC0), Kind::Other, "vcvt.f32.s32");
        assert_eq!(kind(0xFE80, 0x0A00), Kind::Fpv5, "vmaxnm.f32");
        assert_eq!(kind(0xEE91, 0x0A02), Kind::Fused, "vfnms.f32");
        assert_eq!(kind(0xEE10, 0x0A10), Kind::Other, "vmov r0, s0");
        assert_eq!(kind(0xED90, 0x0B00), Kind::Other, "vldr d0 is a load");
    }

    #[test]
    fn sizes() {
        assert_eq!(decode(0, 0xE7FE, 0).size, 2);
        assert_eq!(decode(0, 0xE92D, 0).size, 4);
        assert_eq!(decode(0, 0xF000, 0).size, 4);
    }
}
