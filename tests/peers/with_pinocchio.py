"""Pinocchio's articulated-body algorithm on trees, from the C++ library of its wheel.

Operations are not countable. Loops need its iterative constraint solver, which solves a different problem, so they are not built.
"""
import ctypes
import pathlib
import subprocess

import numpy
import pinocchio

import states

TREES = ("arm6", "pendulum10")

SOURCE = """#include <pinocchio/multibody.hpp>
#include <pinocchio/algorithm/aba.hpp>
using namespace pinocchio;
static Model model; static Data *data; static Eigen::VectorXd q, v, tau;
extern "C" int load(int n, const double *p, const double *g) {
  model = Model(); model.gravity.linear() << g[0], g[1], g[2];
  for (int i = 0; i < n; i++, p += 22) {
    SE3 place; place.translation() << p[0], p[1], p[2];
    place.rotation() << p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11];
    JointIndex j = model.addJoint(i, JointModelRZ(), place, "j" + std::to_string(i));
    Eigen::Matrix3d inertia; inertia << p[16], p[19], p[20], p[19], p[17], p[21], p[20], p[21], p[18];
    model.appendBodyToJoint(j, Inertia(p[12], Eigen::Vector3d(p[13], p[14], p[15]), inertia), SE3::Identity());
  }
  data = new Data(model); q.setZero(n); v.setZero(n); tau.setZero(n); return 0;
}
extern "C" void eval_arm6(const double *in, double *out) {
  for (int i = 0; i < 6; i++) { q[i] = in[i]; v[i] = in[6+i]; tau[i] = in[12+i]; }
  aba(model, *data, q, v, tau); for (int i = 0; i < 6; i++) out[i] = data->ddq[i];
}
extern "C" void eval_pendulum10(const double *in, double *out) {
  for (int i = 0; i < 10; i++) { q[i] = in[i] - (i ? in[i-1] : 0); v[i] = in[10+i] - (i ? in[9+i] : 0); }
  aba(model, *data, q, v, tau); double s = 0; for (int i = 0; i < 10; i++) { s += data->ddq[i]; out[i] = s; }
}
"""


def joints(name):
    """22 numbers a joint: place, rotation, mass, centre, inertia; and gravity."""
    p, rows = states.parameters(name), []
    if name == "arm6":
        for i, (c, s) in enumerate([(1, 0), (0, -1), (1, 0), (0, -1), (0, 1), (0, -1)]):
            get = lambda *names: [p[f"{k}{i}"] for k in names]
            rows += [*get("px", "py", "pz"), 1, 0, 0, 0, c, -s, 0, s, c, *get("m", "cx", "cy", "cz", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz")]
        return 6, rows, [0, 0, -p["g"]]
    for i in range(10):
        rows += [0, -p[f"l{i - 1}"] if i else 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, p[f"m{i}"], 0, -p[f"l{i}"], 0, 0, 0, 0, 0, 0, 0]
    return 10, rows, [0, -p["g"], 0]


def compile_source(text, directory, name):
    """The library of a C++ source that uses Pinocchio."""
    prefix = pathlib.Path(pinocchio.__file__)
    prefix = next(parent for parent in prefix.parents if parent.name == "cmeel.prefix")
    source, so = directory / f"{name}.cpp", directory / f"{name}.so"
    source.write_text(text)
    libraries = [str(x) for x in sorted((prefix / "lib").glob("libpinocchio_default.so*"))[:1]]
    # The wheel leaves Eigen's headers out; CasADi's wheel brings them.
    eigen = [f"-I{x}" for x in (pathlib.Path("/usr/include/eigen3"), *prefix.parent.glob("*/include/eigen3")) if x.exists()]
    command = ["g++", "-O3", "-DNDEBUG", "-std=c++17", "-w", "-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS", "-DBOOST_FUSION_INVOKE_MAX_ARITY=10", "-shared", "-fPIC", str(source), "-o", str(so), f"-I{prefix}/include",
               *eigen, *libraries, f"-Wl,-rpath,{prefix}/lib"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stderr.strip().splitlines()[0])
    return so


def build(name, directory):
    """The loaded library."""
    if name not in TREES:
        raise NotImplementedError("loops need its iterative constraint solver")
    so = directory / "pinocchio_eval.so"
    # The models are loaded one at a time, so each gets its own copy.
    if not so.exists():
        compile_source(SOURCE, directory, "pinocchio_eval")
    own = directory / f"{name}_pinocchio.so"
    own.write_bytes(so.read_bytes())
    library = ctypes.CDLL(str(own))
    n, rows, gravity = joints(name)
    array = lambda x: numpy.array(x, float).ctypes.data_as(ctypes.c_void_p)
    library.load(n, array(rows), array(gravity))
    return library
