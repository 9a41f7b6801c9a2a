//! Instructions and code size of a function without loops, including all functions that it calls.

use super::Image;
use crate::firmware::thumb::Kind;

/// Code size of these functions and of all that they call, each counted once (bytes).
#[must_use]
pub fn bytes(image: &Image, functions: &[usize]) -> u32 {
    let mut called = functions.to_vec();
    let mut next = 0;
    while let Some(&function) = called.get(next) {
        next += 1;
        for (_, kind) in &image.functions[function].effects {
            if let Kind::Call(target) | Kind::Jump(target) = kind
                && let Some(callee) = image.owner(*target)
                && !called.contains(&callee)
            {
                called.push(callee);
            }
        }
    }
    called.iter().map(|&f| image.functions[f].end - image.functions[f].address).sum()
}

/// Number of instructions of a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Instructions {
    /// Instructions of the function and of all calls in it, each in the order of the text.
    pub count: u64,
    /// Is there a jump backwards, a jump through a register, or recursion? Such code is counted only once.
    pub has_loops: bool,
}

/// Instructions of a call, including those between a jump and its target: exact for straight-line code.
#[must_use]
pub fn instructions(image: &Image, function: usize) -> Instructions {
    executed(image, function, &mut vec![None; image.functions.len()])
}

fn executed(image: &Image, function: usize, known: &mut [Option<Instructions>]) -> Instructions {
    if let Some(count) = known[function] {
        return count;
    }
    // While it is being counted: a call of it from inside is recursion.
    known[function] = Some(Instructions { count: 0, has_loops: true });
    let this = &image.functions[function];
    let mut sum = Instructions { count: this.instructions, has_loops: false };
    for (address, kind) in &this.effects {
        match *kind {
            Kind::Jump(target) if image.owner(target) == Some(function) => {
                sum.has_loops |= target <= *address
            }
            Kind::Call(target) | Kind::Jump(target) => match image.owner(target) {
                Some(callee) => {
                    let below = executed(image, callee, known);
                    sum.count += below.count;
                    sum.has_loops |= below.has_loops;
                }
                None => sum.has_loops = true,
            },
            Kind::IndirectCall | Kind::IndirectJump => sum.has_loops = true,
            _ => {}
        }
    }
    known[function] = Some(sum);
    sum
}

#[cfg(test)]
mod tests {
    use super::super::tests::image;
    use super::{Instructions, bytes, instructions};

    #[test]
    fn what_is_called_executes_at_every_call_and_lies_there_once() {
        // twice: bl leaf, bl leaf, bx lr; leaf: nop, bx lr.
        let image = image(&[
            ("twice", &[0xF000, 0xF803, 0xF000, 0xF801, 0x4770]),
            ("leaf", &[0xBF00, 0x4770]),
            ("other", &[0x4770]),
        ]);
        let straight = |count| Instructions { count, has_loops: false };
        assert_eq!((instructions(&image, 0), bytes(&image, &[0])), (straight(3 + 2 + 2), 10 + 4));
        assert_eq!((instructions(&image, 1), bytes(&image, &[1])), (straight(2), 4));
    }

    #[test]
    fn a_loop_and_a_recursion_are_told() {
        // b .-2 jumps back to the nop before it; bl .-4 calls the function itself.
        let image = image(&[("around", &[0xBF00, 0xE7FD, 0x4770]), ("itself", &[0xF7FF, 0xFFFE, 0x4770])]);
        assert_eq!(instructions(&image, 0), Instructions { count: 3, has_loops: true });
        assert_eq!(instructions(&image, 1), Instructions { count: 2, has_loops: true });
    }
}
