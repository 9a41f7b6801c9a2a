"""MuJoCo's mj_forward on trees, from the C library of its wheel: constraints, contacts and clamping off.

Operations are not countable. The tile's, four-bar's and bicycle's loops and rolling are soft constraints
solved by iteration there, which is a different problem, so they are not built.
"""
import ctypes
import pathlib
import subprocess

import mujoco

import states

TREES = ("arm6", "pendulum10")

SOURCE = """#include <mujoco/mujoco.h>
static mjModel *m; static mjData *d;
int load(const char *path) { char error[999]; m = mj_loadXML(path, 0, error, 999); if (!m) { puts(error); return 1; } d = mj_makeData(m); return 0; }
void eval(const double *in, double *out) {
  for (int i = 0; i < %(n)d; i++) { d->qpos[i] = %(q)s; d->qvel[i] = %(u)s; %(input)s }
  mj_forward(m, d);
  %(output)s
}
"""


def arm_xml():
    p, alpha = states.parameters("arm6"), [0, -90, 0, -90, 90, -90]
    text = ""
    for i in range(6):
        get = lambda *names: " ".join(repr(p[f"{name}{i}"]) for name in names)
        text += (f'<body pos="{get("px", "py", "pz")}" euler="{alpha[i]} 0 0"><joint type="hinge" axis="0 0 1"/>'
                 f'<inertial pos="{get("cx", "cy", "cz")}" mass="{get("m")}" fullinertia="{get("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")}"/>')
    return text + "</body>" * 6, "0 0 -9.81"


def pendulum_xml(n):
    """Relative angles; a point mass needs a grain of inertia there."""
    p, text = states.parameters(f"pendulum{n}"), ""
    for i in range(n):
        at = f"0 {-p[f'l{i - 1}']!r} 0" if i else "0 0 0"
        text += (f'<body pos="{at}"><joint type="hinge" axis="0 0 1"/>'
                 f'<inertial pos="0 {-p[f"l{i}"]!r} 0" mass="{p[f"m{i}"]!r}" diaginertia="1e-14 1e-14 1e-14"/>')
    return text + "</body>" * n, "0 -9.81 0"


def build(name, directory):
    """The entry `eval` of a shared library."""
    if name not in TREES:
        raise NotImplementedError("loops and rolling are soft constraints there")
    body, gravity = arm_xml() if name == "arm6" else pendulum_xml(10)
    xml = (f'<mujoco><compiler angle="degree" boundmass="0" boundinertia="0" balanceinertia="false"/><option gravity="{gravity}">'
           f'<flag contact="disable" constraint="disable"/></option><worldbody>{body}</worldbody></mujoco>')
    (directory / f"{name}_mujoco.xml").write_text(xml)
    arm, n = name == "arm6", 6 if name == "arm6" else 10
    source = SOURCE % {
        "n": n,
        "q": "in[i]" if arm else "in[i] - (i ? in[i-1] : 0)",
        "u": "in[6+i]" if arm else "in[10+i] - (i ? in[9+i] : 0)",
        "input": "d->qfrc_applied[i] = in[12+i];" if arm else "",
        "output": "for (int i = 0; i < 6; i++) out[i] = d->qacc[i];" if arm
        else "double s = 0; for (int i = 0; i < 10; i++) { s += d->qacc[i]; out[i] = s; }",
    }
    home = pathlib.Path(mujoco.__file__).resolve().parent
    candidates = list(home.glob("libmujoco*.so*")) + list(home.parent.glob("mujoco*/**/libmujoco.so*"))
    headers = [home / "include", *home.parent.glob("mujoco*/include")]
    if not candidates:
        raise RuntimeError("the wheel brings no libmujoco")
    c, so = directory / f"{name}_mujoco.c", directory / f"{name}_mujoco.so"
    c.write_text("#include <stdio.h>\n" + source)
    command = ["gcc", "-O3", "-shared", "-fPIC", str(c), "-o", str(so), *(f"-I{h}" for h in headers), str(candidates[0]),
               f"-Wl,-rpath,{candidates[0].parent}"]
    subprocess.run(command, check=True, capture_output=True, text=True)
    library = ctypes.CDLL(str(so))
    if library.load(str(directory / f"{name}_mujoco.xml").encode()):
        raise RuntimeError("the XML is refused")
    return library
