//! The rules of an image, each with its reason. One broken rule fails the build.

use super::Image;
use super::stack::{self, Stack};
use crate::firmware::chip::Chip;
use crate::firmware::thumb::Kind;
use std::fmt;

/// A rule of the image.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Rule {
    /// The program fits into flash.
    Flash,
    /// Static data and stack fit into RAM.
    Ram,
    /// The stack is bounded.
    Stack,
    /// No recursion.
    Recursion,
    /// No calls through registers.
    Indirect,
    /// No panics.
    Panic,
    /// No formatting code.
    Format,
    /// No heap allocation.
    Heap,
    /// No arithmetic in double precision.
    Double,
    /// No instruction that the chip's floating-point unit lacks.
    Unit,
    /// No fused multiply-add.
    Fused,
}

impl Rule {
    /// All rules, in the order in which they are reported.
    pub const ALL: [Self; 11] = [
        Self::Flash,
        Self::Ram,
        Self::Stack,
        Self::Recursion,
        Self::Indirect,
        Self::Panic,
        Self::Format,
        Self::Heap,
        Self::Double,
        Self::Unit,
        Self::Fused,
    ];

    /// Short name, for reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flash => "flash",
            Self::Ram => "ram",
            Self::Stack => "stack bound",
            Self::Recursion => "no recursion",
            Self::Indirect => "no indirect call",
            Self::Panic => "no panic",
            Self::Format => "no core::fmt",
            Self::Heap => "no heap",
            Self::Double => "no double precision",
            Self::Unit => "only FPv4-SP",
            Self::Fused => "no fused multiply-add",
        }
    }

    /// The reason for the rule, and what to do.
    #[must_use]
    pub fn reason(self) -> &'static str {
        match self {
            Self::Flash => "the chip's flash is smaller than the image",
            Self::Ram => "static data and the stack bound together exceed the chip's RAM",
            Self::Stack => "a frame of variable size, or a call of code without a symbol, has no bound",
            Self::Recursion => "a function that calls itself has no stack bound",
            Self::Indirect => {
                "a call through a register hides its callee from the stack bound: avoid dyn and fn pointers"
            }
            Self::Panic => {
                "code that can panic is linked in: index with get or iterators, do not unwrap, avoid % on floats"
            }
            Self::Format => "formatting brings kilobytes and indirect calls: write bytes instead",
            Self::Heap => "the controller must not allocate",
            Self::Double => {
                "the core computes double precision in software, 100 instructions each: look for an f64 literal or libm's f32 trigonometry"
            }
            Self::Unit => {
                "the instruction is undefined on the core: build with its target-cpu, cortex-m4 for a Cortex-M4F"
            }
            Self::Fused => {
                "it rounds once where the host rounds twice, so host and chip would differ: do not use mul_add"
            }
        }
    }
}

/// A broken rule and its place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Finding {
    /// The rule.
    pub rule: Rule,
    /// The symbol, or the number, that breaks it.
    pub what: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} ({})", self.rule.name(), self.what, self.rule.reason())
    }
}

/// Every broken rule, in the order of [`Rule::ALL`].
#[must_use]
pub fn findings(image: &Image, stack: &Stack, chip: &Chip) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut add = |rule, what| found.push(Finding { rule, what });
    if image.size.flash > chip.flash {
        add(Rule::Flash, format!("{} bytes of {}", image.size.flash, chip.flash));
    }
    let ram = image.size.ram + u64::from(stack.bytes);
    if ram > chip.ram {
        add(Rule::Ram, format!("{ram} bytes of {}", chip.ram));
    }
    for name in &stack.recursive {
        add(Rule::Recursion, name.clone());
    }
    for symbol in &image.symbols {
        if let Some(rule) = forbidden(symbol).filter(|rule| binds(*rule, chip)) {
            add(rule, format!("symbol `{symbol}`{}", callers(image, symbol)));
        }
    }
    for function in &image.functions {
        for (address, kind) in &function.effects {
            if let Some(rule) = hazard(image, *kind).filter(|rule| binds(*rule, chip)) {
                add(rule, format!("`{}` at {address:#010x}", function.name));
            }
        }
    }
    found.sort_by(|a, b| (a.rule, &a.what).cmp(&(b.rule, &b.what)));
    found
}

/// The callers of the function of that name, for a message.
fn callers(image: &Image, name: &str) -> String {
    let Some(callee) = image.find(name) else { return String::new() };
    let calls = |f: &usize| *f != callee && stack::callees(image, *f).contains(&callee);
    let names: Vec<String> =
        (0..image.functions.len()).filter(calls).map(|f| format!("`{}`", image.functions[f].name)).collect();
    if names.is_empty() { String::new() } else { format!(" called by {}", names.join(", ")) }
}

/// Does the rule apply to this chip?
fn binds(rule: Rule, chip: &Chip) -> bool {
    match rule {
        Rule::Double => !chip.has_double,
        Rule::Unit => !chip.has_fpv5,
        _ => true,
    }
}

/// The rule that an instruction breaks.
fn hazard(image: &Image, kind: Kind) -> Option<Rule> {
    match kind {
        Kind::VariableStack => Some(Rule::Stack),
        Kind::IndirectCall | Kind::IndirectJump => Some(Rule::Indirect),
        Kind::Double => Some(Rule::Double),
        Kind::Fpv5 => Some(Rule::Unit),
        Kind::Fused => Some(Rule::Fused),
        Kind::Call(target) | Kind::Jump(target) if image.owner(target).is_none() => Some(Rule::Stack),
        Kind::Stack(_) | Kind::Call(_) | Kind::Jump(_) | Kind::Constant | Kind::Other => None,
    }
}

