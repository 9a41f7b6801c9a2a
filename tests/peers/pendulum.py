#!/usr/bin/env python3
"""Prints the model text of a pendulum of n links: python3 tests/peers/pendulum.py 10 > models/pendulum10.toml

Point masses on massless rods, absolute angles from the downward vertical, as models/pendulum3.toml.
"""
import sys

TEMPLATE = """\
# {n} point masses on massless rods, hanging from the origin. Angles are absolute, from the downward
# vertical. Written by tests/peers/pendulum.py {n}.
format = 1
name = "pendulum{n}"
doc = "Pendulum of {n} links: point masses on massless rods, absolute angles from the downward vertical."
dof = {n}
gravity = "-g*N.y"

[repeat.mass]
each = [{digits}]

[repeat.mass.parameters]
"m{{i}}" = {{ value = 1.0, unit = "kg", doc = "mass {{i}}, counted from above" }}

[repeat.rod]
each = [{digits}]

[repeat.rod.parameters]
"l{{i}}" = {{ value = 1.0, unit = "m", doc = "length of rod {{i}}" }}

[parameters]
g = {{ value = 9.81, unit = "m/s^2", doc = "gravity" }}

[repeat.link]
each = [
{links}]

[repeat.link.coordinates]
"q{{i}}" = {{ unit = "rad", speed = "u{{i}}", range = [-3.0, 3.0], doc = "angle from the downward vertical" }}

[repeat.link.frames]
"rod{{i}}" = {{ parent = "N", rotations = [["z", "q{{i}}"]] }}

[repeat.link.points]
"P{{i}}" = "{{above}} - l{{i}}*rod{{i}}.y"

[repeat.link.bodies]
"mass{{i}}" = {{ centre = "P{{i}}", mass = "m{{i}}" }}

[start]
{start}
[run]
seconds = 10
step = 1e-3
method = "rk4"
every = 10
"""


def text(n):
    """The model text."""
    return TEMPLATE.format(
        n=n,
        digits=", ".join(f'{{ i = "{i}" }}' for i in range(n)),
        links="".join(f'    {{ i = "{i}", above = "{"P%d" % (i - 1) if i else "O"}" }},\n' for i in range(n)),
        start="".join(f'q{i} = "90*deg"\n' for i in range(n)),
    )


if __name__ == "__main__":
    print(text(int(sys.argv[1])), end="")
