//! Decodes RISC-V (imafc, 32 bits) as far as the checks of an image need it: stack, calls, fused arithmetic.
//!
//! In: the bytes from an instruction on, and its address. Out: what it does, as defined in [`super::thumb`]. Encodings
//! after the RISC-V Instruction Set Manual, volume I, chapters 2, 22 (F) and 26 (C). A pair of `auipc` and `jalr`,
//! which makes a far call, is decoded as one instruction, because its target is split between the two. Decoding is
//! total, as in `thumb`.

use super::thumb::{Instruction, Kind};

const RA: u32 = 1;
const SP: u32 = 2;
/// The second link register of the calling convention.
const T0: u32 = 5;

/// Decodes the instruction at the beginning of `code`, whose address is `address`.
#[must_use]
pub fn decode(address: u32, code: &[u8]) -> Instruction {
    let half = |at: usize| code.get(at..at + 2).map_or(0, |b| u32::from(u16::from_le_bytes([b[0], b[1]])));
    let word = |at: usize| half(at) | half(at + 2) << 16;
    let (narrow, wide, next) = (half(0), word(0), word(4));
    if narrow & 3 != 3 {
        return Instruction { size: 2, kind: compressed(address, narrow) };
    }
    // auipc rd, high; jalr rd', low(rd)
    let is_pair = wide & 0x7F == 0x17 && next & 0x707F == 0x67 && next >> 15 & 31 == wide >> 7 & 31;
    if is_pair && wide >> 7 & 31 != 0 {
        let target = address.wrapping_add(wide & 0xFFFF_F000).wrapping_add(signed(next >> 20, 12));
        return Instruction { size: 8, kind: to(next >> 7 & 31, target) };
    }
    Instruction { size: 4, kind: full(address, wide) }
}

/// A jump that stores the return address in the register `link`: a call, or a plain jump if that is x0.
fn to(link: u32, target: u32) -> Kind {
    if link == 0 { Kind::Jump(target) } else { Kind::Call(target) }
}

/// A jump to the address in `register`.
fn through(link: u32, register: u32) -> Kind {
    match (link, register) {
        (0, RA | T0) => Kind::Other,
        (0, _) => Kind::IndirectJump,
        _ => Kind::IndirectCall,
    }
}

/// The effect of adding `offset` to sp.
fn moved(offset: u32) -> Kind {
    let by = offset.cast_signed();
    if by < 0 { Kind::Stack(by.unsigned_abs()) } else { Kind::Other }
}

fn full(address: u32, i: u32) -> Kind {
    let (rd, rs1) = (i >> 7 & 31, i >> 15 & 31);
    match i & 0x7F {
        // addi sp, sp, n; from another register the amount is unknown
        0x13 if rd == SP && i >> 12 & 7 == 0 && rs1 == SP => moved(signed(i >> 20, 12)),
        // addi sp, s0, n: back from a frame pointer
        0x13 if rd == SP && i >> 12 & 7 == 0 && rs1 == 8 => Kind::Other,
        0x13 | 0x33 | 0x37 | 0x17 | 0x03 if rd == SP => Kind::VariableStack,
        0x67 => through(rd, rs1),
        0x6F => {
            let offset =
                (i >> 31) << 20 | (i >> 12 & 0xFF) << 12 | (i >> 20 & 1) << 11 | (i >> 21 & 0x3FF) << 1;
            to(rd, address.wrapping_add(signed(offset, 21)))
        }
        0x63 => {
            let offset = (i >> 31) << 12 | (i >> 7 & 1) << 11 | (i >> 25 & 63) << 5 | (i >> 8 & 15) << 1;
            Kind::Jump(address.wrapping_add(signed(offset, 13)))
        }
        // fmadd, fmsub, fnmsub, fnmadd
        0x43 | 0x47 | 0x4B | 0x4F => Kind::Fused,
        // Arithmetic, loads and stores of double precision: the core lacks them.
        0x53 if i >> 25 & 3 == 1 => Kind::Double,
        0x07 | 0x27 if i >> 12 & 7 == 3 => Kind::Double,
        _ => Kind::Other,
    }
}

