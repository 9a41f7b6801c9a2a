//! Defects that the image's checks must detect; only their tests build this.

use core::hint::black_box;

/// An index that may be out of range.
#[cfg(inject = "panic")]
pub fn defect() {
    black_box([1, 2, 3][black_box(2_usize)]);
}

/// One product in double precision.
#[cfg(inject = "double")]
pub fn defect() {
    black_box(black_box(1.5_f64) * black_box(2.5_f64));
}

/// A function that calls itself.
#[cfg(inject = "recursion")]
pub fn defect() {
    #[inline(never)]
    fn ackermann(m: u32, n: u32) -> u32 {
        match (m, n) {
            (0, _) => n.wrapping_add(1),
            (_, 0) => ackermann(m - 1, 1),
            _ => ackermann(m - 1, ackermann(m, n - 1)),
        }
    }
    black_box(ackermann(black_box(2), black_box(2)));
}

/// A call through a pointer.
#[cfg(inject = "indirect")]
pub fn defect() {
    let function: fn(u32) -> u32 = black_box(u32::swap_bytes);
    black_box(function(1));
}