/// The rule that a symbol of this readable name breaks.
fn forbidden(symbol: &str) -> Option<Rule> {
    const PANIC: [&str; 9] = [
        "core::panicking",
        "core::option::unwrap_failed",
        "core::option::expect_failed",
        "core::result::unwrap_failed",
        "slice_index_fail",
        "slice_start_index",
        "slice_end_index",
        "len_mismatch_fail",
        "rust_begin_unwind",
    ];
    const HEAP: [&str; 8] =
        ["__rust_alloc", "__rdl_", "__rg_", "__rustc::__rust", "alloc::", "malloc", "realloc", "_sbrk"];
    if PANIC.iter().any(|p| symbol.contains(p)) {
        return Some(Rule::Panic);
    }
    if symbol.contains("core::fmt") {
        return Some(Rule::Format);
    }
    if HEAP.iter().any(|h| symbol.starts_with(h)) || symbol.contains("<alloc::") {
        return Some(Rule::Heap);
    }
    is_double_routine(symbol).then_some(Rule::Double)
}

/// Run-time routines of double precision, by the names of the ARM ABI (`__aeabi_dadd`,
/// `__aeabi_cdcmple`, `__aeabi_f2d`) and of libgcc (`__muldf3`, `__floatsidf`).
fn is_double_routine(symbol: &str) -> bool {
    let name = symbol.rsplit("::").next().unwrap_or(symbol);
    match name.strip_prefix("__aeabi_") {
        Some(routine) => routine.starts_with('d') || routine.starts_with("cd") || routine.ends_with("2d"),
        None => name.starts_with("__") && name.contains("df"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::image;
    use super::*;
    use crate::firmware::chip::{M7, M33, STM32F405};

    fn rules(functions: &[(&str, &[u16])]) -> Vec<Rule> {
        findings(&image(functions), &Stack::default(), &STM32F405).into_iter().map(|f| f.rule).collect()
    }

    #[test]
    fn symbols() {
        let bad = [
            ("core::panicking::panic_bounds_check", Rule::Panic),
            ("core::panicking::panic_const::panic_const_rem_by_zero", Rule::Panic),
            ("core::option::unwrap_failed", Rule::Panic),
            ("rust_begin_unwind", Rule::Panic),
            ("core::fmt::Formatter::pad", Rule::Format),
            ("<core::fmt::Arguments>::as_str", Rule::Format),
            ("__rust_alloc", Rule::Heap),
            ("alloc::raw_vec::finish_grow", Rule::Heap),
            ("__aeabi_dmul", Rule::Double),
            ("__aeabi_cdcmple", Rule::Double),
            ("__aeabi_f2d", Rule::Double),
            ("__aeabi_ui2d", Rule::Double),
            ("__muldf3", Rule::Double),
            ("__extendsfdf2", Rule::Double),
            ("__fixdfsi", Rule::Double),
            ("__floatsidf", Rule::Double),
            ("compiler_builtins::float::mul::__muldf3", Rule::Double),
        ];
        for (symbol, rule) in bad {
            assert_eq!(forbidden(symbol), Some(rule), "{symbol}");
        }
        for symbol in ["main", "tile_step", "__aeabi_memcpy", "__aeabi_uldivmod", "__aeabi_idiv", "HardFault"]
        {
            assert_eq!(forbidden(symbol), None, "{symbol}");
        }
    }

    #[test]
    fn instructions() {
        assert_eq!(rules(&[("f", &[0xEE30, 0x0B01])]), [Rule::Double]);
        assert_eq!(rules(&[("f", &[0x4798])]), [Rule::Indirect]);
        assert_eq!(rules(&[("f", &[0xEEA0, 0x0A81])]), [Rule::Fused]);
        assert_eq!(rules(&[("f", &[0x46A5])]), [Rule::Stack]);
        assert_eq!(rules(&[("f", &[0xFE80, 0x0A00])]), [Rule::Unit]);
        assert_eq!(rules(&[("f", &[0xE7F0])]), [Rule::Stack], "a jump to nowhere");
        assert_eq!(rules(&[("f", &[0xB510, 0xBD10])]), []);
    }

    #[test]
    fn cores_differ_in_their_units() {
        let image = image(&[("double", &[0xEE30, 0x0B01]), ("fpv5", &[0xFE80, 0x0A00])]);
        let rules =
            |chip| findings(&image, &Stack::default(), chip).into_iter().map(|f| f.rule).collect::<Vec<_>>();
        assert_eq!(rules(&STM32F405), [Rule::Double, Rule::Unit]);
        assert_eq!(rules(&M33), [Rule::Double]);
        assert_eq!(rules(&M7), []);
    }

    #[test]
    fn memory() {
        let mut full = image(&[]);
        full.size.flash = STM32F405.flash + 1;
        full.size.ram = STM32F405.ram;
        let stack = Stack { bytes: 1, ..Stack::default() };
        let found = findings(&full, &stack, &STM32F405);
        assert_eq!(found.iter().map(|f| f.rule).collect::<Vec<_>>(), [Rule::Flash, Rule::Ram]);
    }
}
