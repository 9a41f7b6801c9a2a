//! Texts of models: grown from the grammar, most of them valid; shipped ones with pieces exchanged;
//! valid ones but for an expression of arbitrary tokens.

use crate::random::Random;
use std::fmt::Write as _;

/// A text of any of the three kinds.
pub fn text(random: &mut Random, shipped: &[String]) -> String {
    match random.below(10) {
        0..=3 => grown(random),
        4..=7 => mutated(random, shipped),
        _ => garbled(random),
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
    // Few bodies: a case should take a millisecond, most of which goes into the derivation.
    let n = [1, 1, 1, 2, 2, 3][random.below(6)];
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
    if random.one_in(6) {
        let _ = writeln!(text, "[constraints.motion]\nroll = \"{}*u_q0\"", scalar(random, n, 1));
    }
    if random.one_in(3) {
        let _ = writeln!(
            text,
            "[springs]\nleg = {{ between = [\"O\", \"P{}\"], stiffness = \"f/l*({})\", rest_length = 0.3 }}",
            n - 1,
            scalar(random, n, 1)
        );
    }
    if random.one_in(3) {
        let _ = writeln!(
            text,
            "[start]\nq0 = {}\nu_q{} = \"{}\"",
            random.below(9),
            random.below(n),
            scalar(random, 1, 1)
        );
    }
    if random.one_in(4) {
        let _ = writeln!(text, "[law]\nT = \"({})*1_N*l\"", scalar(random, n, 2));
    }
    if random.one_in(6) {
        let _ = writeln!(text, "[[configurations]]\nvalues = {{ q0 = {} }}", random.below(5));
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

/// Texts to start from: small ones.
pub fn shipped() -> Vec<String> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    ["pendulum", "cart_pole", "slider_crank", "slider_crank_closed", "sleigh", "double_pendulum", "gyroscope"]
        .iter()
        .map(|name| std::fs::read_to_string(folder.join(format!("{name}.toml"))).expect("readable"))
        .collect()
}
