"""Ours: the generator's f64 Rust behind the same C entry as the peers, compiled at opt-level 3 without target-cpu.

Three entries per mechanism: `prepare_NAME(in)` keeps what depends on parameters alone, once per parameter set;
`eval_NAME(in, out)` evaluates with what was kept; `whole_NAME(in, out)` prepares inside every evaluation.
"""
import json
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

MANIFEST = """[package]
name = "peers-ours"
version = "0.1.0"
edition = "2024"
[lib]
crate-type = ["cdylib"]
[dependencies]
smartbed-runtime = {{ path = "{runtime}" }}
[profile.release]
opt-level = 3
lto = "fat"
codegen-units = 1
panic = "abort"
[workspace]
"""

ENTRY = """
#[allow(warnings, reason = "generated")]
mod {name} {{ include!("{name}.rs"); }}
static mut PREPARED_{upper}: core::mem::MaybeUninit<{name}::Prepared> = core::mem::MaybeUninit::uninit();
fn prepared_{name}(x: &[f64]) -> {name}::Prepared {{
    {name}::prepare(&{name}::Parameters {{ {fields} }})
}}
#[inline(always)]
fn rates_{name}(x: &[f64], p: &{name}::Prepared, out: &mut [f64]) {{
    let q: &[f64; {nq}] = x[0..{nq}].try_into().unwrap();
    let u: &[f64; {nu}] = x[{nq}..{nq} + {nu}].try_into().unwrap();
    let inputs: &[f64; {nw}] = x[{nq} + {nu}..{nq} + {nu} + {nw}].try_into().unwrap();
    let (q_dot, u_dot, _) = {name}::rates(0.0, q, u, inputs, p);
    {store}
}}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn prepare_{name}(input: *const f64) {{
    unsafe {{ (*&raw mut PREPARED_{upper}).write(prepared_{name}(core::slice::from_raw_parts(input, {n_in}))); }}
}}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eval_{name}(input: *const f64, output: *mut f64) {{
    let (x, out) = unsafe {{ (core::slice::from_raw_parts(input, {n_in}), core::slice::from_raw_parts_mut(output, {n_out})) }};
    rates_{name}(x, unsafe {{ (*&raw const PREPARED_{upper}).assume_init_ref() }}, out);
}}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn whole_{name}(input: *const f64, output: *mut f64) {{
    let (x, out) = unsafe {{ (core::slice::from_raw_parts(input, {n_in}), core::slice::from_raw_parts_mut(output, {n_out})) }};
    rates_{name}(x, &prepared_{name}(x), out);
}}
"""

# Words for the emitter by form: the shortest, and the one chosen for time on a host.
FORMS = {"short": ["all"], "time": ["all", "time"]}
# The generator built for speed; the program of `cargo smartbed` has it built for size (Cargo.toml), which takes 2.4 times as long.
FOR_SPEED = [
    word
    for package in ["smartbed-codegen", "syn", "toml", "toml_parser", "proc-macro2"]
    for word in ["--config", f"profile.release.package.{package}.opt-level=3"]
]
# Fresh processes of which the fastest counts as the time of a derivation.
DERIVATIONS = 20


def emit(model, words, target):
    """Writes the Rust of models/<model>.toml and returns what it holds."""
    return emit_file(f"models/{model}.toml", words, target)


def emit_file(file, words, target):
    """Writes the Rust of a model's file and returns what it holds."""
    command = ["cargo", "run", "-q", "--release", *FOR_SPEED, "-p", "smartbed-codegen", "--example", "emit", "--"]
    arguments = [str(file), str(target), *words]
    done = subprocess.run(command + arguments, cwd=ROOT, text=True, capture_output=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    prepare = re.search(r"^// Cost of prepare: (\d+) operations", target.read_text(), re.MULTILINE)
    return json.loads(done.stdout) | {"prepare": int(prepare.group(1))}


def derivation(model, words, target):
    """Fastest time from the model's text to formatted Rust, each in a process of its own (ms)."""
    return min(emit(model, words, target)["milliseconds"] for _ in range(DERIVATIONS))


def entry(name, about, mechanism):
    """The C entries: slots in the mechanism's order, q' only where the peers give it."""
    assert about["q"] == mechanism.q, (name, about["q"])
    assert about["u"] == [mechanism.u[k] for k in mechanism.independent], name
    assert about["inputs"] == mechanism.inputs, name
    slots = mechanism.slots
    fields = ", ".join(f"{p}: x[{slots.index(p)}]" for p in about["parameters"])
    nq, nu = len(about["q"]), len(about["u"])
    store = f"out[..{nq}].copy_from_slice(&q_dot); out[{nq}..].copy_from_slice(&u_dot);"
    if not mechanism.constrained:
        store = "let _ = q_dot; out.copy_from_slice(&u_dot);"
    return ENTRY.format(name=name, upper=name.upper(), n_in=len(slots), n_out=mechanism.results, nq=nq, nu=nu,
                        nw=len(about["inputs"]), fields=fields, store=store)


def build(mechanisms, directory):
    """One shared library for all: (path, {(model, form): what was emitted}); entries end in MODEL_FORM.

    `milliseconds` is the time of the derivation with all effort, `default_milliseconds` with default effort.
    """
    source = directory / "ours" / "src"
    source.mkdir(parents=True, exist_ok=True)
    (source.parent / "Cargo.toml").write_text(MANIFEST.format(runtime=ROOT / "runtime"))
    text, emitted = "//! Generated equations behind C entries.\n", {}
    for model, mechanism in mechanisms.items():
        default = derivation(model, [], directory / "default_effort.rs")
        for form, words in FORMS.items():
            name = f"{model}_{form}"
            about = emit(model, words, source / f"{name}.rs")
            about |= {"milliseconds": derivation(model, words, source / f"{name}.rs"), "default_milliseconds": default}
            emitted[model, form] = about
            text += entry(name, emitted[model, form], mechanism)
    (source / "lib.rs").write_text(text)
    subprocess.run(["cargo", "build", "-q", "--release", "--offline"], cwd=source.parent, check=True)
    return source.parent / "target" / "release" / "libpeers_ours.so", emitted
