//! Upper bound of the stack depth, along the graph of direct calls.
//!
//! Bound = deepest path from the reset handler + for each priority one exception: its hardware frame
//! ([`EXCEPTION_FRAME`]) and the deepest path from a handler of that priority. All exceptions and interrupts with a
//! configurable priority have the same one, so that they never interrupt each other; a hard fault interrupts them, and
//! the non-maskable interrupt interrupts that. A function's frame is the sum of all its instructions that lower sp,
//! which is never less than what it uses. Recursion and calls through registers have no bound; they are reported, never
//! ignored.

use super::Image;
use crate::firmware::thumb::Kind;
use std::collections::BTreeSet;

/// Bytes that an exception pushes with floating-point state, including one word for alignment.
pub const EXCEPTION_FRAME: u32 = 4 * (26 + 1);

/// Entry of a program without vectors.
const ENTRY: &str = "_start";

/// The bound and its deepest path.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct Stack {
    /// Bound (bytes).
    pub bytes: u32,
    /// Functions along the deepest path with their frames (bytes), from the reset handler on.
    pub path: Vec<(String, u32)>,
    /// Functions that call themselves, directly or indirectly.
    pub recursive: BTreeSet<String>,
}

impl Image {
    /// The stack bound from the vector table's reset handler and its other handlers. For a program without a vector
    /// table, which no board starts, from its entry, without exceptions.
    ///
    /// # Errors
    /// A message if there is no vector table, or an entry of it is not a function.
    pub fn stack(&self) -> Result<Stack, String> {
        let functions: Option<Vec<usize>> = self.vectors.iter().map(|v| self.owner(*v)).collect();
        match functions.as_deref() {
            Some([entry, unmaskable, fault, others @ ..]) => {
                Ok(bound(self, *entry, &[others, &[*fault], &[*unmaskable]]))
            }
            _ => match self.find(ENTRY).filter(|_| self.vectors.is_empty()) {
                Some(entry) => Ok(bound(self, entry, &[])),
                None => Err("the image has no vector table of known functions".to_owned()),
            },
        }
    }
}

/// Sum of the bytes by which a function lowers sp.
#[must_use]
pub fn frame(image: &Image, function: usize) -> u32 {
    image.functions[function]
        .effects
        .iter()
        .map(|(_, kind)| if let Kind::Stack(bytes) = kind { *bytes } else { 0 })
        .sum()
}

/// Functions that a function calls or jumps to.
#[must_use]
pub fn callees(image: &Image, function: usize) -> BTreeSet<usize> {
    let effects = image.functions[function].effects.iter();
    effects
        .filter_map(|(_, kind)| match *kind {
            Kind::Call(target) => image.owner(target),
            Kind::Jump(target) => image.owner(target).filter(|f| *f != function),
            _ => None,
        })
        .collect()
}

/// The bound for an image with this entry and with handlers of these priorities.
#[must_use]
pub fn bound(image: &Image, entry: usize, priorities: &[&[usize]]) -> Stack {
    let mut walk = Walk { image, memo: vec![None; image.functions.len()], stack: Stack::default() };
    let (depth, path) = walk.deepest(entry, &mut Vec::new());
    walk.stack.bytes = depth;
    for handlers in priorities.iter().filter(|handlers| !handlers.is_empty()) {
        let deepest = handlers.iter().map(|h| walk.deepest(*h, &mut Vec::new()).0).max();
        walk.stack.bytes += EXCEPTION_FRAME + deepest.unwrap_or(0);
    }
    walk.stack.path = path.iter().map(|f| (image.functions[*f].name.clone(), frame(image, *f))).collect();
    walk.stack
}

struct Walk<'a> {
    image: &'a Image,
    memo: Vec<Option<(u32, Vec<usize>)>>,
    stack: Stack,
}

impl Walk<'_> {
    /// Depth and path from `function`; `open` are the functions on the path to it.
    fn deepest(&mut self, function: usize, open: &mut Vec<usize>) -> (u32, Vec<usize>) {
        if let Some(known) = &self.memo[function] {
            return known.clone();
        }
        if open.contains(&function) {
            self.stack.recursive.insert(self.image.functions[function].name.clone());
            return (0, Vec::new());
        }
        open.push(function);
        let mut worst = (0, Vec::new());
        for callee in callees(self.image, function) {
            let below = self.deepest(callee, open);
            if below.0 > worst.0 || worst.1.is_empty() {
                worst = below;
            }
        }
        open.pop();
        worst.0 += frame(self.image, function);
        worst.1.insert(0, function);
        self.memo[function] = Some(worst.clone());
        worst
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::image;
    use super::{EXCEPTION_FRAME, bound};

    const RETURN: u16 = 0xBD10; // pop {r4, pc}
    const PUSH_2: u16 = 0xB510; // push {r4, lr}

    #[test]
    fn deepest_path_with_an_exception_of_each_priority() {
        // main: push, bl a (+2 instructions on), bl b, return; a: 8 bytes; b: 8 + 16 bytes.
        let main = [PUSH_2, 0xF000, 0xF803, 0xF000, 0xF803, RETURN];
        let a = [PUSH_2, RETURN];
        let b = [PUSH_2, 0xB084, 0xB004, RETURN];
        let image = image(&[("main", &main), ("a", &a), ("b", &b), ("fault", &[PUSH_2, 0xE7FE])]);
        let stack = bound(&image, 0, &[&[3]]);
        assert_eq!(stack.path, [("main".to_owned(), 8), ("b".to_owned(), 24)]);
        assert_eq!(stack.bytes, 8 + 24 + EXCEPTION_FRAME + 8);
        let stack = bound(&image, 0, &[&[3], &[1, 2], &[]]);
        assert_eq!(stack.bytes, 8 + 24 + EXCEPTION_FRAME + 8 + EXCEPTION_FRAME + 24);
        assert!(stack.recursive.is_empty());
    }

    #[test]
    fn recursion_is_reported() {
        // a: push, bl b, return; b: push, bl a, return.
        let a = [PUSH_2, 0xF000, 0xF801, RETURN];
        let b = [PUSH_2, 0xF7FF, 0xFFF9, RETURN];
        let image = image(&[("a", &a), ("b", &b)]);
        assert_eq!(bound(&image, 0, &[]).recursive.into_iter().collect::<Vec<_>>(), ["a"]);
    }

    #[test]
    fn a_tail_call_counts() {
        let a = [PUSH_2, 0xE7FF]; // b .+2: the first instruction after it
        let b = [0xB084, RETURN];
        let image = image(&[("a", &a), ("b", &b)]);
        assert_eq!(bound(&image, 0, &[]).bytes, 8 + 16);
    }
}
