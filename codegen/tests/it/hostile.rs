//! Models whose names, descriptions and file names try to inject code: none of it becomes code, and accepted
//! models compile in every form and scalar.
//!
//! One compiler run checks all of them as modules of one crate. An environment variable sets their number:
//! `SMARTBED_HOSTILE=1000 cargo test -p smartbed-codegen --test it -- hostile`

use smartbed_codegen::model::{self, Model};
use smartbed_codegen::program::{derive_asked, derive_kinematic};
use smartbed_codegen::{
    Asked, Core, Effort, EmitOptions, Function, ParameterChoice, Program, ScalarType, rust,
};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// Models of an ordinary run.
const MODELS: u64 = 60;

/// Names that the emitted file has itself, that it or the prelude reads, that look like those it makes up, that
/// differ by case or by an underscore from another, that Rust gives a meaning in some places.
const NAMES: &str = "\
    NQ NU N_INPUTS CORRECTED NOMINAL IS_ANGLE Q_NAMES OUTPUT_NAMES UNKNOWN_NAMES Ok Err Some None Option \
    Result Default default S S_ S_2 s Real Real_ real Parameters parameters Prepared prepared prepared_a \
    Mechanism mechanism Self_ self_ p q u inputs p_2 q_2 _p _q _u t1 t2 t3 t2_2 t01 t0 k0 k1 angle1 sin_q \
    cos_q sin_a cos_a x__ __ ___ _1 a A a_ A_ a_2 aB ab AB union raw auto gen gen_ safe macro_rules core std \
    alloc crate_ usize f64 f32 bool str rates energy speeds outputs projection augmented prepare place index \
    value pivot correction residual Clone clone Copy Debug copy drop vec Vec string String box_ TryFrom \
    try_from iterator Iterator main print x y z xyz N_ O_ ok some err option result fault Fault model test \
    libm wide dyn_ type_ r_type u_q u_a I l";

/// Pieces of descriptions and file names that stop the compiler if they become code.
const TEXTS: &[&str] = &[
    "\n",
    "\r",
    "\r\n",
    "\ncompile_error!(\"a text became code\");\n",
    "\rcompile_error!(\"a text became code\");\r",
    "\u{2028}compile_error!(\"a text became code\");\u{2029}",
    "*/ compile_error!(\"a text became code\"); /*",
    "\"]; compile_error!(\"a text became code\"); //",
    "\n```\ncompile_error!(\"a text became code\");\n```\n",
    "\n~~~rust\npanic!()\n~~~\n",
    "\n    indented();\n",
    "\t\tindented();\n\n\n",
    "- 1.     deep",
    "\u{202e}",
    "\u{2066}\u{2069}",
    "\u{200b}\u{feff}",
    "\0",
    "\u{1b}[2J",
    "e\u{301}",
    "é",
    "\\",
    "\\\\",
    "\\u{22}",
    "`",
    "``",
    "[`Real`]",
    "[m]",
    "<script>",
    "$name $runtime $getters",
    "{}",
    "{0}",
    "#![no_std]",
    "#[derive(Debug)]",
    "/",
    "//",
    "/// ",
    "!",
    "! inner",
    "mass of it",
    " ",
    "",
    "|",
    "%s",
];

/// SplitMix64: model n is the same on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    fn name(&mut self) -> &'static str {
        let names: Vec<&str> = NAMES.split_whitespace().collect();
        names[self.below(names.len())]
    }

    fn text(&mut self) -> String {
        (0..=self.below(3)).map(|_| TEXTS[self.below(TEXTS.len())]).collect()
    }
}

/// A string of TOML.
fn quoted(text: &str) -> String {
    let escaped: String = text
        .chars()
        .map(|c| match c {
            '"' | '\\' => format!("\\{c}"),
            c if c.is_control() => format!("\\u{:04x}", u32::from(c)),
            c => c.to_string(),
        })
        .collect();
    format!("\"{escaped}\"")
}

