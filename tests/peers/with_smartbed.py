"""Ours: the generator's f64 Rust behind the same C entry as the peers, compiled at opt-level 3 without target-cpu.

The time includes `prepare`, as the peers get all parameters with every call; the operations do not.
"""
import json
import pathlib
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
#[unsafe(no_mangle)]
pub unsafe extern "C" fn eval_{name}(input: *const f64, output: *mut f64) {{
    let x = unsafe {{ core::slice::from_raw_parts(input, {n_in}) }};
    let out = unsafe {{ core::slice::from_raw_parts_mut(output, {n_out}) }};
    let q: &[f64; {nq}] = x[0..{nq}].try_into().unwrap();
    let u: &[f64; {nu}] = x[{nq}..{nq} + {nu}].try_into().unwrap();
    let inputs: &[f64; {nw}] = x[{nq} + {nu}..{nq} + {nu} + {nw}].try_into().unwrap();
    let parameters = {name}::Parameters {{ {fields} }};
    let (q_dot, u_dot, _) = {name}::rates(0.0, q, u, inputs, &{name}::prepare(&parameters));
    {store}
}}
"""


def emit(model, directory):
    """Writes the Rust of models/<model>.toml and returns what it holds."""
    command = ["cargo", "run", "-q", "--release", "-p", "smartbed-codegen", "--example", "emit", "--"]
    arguments = [f"models/{model}.toml", str(directory / f"{model}.rs"), "all"]
    done = subprocess.run(command + arguments, cwd=ROOT, text=True, capture_output=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    return json.loads(done.stdout)


def entry(name, about, mechanism):
    """The C entry: slots in the mechanism's order, q' only where the peers give it."""
    assert about["q"] == mechanism.q, (name, about["q"])
    assert about["u"] == [mechanism.u[k] for k in mechanism.independent], name
    assert about["inputs"] == mechanism.inputs, name
    slots = mechanism.slots
    fields = ", ".join(f"{p}: x[{slots.index(p)}]" for p in about["parameters"])
    nq, nu = len(about["q"]), len(about["u"])
    store = f"out[..{nq}].copy_from_slice(&q_dot); out[{nq}..].copy_from_slice(&u_dot);"
    if not mechanism.constrained:
        store = "let _ = q_dot; out.copy_from_slice(&u_dot);"
    return ENTRY.format(name=name, n_in=len(slots), n_out=mechanism.results, nq=nq, nu=nu, nw=len(about["inputs"]),
                        fields=fields, store=store)


def build(mechanisms, directory):
    """One shared library for all: (path, {model: operations}, {model: derivation in ms})."""
    source = directory / "ours" / "src"
    source.mkdir(parents=True, exist_ok=True)
    (source.parent / "Cargo.toml").write_text(MANIFEST.format(runtime=ROOT / "runtime"))
    text, operations, milliseconds = "//! Generated equations behind C entries.\n", {}, {}
    for name, mechanism in mechanisms.items():
        about = emit(name, source)
        operations[name], milliseconds[name] = about["operations"], about["milliseconds"]
        text += entry(name, about, mechanism)
    (source / "lib.rs").write_text(text)
    subprocess.run(["cargo", "build", "-q", "--release", "--offline"], cwd=source.parent, check=True)
    return source.parent / "target" / "release" / "libpeers_ours.so", operations, milliseconds
