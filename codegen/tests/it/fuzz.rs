//! Random models through the parser and the derivation: no panic, no case over a second.
//!
//! Three kinds of texts: models grown from the grammar, most of which are valid; shipped models with
//! pieces exchanged; expressions of arbitrary tokens. The seed is fixed, so that case n is always the
//! same text: `SMARTBED_FUZZ_CASES=1000000 cargo test -p smartbed-codegen --test it fuzz`, and
//! `SMARTBED_FUZZ_FIRST=n SMARTBED_FUZZ_CASES=1` for case n alone.

use smartbed_codegen::{ParameterChoice, model, program};
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// Cases if the environment does not say.
const CASES: u64 = 2_000;
/// A case that takes longer hangs.
const LIMIT: Duration = Duration::from_secs(1);

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
    fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }
    fn of<'a>(&mut self, items: &[&'a str]) -> &'a str {
        items[self.below(items.len())]
    }
}

/// A dimensionless scalar of what a model of `n` coordinates has before place `i`.
fn scalar(random: &mut Random, n: usize, depth: usize) -> String {
    if depth == 0 || random.one_in(3) {
        return match random.below(6) {
            0 => format!("{}", random.below(20) as f64 / 8.0),
            1 => "k".to_owned(),
            2 => "pi".to_owned(),
            _ => format!("q{}", random.below(n)),
        };
    }
    let part = |random: &mut Random| scalar(random, n, depth - 1);
    match random.below(9) {
        0 => format!("({} + {})", part(random), part(random)),
        1 => format!("({} - {})", part(random), part(random)),
        2 => format!("{}*{}", part(random), part(random)),
        3 => format!("({})/(2 + sin({}))", part(random), part(random)),
        4 => format!("sin({})", part(random)),
        5 => format!("cos({})", part(random)),
        6 => format!("({}).powi({})", part(random), random.below(4)),
        7 => format!(
            "{}({})",
            random.of(&["tanh", "abs", "exp", "sqrt", "acos", "ln", "-", "sign"]),
            part(random)
        ),
        _ => format!(
            "{}({}, {})",
            random.of(&["min", "max", "atan2", "smooth_step"]),
            part(random),
            part(random)
        ),
    }
}

/// A model of a few bodies whose places and loads are random expressions.
fn grown(random: &mut Random) -> String {
    let n = 1 + random.below(3);
    let mut text = String::from(
        "format = 1\nname = \"grown\"\ngravity = \"-g*N.z\"\n[parameters]\ng = { value = 9.81, unit = \"m/s^2\" }\nm = { value = 1.5, unit = \"kg\" }\nI = { value = 0.1, unit = \"kg m^2\" }\nl = { value = 0.4, unit = \"m\" }\nf = { value = 2, unit = \"N\" }\nk = 0.7\n[inputs]\nT = { unit = \"N m\" }\n[coordinates]\n",
    );
    let constrained = 1 < n && random.one_in(3);
    for i in 0..n {
        let free = !constrained || i == 0;
        let _ = match random.below(8) {
            0 if 0 < i => writeln!(text, "q{i} = {{ closed_form = \"{}\" }}", scalar(random, i, 2)),
            _ => writeln!(text, "q{i} = {{ independent = {free}, range = [-1, 1] }}"),
        };
    }
    text.push_str("[definitions]\n");
    let _ = writeln!(text, "d0 = \"{}\"", scalar(random, n, 3));
    text.push_str("[frames]\n");
    for i in 0..n {
        let parent = if i == 0 || random.one_in(2) { "N".to_owned() } else { format!("f{}", i - 1) };
        let (axis, angle) = (
            random.of(&["x", "y", "z"]),
            if random.one_in(4) { scalar(random, n, 2) } else { format!("q{i}") },
        );
        let _ = writeln!(text, "f{i} = {{ parent = \"{parent}\", rotations = [[\"{axis}\", \"{angle}\"]] }}");
    }
    text.push_str("[points]\n");
    for i in 0..n {
        let before = if i == 0 { "O".to_owned() } else { format!("P{}", i - 1) };
        let factor = if random.one_in(2) { "1".to_owned() } else { scalar(random, n, 2) };
        let _ = writeln!(text, "P{i} = \"{before} + l*({factor})*f{i}.{}\"", random.of(&["x", "y", "z"]));
    }
    text.push_str("[bodies]\n");
    for i in 0..n {
        let inertia =
            if random.one_in(3) { "" } else { ", inertia = { Ixx = \"I\", Iyy = \"I\", Izz = \"2*I\" }" };
        let frame = if inertia.is_empty() { String::new() } else { format!(", frame = \"f{i}\"") };
        let _ = writeln!(text, "b{i} = {{ centre = \"P{i}\", mass = \"m\"{frame}{inertia} }}");
    }
    if constrained {
        let _ = writeln!(text, "[constraints.configuration]\nc = \"{}\"", scalar(random, n, 2));
    }
    let _ =
        writeln!(text, "[forces]\npush = {{ point = \"P0\", force = \"f*({})*N.x\" }}", scalar(random, n, 3));
    let _ = writeln!(text, "[outputs]\ny = \"{} + d0\"\nv = \"norm(velocity(P0))\"", scalar(random, n, 3));
    text
}

