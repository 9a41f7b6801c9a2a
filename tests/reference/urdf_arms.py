#!/usr/bin/env python3
"""Two public arms by Pinocchio: accelerations and mass matrices at random states, for host/tests/command/import.rs.

UR5 (ur_description of ROS-Industrial, BSD 3-clause) and Franka Emika's Panda with its hand (panda_description, Apache 2.0), as
example-robot-data packs them; shapes are stripped, nothing else is changed. The Panda's second finger mimics the first.

    pip install pin example-robot-data
    python3 tests/reference/urdf_arms.py

writes tests/reference/urdf/*.urdf and tests/reference/urdf_arms.json.
"""

import json
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np
import pinocchio as pin

HERE = Path(__file__).resolve().parent
STATES = 20


def stripped(source, target):
    tree = xml.parse(source)
    root = tree.getroot()
    for name in ("gazebo", "transmission", "material"):
        for node in root.findall(name):
            root.remove(node)
    for link in root.findall("link"):
        for name in ("visual", "collision"):
            for node in link.findall(name):
                link.remove(node)
    tree.write(target, encoding="unicode")
    target.write_text(target.read_text() + "\n")


def states(path):
    model = pin.buildModelFromUrdf(str(path), mimic=True)
    data = model.createData()
    # A joint that goes round and round has cosine and sine as its coordinates there.
    moving = [n for n in range(1, model.njoints) if model.joints[n].nv == 1]
    names = [model.names[n] for n in moving]
    random = np.random.default_rng(1)
    rows = []
    for _ in range(STATES):
        angles, v = random.uniform(-1, 1, len(moving)), random.uniform(-2, 2, model.nv)
        q = np.zeros(model.nq)
        for n, angle in zip(moving, angles):
            at = model.joints[n].idx_q
            q[at : at + model.joints[n].nq] = [angle] if model.joints[n].nq == 1 else [np.cos(angle), np.sin(angle)]
        tau = random.uniform(-20, 20, model.nv)
        damping = np.array([model.damping[model.joints[n].idx_v] for n in moving])
        mass = pin.crba(model, data, q)
        mass = np.triu(mass) + np.triu(mass, 1).T
        # Damping is no part of Pinocchio's bias.
        bias = pin.nonLinearEffects(model, data, q, v)
        acceleration = np.linalg.solve(mass, tau - bias - damping * v)
        rows.append({
            "q": angles.tolist(),
            "v": v.tolist(),
            "tau": tau.tolist(),
            "a": acceleration.tolist(),
            "mass_matrix": mass.tolist(),
        })
    return {"joints": names, "states": rows}


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if folder is None:
        prefix = Path(pin.__file__).resolve()
        folder = next(p for p in prefix.parents if (p / "share").is_dir()) / "share/example-robot-data/robots"
    sources = {"ur5": "ur_description/urdf/ur5_robot.urdf", "panda": "panda_description/urdf/panda.urdf"}
    arms = {}
    for name, source in sources.items():
        target = HERE / "urdf" / f"{name}.urdf"
        stripped(folder / source, target)
        arms[name] = states(target)
    # Ours: slanted axes, turned inertias, fixed joints with mass, joints that follow another.
    arms["odd"] = states(HERE / "urdf" / "odd.urdf")
    text = json.dumps({"pinocchio": pin.__version__, "arms": arms}, indent=None)
    (HERE / "urdf_arms.json").write_text(text + "\n")


main()