/// A crank with a sliding mass and, one time in two, a dependent angle; every name and text drawn.
fn text(random: &mut Random) -> String {
    let names: Vec<&str> = (0..16).map(|_| random.name()).collect();
    let [
        mass,
        length,
        gravity,
        spare,
        turn,
        slide,
        push,
        product,
        output,
        frame,
        point,
        body,
        tied,
        spring,
        law,
        by,
    ] = names[..]
    else {
        unreachable!("sixteen names")
    };
    let loops = random.below(2) == 0;
    let moved = ["", "*(1 + 0.1*sin(t*2_Hz))"][random.below(2)];
    let mut doc = || quoted(&random.text());
    let mut text = format!(
        "format = 1\nname = {}\ndoc = {}\ngravity = \"-{gravity}*N.y\"\n[parameters]\n\
         {mass} = {{ value = 2, unit = \"kg\", doc = {} }}\n{length} = {{ value = 0.5, unit = \"m\", doc = {} }}\n\
         {gravity} = {{ value = 9.81, unit = \"m/s^2\", doc = {} }}\n{spare} = {{ value = 3, doc = {} }}\n\
         [coordinates]\n{turn} = {{ unit = \"rad\", doc = {}, independent = true, nominal = 0.4, speed = \"{by}\" }}\n\
         {slide} = {{ unit = \"m\", independent = true, nominal = 0.3 }}\n",
        quoted(law),
        doc(),
        doc(),
        doc(),
        doc(),
        doc(),
        doc()
    );
    if loops {
        let _ = writeln!(text, "{tied} = {{ unit = \"rad\", nominal = 0.2 }}");
        let _ = writeln!(text, "[constraints.configuration]\n{spring} = \"sin({tied}) - 0.5*sin({turn})\"");
    }
    let _ = write!(
        text,
        "[inputs]\n{push} = {{ unit = \"N\", doc = {} }}\n\
         [definitions]\n{product} = \"{length}*sin({turn})*{spare} + {length}*cos({turn})\"\n\
         [frames]\n{frame} = {{ rotations = [[\"z\", \"{turn}\"]] }}\n\
         [points]\n{point} = \"{length}*{frame}.x + {slide}*{frame}.y + {product}{moved}*N.z\"\n\
         [bodies]\n{body} = {{ centre = \"{point}\", mass = \"{mass}\" }}\n\
         [forces]\n{spring} = {{ point = \"{point}\", force = \"{push}*N.x\" }}\n\
         [outputs]\n{output} = \"{product}\"\n",
        doc()
    );
    text
}

/// The forms and scalars in turn.
fn emitted(model: &Model, n: u64) -> Result<(Program, EmitOptions), String> {
    let choice = ParameterChoice::default();
    let counting = || ScalarType::Path("smartbed_runtime::real::counting::Counting".to_owned());
    let lanes = || ScalarType::Path("wide::f32x8".to_owned());
    let scalar = [ScalarType::F32, ScalarType::F64, counting(), lanes()][(n % 4) as usize].clone();
    let form = n / 4 % 4;
    let effort = [Effort::Default, Effort::None][(n / 16 % 2) as usize];
    let core = [None, Some(Core::Host), Some(Core::CortexM4)][(n % 3) as usize];
    let asked = if form == 2 { Function::each(&["augmented"]) } else { Vec::new() };
    let program = match form {
        3 => derive_kinematic(model, &choice, effort),
        _ => derive_asked(model, &choice, effort, &Asked::besides(asked.clone())),
    };
    let program = program.map_err(|e| e.to_string())?;
    let functions = if form == 3 { Function::each(&program.kinematic()) } else { asked };
    Ok((program, EmitOptions { scalar, functions, core, ..EmitOptions::default() }))
}

/// A model without anything hostile, at rest or moved by time.
fn plain(is_driven: bool) -> Model {
    let moved = if is_driven { " + sin(t*1_Hz)*1_m*N.y" } else { "" };
    let text = format!(
        "format = 1\nname = \"plain\"\n[parameters]\nm = {{ value = 1, unit = \"kg\" }}\n[coordinates]\n\
         q = {{ unit = \"m\" }}\n[points]\nP = \"q*N.x{moved}\"\n[bodies]\nb = {{ centre = \"P\", mass = \"m\" }}\n"
    );
    model::parse("plain.toml", &text).unwrap_or_else(|found| panic!("{found}"))
}