/// Pieces that mean something somewhere.
const PIECES: [&str; 40] = [
    "\"",
    "{",
    "}",
    "[",
    "]",
    "=",
    "(",
    ")",
    ",",
    ".",
    "*",
    "/",
    "+",
    "-",
    "\n",
    "#",
    "0",
    "1e308",
    "-1",
    "1_m",
    "q",
    "u_q",
    "N.x",
    "rod",
    "dot(",
    "cross(",
    "velocity(O)",
    "sqrt(",
    "powi(9)",
    "[points]\n",
    "[speeds]\n",
    "[frames]\n",
    "speed = false",
    "independent = true",
    "closed_form = \"q\"",
    "q_dot(q)",
    "unit = \"m\"",
    "nan",
    "{leg}",
    "é",
];

/// A known text with pieces cut, doubled and put in.
fn mutated(random: &mut Random, texts: &[String]) -> String {
    let mut text = texts[random.below(texts.len())].clone();
    for _ in 0..=random.below(3) {
        let boundary = |text: &str, mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let from = boundary(&text, random.below(text.len() + 1));
        let to = boundary(&text, (from + random.below(12)).min(text.len()));
        match random.below(4) {
            0 => text.replace_range(from..to, ""),
            1 => text.insert_str(from, random.of(&PIECES)),
            2 => text.replace_range(from..to, random.of(&PIECES)),
            _ => {
                let doubled = text[from..to].to_owned();
                text.insert_str(to, &doubled);
            }
        }
    }
    text
}

/// A valid model but for an expression of arbitrary tokens.
fn garbled(random: &mut Random) -> String {
    let mut expression = String::new();
    for _ in 0..random.below(30) {
        expression.push_str(random.of(&PIECES[6..26]).trim_matches(['"', '\n']));
    }
    let nested = "(".repeat(random.below(300));
    format!(
        "format = 1\nname = \"g\"\n[parameters]\nm = {{ value = 1, unit = \"kg\" }}\n[coordinates]\nq = {{ unit = \"m\" }}\n[frames]\nrod = {{ parent = \"N\", rotations = [[\"z\", \"0.1\"]] }}\n[points]\nP = \"q*N.x\"\n[bodies]\nb = {{ centre = \"P\", mass = \"m\" }}\n[outputs]\ny = \"{nested}{}\"\n",
        expression.replace('\n', " ")
    )
}

/// Texts to start from: small, so that a case takes about a millisecond.
fn texts() -> Vec<String> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    ["pendulum", "cart_pole", "slider_crank", "slider_crank_closed", "sleigh", "double_pendulum", "gyroscope"]
        .iter()
        .map(|name| std::fs::read_to_string(folder.join(format!("{name}.toml"))).expect("readable"))
        .collect()
}

#[test]
fn random_models_neither_panic_nor_hang() {
    let number = |name: &str| std::env::var(name).ok().and_then(|n| n.parse::<u64>().ok());
    let cases = number("SMARTBED_FUZZ_CASES").unwrap_or(CASES);
    let first = number("SMARTBED_FUZZ_FIRST").unwrap_or(0);
    let texts = texts();
    let (mut parsed, mut derived, mut slowest) = (0_u64, 0_u64, Duration::ZERO);
    for case in first..first + cases {
        let mut random = Random(case.wrapping_mul(0x2545_F491_4F6C_DD1D) ^ 0xF022);
        let text = match random.below(10) {
            0..=3 => grown(&mut random),
            4..=7 => mutated(&mut random, &texts),
            _ => garbled(&mut random),
        };
        let start = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| match model::parse("fuzz.toml", &text) {
            Err(found) => {
                (false, false, found.has_errors() && found.items.iter().all(|d| !d.message.is_empty()))
            }
            Ok(model) => match program::derive(&model, &ParameterChoice::default()) {
                Err(found) => (true, false, found.has_errors()),
                Ok(program) => (true, true, !program.rates.u_dot.is_empty() || program.u.is_empty()),
            },
        }));
        let took = start.elapsed();
        let (p, d, sound) = outcome.unwrap_or_else(|_| panic!("case {case} panics:\n{text}"));
        assert!(sound, "case {case}: neither a program nor an error:\n{text}");
        assert!(took < LIMIT, "case {case} takes {took:?}:\n{text}");
        parsed += u64::from(p);
        derived += u64::from(d);
        slowest = slowest.max(took);
        if case % 20_000 == 19_999 {
            println!("up to case {}: {parsed} parsed, {derived} derived, slowest {slowest:?}", case + 1);
        }
    }
    println!("{cases} cases, {parsed} parsed, {derived} derived, slowest {slowest:?}");
    // A share means something for many cases only.
    if CASES <= cases {
        assert!(cases <= 5 * parsed, "only {parsed} of {cases} pass the parser");
        assert!(0 < derived);
    }
}