fn compressed(address: u32, i: u32) -> Kind {
    let (rd, rs2) = (i >> 7 & 31, i >> 2 & 31);
    match (i & 3, i >> 13) {
        // c.j and, on 32 bits, c.jal
        (1, 5 | 1) => {
            let offset = (i >> 12 & 1) << 11
                | (i >> 11 & 1) << 4
                | (i >> 9 & 3) << 8
                | (i >> 8 & 1) << 10
                | (i >> 7 & 1) << 6
                | (i >> 6 & 1) << 7
                | (i >> 3 & 7) << 1
                | (i >> 2 & 1) << 5;
            to(if i >> 13 == 1 { RA } else { 0 }, address.wrapping_add(signed(offset, 12)))
        }
        // c.beqz, c.bnez
        (1, 6 | 7) => {
            let offset = (i >> 12 & 1) << 8
                | (i >> 10 & 3) << 3
                | (i >> 5 & 3) << 6
                | (i >> 3 & 3) << 1
                | (i >> 2 & 1) << 5;
            Kind::Jump(address.wrapping_add(signed(offset, 9)))
        }
        // c.addi sp, n; c.addi16sp n; c.li sp
        (1, 0) if rd == SP => moved(signed((i >> 12 & 1) << 5 | rs2, 6)),
        (1, 3) if rd == SP => {
            let offset = (i >> 12 & 1) << 9
                | (i >> 6 & 1) << 4
                | (i >> 5 & 1) << 6
                | (i >> 3 & 3) << 7
                | (i >> 2 & 1) << 5;
            moved(signed(offset, 10))
        }
        (1, 2) if rd == SP => Kind::VariableStack,
        // c.jr, c.jalr; c.mv and c.add to sp
        (2, 4) if rs2 == 0 && rd != 0 => through(i >> 12 & 1, rd),
        (2, 4) if rd == SP && !(i >> 12 & 1 == 0 && rs2 == 8) => Kind::VariableStack,
        // c.lwsp sp; c.fldsp, c.fsdsp, c.fld, c.fsd
        (2, 2) if rd == SP => Kind::VariableStack,
        (0 | 2, 1 | 5) => Kind::Double,
        _ => Kind::Other,
    }
}

/// Value of the `bits`-bit two's complement number `x`.
fn signed(x: u32, bits: u32) -> u32 {
    ((x << (32 - bits)).cast_signed() >> (32 - bits)).cast_unsigned()
}

#[cfg(test)]
mod tests {
    use super::{Kind, decode};

    /// As LLVM 19 disassembles them at 0x11000.
    const CASES: [(&str, &[u8], u32, Kind); 22] = [
        ("addi sp, sp, -16", &[0x41, 0x11], 2, Kind::Stack(16)),
        ("addi sp, sp, 16", &[0x41, 0x01], 2, Kind::Other),
        ("addi sp, sp, -48", &[0x79, 0x71], 2, Kind::Stack(48)),
        ("addi sp, sp, -272", &[0x6D, 0x71], 2, Kind::Stack(272)),
        ("addi sp, sp, 272", &[0x51, 0x61], 2, Kind::Other),
        ("addi sp, sp, -656", &[0x13, 0x01, 0x01, 0xD7], 4, Kind::Stack(656)),
        ("addi sp, sp, -2048", &[0x13, 0x01, 0x01, 0x80], 4, Kind::Stack(2048)),
        ("addi sp, sp, 656", &[0x13, 0x01, 0x01, 0x29], 4, Kind::Other),
        ("mv a2, sp", &[0x0A, 0x86], 2, Kind::Other),
        ("add a0, a0, sp", &[0x0A, 0x95], 2, Kind::Other),
        ("sub sp, sp, a0", &[0x33, 0x01, 0xA1, 0x40], 4, Kind::VariableStack),
        ("mv sp, a0", &[0x2A, 0x81], 2, Kind::VariableStack),
        ("ret", &[0x82, 0x80], 2, Kind::Other),
        ("jr a5", &[0x82, 0x87], 2, Kind::IndirectJump),
        ("jalr a5", &[0x82, 0x97], 2, Kind::IndirectCall),
        ("jalr 0(a5)", &[0xE7, 0x80, 0x07, 0x00], 4, Kind::IndirectCall),
        ("j .+4", &[0x11, 0xA0], 2, Kind::Jump(0x11004)),
        ("jal ra, .+8", &[0xEF, 0x00, 0x80, 0x00], 4, Kind::Call(0x11008)),
        ("auipc ra, 8; jalr -1196(ra)", &[0x97, 0x80, 0, 0, 0xE7, 0x80, 0x40, 0xB5], 8, Kind::Call(0x18B54)),
        ("auipc t1, 0; jr 8(t1)", &[0x17, 0x03, 0, 0, 0x67, 0x00, 0x83, 0x00], 8, Kind::Jump(0x11008)),
        ("fmadd.s fa0, fa0, fa1, fa2", &[0x43, 0x75, 0xB5, 0x60], 4, Kind::Fused),
        ("fadd.d fa0, fa0, fa1", &[0x53, 0x75, 0xB5, 0x02], 4, Kind::Double),
    ];

    #[test]
    fn decodes_what_it_must_recognise() {
        for (text, bytes, size, kind) in CASES {
            let found = decode(0x11000, bytes);
            assert_eq!((found.size, found.kind), (size, kind), "{text}");
        }
    }

    #[test]
    fn branches_and_single_precision() {
        let kind = |bytes: [u8; 4]| decode(0x100, &bytes).kind;
        assert_eq!(kind([0x63, 0x0C, 0xB5, 0x00]), Kind::Jump(0x118), "beq a0, a1, .+24");
        assert_eq!(kind([0xE3, 0x9E, 0xB5, 0xFE]), Kind::Jump(0xFC), "bne a1, a1, .-4");
        assert_eq!(kind([0x53, 0x75, 0xB5, 0x00]), Kind::Other, "fadd.s");
        assert_eq!(kind([0x53, 0x75, 0x05, 0x58]), Kind::Other, "fsqrt.s");
        assert_eq!(kind([0x02, 0x61, 0, 0]), Kind::Other, "flwsp");
    }
}
