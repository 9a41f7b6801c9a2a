//! Command lines: most with options and values where they belong, some of words in any order.

use crate::random::Random;

const MODELS: [&str; 7] =
    ["pendulum", "cart_pole", "slider_crank", "slider_crank_closed", "sleigh", "nobody", "pendulun"];

/// Words that mean something somewhere. None asks for a compiler, for the chip or for hours.
const WORDS: [&str; 43] = [
    "run",
    "eval",
    "derive",
    "check",
    "pendulum",
    "slider_crank",
    "nobody",
    "--seconds",
    "0.01",
    "0",
    "-1",
    "1e308",
    "nan",
    "--step",
    "1e-3",
    "--every",
    "--set",
    "q=1",
    "m=0",
    "l=-3",
    "g=1e200",
    "m=",
    "=",
    "--method",
    "rk4",
    "euler",
    "dormand-prince",
    "-",
    "--error",
    "1e-9",
    "--scalar",
    "f32",
    "f64",
    "--json",
    "--form",
    "minimal",
    "kinematic",
    "--answers",
    "rates,,",
    "--engine",
    "--keep",
    "--",
    "",
];

/// A command line without the program's name; `folder` is where files may go.
pub fn line(random: &mut Random, folder: &str) -> Vec<String> {
    let mut line: Vec<String> = Vec::new();
    if random.one_in(8) {
        for _ in 0..random.below(6) {
            line.push(random.of(&WORDS).to_owned());
        }
        return line;
    }
    let command = random.of(&["run", "run", "derive", "check"]);
    line.push(command.to_owned());
    line.push((if random.one_in(6) { random.of(&MODELS) } else { random.of(&MODELS[..5]) }).to_owned());
    let put = |name: &str, value: String| format!("--{name}={value}");
    if command == "run" {
        let seconds = random.of(&["0.01", "0.01", "0.01", "0.02", "0", "-1", "nan", "1e308"]);
        line.push(put("seconds", seconds.to_owned()));
    }
    for _ in 0..random.below(4) {
        let word = match (command, random.below(10)) {
            (_, 0) => random.of(&WORDS).to_owned(),
            (_, 1) => "--json".to_owned(),
            ("run", 2) => {
                put("step", random.of(&["1e-3", "5e-4", "1e-2", "0", "1e-300", "inf", "x"]).to_owned())
            }
            ("run", 3) => put(
                "method",
                random.of(&["rk4", "euler", "semi-implicit", "dormand-prince", "rk"]).to_owned(),
            ),
            ("run", 4) => {
                put("every", random.of(&["1", "3", "1000000", "0", "-2", "18446744073709551615"]).to_owned())
            }
            ("run", 5) => put("csv", random.of(&["/dev/null", "/nowhere/at/all.csv"]).to_owned()),
            ("run", 6) => {
                put("plot", format!("{folder}/fuzz.{}", random.of(&["svg", "svg", "png", "pdf", ""])))
            }
            ("run", 7) => put("view", format!("{folder}/fuzz.html")),
            ("run", 8) => put("scalar", random.of(&["f32", "f64", "f16"]).to_owned()),
            ("derive", 2) => {
                put("form", random.of(&["reduced", "minimal", "augmented", "kinematic", "dual"]).to_owned())
            }
            ("derive", 3) => put("scalar", random.of(&["f32", "f64", "f32x8", "f64x4", ""]).to_owned()),
            ("derive", 4) => {
                put("answers", random.of(&["rates", "energy,speeds", "outputs", ",", "all"]).to_owned())
            }
            ("derive", 5) => put("keep", random.of(&["m", "l,g", "nobody"]).to_owned()),
            ("derive", 6) => put("crate", format!("{folder}/fuzz_crate")),
            ("run" | "derive", _) => {
                let name = random.of(&["m", "l", "g", "r", "q", "u_q", "x", "nobody", ""]);
                let value = random.of(&["1", "0", "-3", "0.2", "1e200", "1e-200", "nan", "", "="]);
                put("set", format!("{name}={value}"))
            }
            _ => put("states", format!("{folder}/fuzz.json")),
        };
        line.push(word);
    }
    line
}
