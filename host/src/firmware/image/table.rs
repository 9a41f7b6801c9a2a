//! Table branches of Thumb-2 that are no `tbb` or `tbh`: a jump into a list of jumps.
//!
//! In: halfwords of code, and where a `mov pc, rn` is among them. Out: whether that jumps into such a list, so that its
//! targets are known. Where the code between is too long for offsets of a byte or two, and wherever their literals lie
//! in between, LLVM writes
//! ```text
//! adr r, list     add.w rn, r, index, lsl #2     mov pc, rn     list: b.w first, b.w second, ...
//! ```
//! after a comparison of the index with the number of entries.

use crate::firmware::thumb::{Kind, decode, is_wide};

/// Most halfwords between the beginning of this and the jump.
const REACH: usize = 16;

/// Whether the halfword at byte `at` of code branches by a list. `half` gives the halfword at a byte, the first of
/// which has the address `base`.
pub(super) fn is_branch(base: u32, half: impl Fn(usize) -> u16, at: usize) -> bool {
    let jump = half(at);
    if is_wide(jump) || jump & 0xFF87 != 0x4687 {
        return false;
    }
    let register = jump >> 3 & 15;
    let before = || (1..=REACH).filter_map(|n| at.checked_sub(2 * n));
    // add.w rn, r, index, lsl #2
    let sum =
        before().find(|at| half(*at) & 0xFFF0 == 0xEB00 && half(at + 2) & 0xFFF0 == register << 8 | 0x80);
    let Some(sum) = sum else { return false };
    let start = half(sum) & 15;
    let list = before().filter(|at| *at < sum).find_map(|at| {
        // The pc reads as the address of the next word but one.
        let pc = (base as usize + at + 4) & !3;
        let (first, second) = (half(at), half(at + 2));
        let offset = match () {
            () if first == 0xA000 | start << 8 | first & 0xFF => 4 * (first & 0xFF),
            () if first & 0xFBFF == 0xF20F && second & 0x8F00 == start << 8 => {
                (first >> 10 & 1) << 11 | (second >> 12 & 7) << 8 | second & 0xFF
            }
            () => return None,
        };
        (pc + usize::from(offset)).checked_sub(base as usize)
    });
    // Two entries at least: one is no list.
    list.is_some_and(|list| {
        [list, list + 4].into_iter().all(|at| {
            let entry = decode(0, half(at), half(at + 2));
            entry.size == 4 && matches!(entry.kind, Kind::Jump(_))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::is_branch;

    /// `adr.w r2, list`, `add.w r3, r2, r1, lsl #2`, `movs r2, #0`, `mov pc, r3`, `nop`, a literal, the list.
    const CODE: [u16; 14] = [
        0xF20F, 0x0210, 0xEB02, 0x0381, 0x2200, 0x469F, 0xBF00, 0x0000, 0x4220, 0x0000, 0xF000, 0xB832,
        0xF000, 0xB842,
    ];

    fn is(halves: &[u16]) -> bool {
        is_branch(0x0800_0000, |at| halves.get(at / 2).copied().unwrap_or(0), 10)
    }

    #[test]
    fn a_jump_into_a_list_of_jumps_is_known() {
        let with = |place: usize, half: u16| {
            let mut code = CODE;
            code[place] = half;
            code
        };
        assert!(is(&CODE));
        assert!(!is(&with(5, 0x46A7)), "another register");
        assert!(!is(&with(5, 0x4798)), "a call");
        assert!(!is(&with(0, 0xF20F - 1)), "no address of a list");
        assert!(!is(&with(3, 0x0341)), "not four bytes an entry");
        assert!(!is(&with(11, 0x1000)), "an entry that is no jump");
        assert!(!is(&with(12, 0xBF00)), "an entry that is no jump");
    }
}