/// Names of a file's items in order, that of the mechanism and its implementations left out.
fn items(text: &str) -> Vec<String> {
    let file = syn::parse_file(text).unwrap_or_else(|error| panic!("{error}:\n{text}"));
    let name = |item: &syn::Item| match item {
        syn::Item::Const(item) => item.ident.to_string(),
        syn::Item::Fn(item) => item.sig.ident.to_string(),
        syn::Item::Mod(item) => item.ident.to_string(),
        // `Model` stands for the mechanism, whose name is the model's.
        syn::Item::Type(item) => item.ident.to_string(),
        // The mechanism alone has fields that are not public.
        syn::Item::Struct(item)
            if item.fields.iter().any(|f| matches!(f.vis, syn::Visibility::Inherited)) =>
        {
            "the mechanism".to_owned()
        }
        syn::Item::Struct(item) => item.ident.to_string(),
        syn::Item::Use(_) => "use".to_owned(),
        syn::Item::Impl(_) => "impl".to_owned(),
        _ => panic!("no item of an emitted file:\n{text}"),
    };
    file.items.iter().map(name).collect()
}

/// Text that must not reach the output: invisible characters, documentation that is compiled as a test.
fn faults(text: &str) -> Vec<String> {
    let unseen = |c: &char| {
        c.is_control() && *c != '\n'
            || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    let mut found: Vec<String> =
        text.chars().filter(unseen).map(|c| format!("the character {c:?}")).collect();
    for line in text.lines().filter_map(|line| line.trim_start().strip_prefix("///")) {
        if line.contains("```") || line.contains("~~~") || line.starts_with("    ") || line.starts_with('\t')
        {
            found.push(format!("a test in the documentation: {line}"));
        }
    }
    found
}

/// Compiles the crate of all modules with the versions of this workspace; returns the compiler's output.
fn compile(modules: &[String]) -> String {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hostile");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    let manifest = format!(
        "[package]\nname = \"hostile\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         smartbed-runtime = {{ path = {:?}, features = [\"counting\", \"simd\"] }}\n\
         wide = {{ version = \"1.7\", default-features = false }}\n",
        here.join("../runtime")
    );
    std::fs::write(folder.join("Cargo.toml"), manifest).expect("written");
    std::fs::copy(here.join("../Cargo.lock"), folder.join("Cargo.lock")).expect("copied");
    let mut root = "//! Hostile models.\n#![no_std]\n#![deny(warnings, missing_docs)]\n".to_owned();
    for (n, module) in modules.iter().enumerate() {
        std::fs::write(folder.join(format!("src/m{n}.rs")), module).expect("written");
        let _ = writeln!(
            root,
            "#[path = \"m{n}.rs\"]\n#[allow(missing_docs, reason = \"a file of its own\")]\npub mod m{n};"
        );
    }
    std::fs::write(folder.join("src/lib.rs"), root).expect("written");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["check", "--quiet", "--target-dir"]).arg(folder.join("target"));
    let done = command.current_dir(&folder).env_remove("CARGO_TARGET_DIR").output().expect("cargo runs");
    match done.status.success() {
        true => String::new(),
        false => String::from_utf8_lossy(&done.stderr).chars().take(8000).collect(),
    }
}

#[test]
fn hostile_models_stay_text() {
    let wanted = std::env::var("SMARTBED_HOSTILE").ok().and_then(|n| n.parse().ok()).unwrap_or(MODELS);
    let (mut modules, mut refused) = (Vec::new(), 0);
    let mut drawn = 0;
    while (modules.len() as u64) < wanted {
        drawn += 1;
        assert!(drawn < 40 * (wanted + 10), "only {} of {drawn} models are accepted", modules.len());
        let mut random = Random(drawn);
        let path = format!("models/{}.toml", random.text());
        let text = text(&mut random);
        // Two things of one name, or a word of Rust: most draws are refused for that, by a message with a place.
        let model = match model::parse(&path, &text) {
            Ok(model) => model,
            Err(found) => {
                assert!(found.items.iter().all(|item| !item.labels.is_empty()), "{found}");
                refused += 1;
                continue;
            }
        };
        let n = modules.len() as u64;
        let (program, options) = emitted(&model, n).unwrap_or_else(|found| panic!("{found}\n{text}"));
        let module = rust::emit(&program, &options);
        let (like, options) = emitted(&plain(model.is_driven()), n).expect("the plain model derives");
        assert_eq!(items(&module), items(&rust::emit(&like, &options)), "{text}\n{module}");
        assert_eq!(faults(&module), Vec::<String>::new(), "{text}\n{module}");
        modules.push(module);
    }
    let said = compile(&modules);
    assert!(said.is_empty(), "of {wanted} models, {refused} others refused:\n{said}");
}
