//! Where a guard g(t) changes its sign: bracketed root location, bounded and without derivatives.
//!
//! In: g and a bracket. Out: a bracket (low, high) of the root no wider than asked for, g's sign at
//! `low` being that at the start: the caller stops before the event or steps over it, as it needs.
//! False position with Illinois' halving (Dowell & Jarratt 1971), every third step a bisection, so
//! that the width at least halves in three evaluations.

use crate::real::Scalar;

/// Evaluations at most: 3 for each of the 53 halvings that exhaust f64.
pub const MAX_EVALUATIONS: u32 = 160;

/// Why no root was located.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RootFault {
    /// The guard has the same sign at both ends, or is no number at one of them.
    NotBracketed,
    /// The guard became not-a-number inside the bracket.
    NonFinite,
}

/// Narrows [low, high] around a sign change of `g` to `width`, or to neighbouring numbers.
///
/// # Errors
/// [`RootFault`] if there is no sign change or `g` fails.
pub fn locate<S: Scalar>(
    mut g: impl FnMut(S) -> S,
    mut low: S,
    mut high: S,
    width: S,
) -> Result<(S, S), RootFault> {
    let half = S::ONE / (S::ONE + S::ONE);
    let (mut g_low, mut g_high) = (g(low), g(high));
    let rising = g_low <= S::ZERO && S::ZERO <= g_high;
    let falling = g_high <= S::ZERO && S::ZERO <= g_low;
    if !(rising || falling) {
        return Err(RootFault::NotBracketed);
    }
    for turn in 0..MAX_EVALUATIONS {
        let middle = low + half * (high - low);
        if high - low <= width || !(low < middle && middle < high) {
            break;
        }
        let secant = low - g_low * ((high - low) / (g_high - g_low));
        let inside = low < secant && secant < high;
        let t = if turn % 3 == 2 || !inside { middle } else { secant };
        let value = g(t);
        if !value.is_finite() {
            return Err(RootFault::NonFinite);
        }
        // The end that stays is halved, so that it moves next time.
        if (value <= S::ZERO) == rising {
            (low, g_low, g_high) = (t, value, g_high * half);
        } else {
            (high, g_high, g_low) = (t, value, g_low * half);
        }
    }
    Ok((low, high))
}
