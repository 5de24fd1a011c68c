# SPDX-License-Identifier: GPL-2.0-or-later
"""Scenes of a few spheres, run by LIGGGHTS with in.spheres."""
import os
import subprocess
import tempfile
from collections import namedtuple
from math import cos, sin, sqrt
from pathlib import Path

DECK = Path(__file__).with_name("in.spheres")
FIELDS = Path(__file__).with_name("in.fields")

# How the spheres are moved, and by which contact law.
Method = namedtuple("Method", "name motion bodies law")
OURS = Method("multisphere/ab", "multisphere/ab order 3", 1, "spring_dashpot")
ORDER_4 = Method("multisphere/ab order 4", "multisphere/ab order 4", 1, "spring_dashpot")
ORDER_2 = Method("multisphere/ab order 2", "multisphere/ab order 2", 1, "spring_dashpot")
PLAIN = Method("nve/sphere/ab", "nve/sphere/ab order 3", 0, "spring_dashpot")
STOCK = Method("nve/sphere", "nve/sphere", 0, "hooke")
STOCK_BODY = Method("multisphere", "multisphere", 1, "hooke")


def sphere(y=0.0, vy=0.0, x=0.0, vx=0.0, z=0.0, wz=0.0, radius=1e-3, density=2500.0, frozen=0):
    return dict(x=x, y=y, z=z, vx=vx, vy=vy, wz=wz, diameter=2 * radius, density=density, frozen=frozen,
                chain="aspect_ratio 1", turn="1 0 0 0")


def dumbbell(mass, spacing, angle=0.0, **settings):
    """Two equal spheres of `mass` (kg) each in one rigid body, `spacing` (m) apart, which is half a diameter
    or less.

    Their line stands at `angle` with x; they overlap, and count twice where they do. The rest as for a
    sphere.
    """
    body = sphere(**settings)
    radius = 0.5 * body["diameter"]
    along, across = dumbbell_inertia(mass, spacing, radius)
    body["chain"] = (f"aspect_ratio {1 + 0.5 * spacing / radius!r} "
                     f"mass given {2 * mass!r} {along!r} {across!r} {across!r}")
    body["turn"] = f"{cos(0.5 * angle)!r} 0 0 {sin(0.5 * angle)!r}"
    return body


def dumbbell_inertia(mass, spacing, radius):
    """Moments about the line of the two spheres and across it, kg m^2."""
    along = 0.8 * mass * radius**2
    return along, along + 0.5 * mass * spacing**2


def spring_scene(spheres, dt, steps, **settings):
    """Variables of in.spheres; `effective_mass` (kg) turns the damping ratios into those of `hooke`."""
    mass = settings.pop("effective_mass", None)
    if mass is not None:
        for direction, stiffness in ("n", "kn"), ("t", "kt"):
            eta = settings.get("eta_" + direction, 0.0)
            settings["gamma_" + direction] = 2 * eta * sqrt(settings[stiffness] / mass)
    return dict(settings, spheres=spheres, dt=dt, steps=steps)


class Failed(Exception):
    """LIGGGHTS has not run to its end."""


def variables(settings, spheres):
    """Lines that set a deck's variables, and its lists of one word for each sphere."""
    lines = [f"variable {name} index {value}" for name, value in settings.items()]
    for name in spheres[0]:
        lines.append(f"variable {name} index " + " ".join(repr(s[name]) for s in spheres))
    return [*lines, "variable id index " + " ".join(str(n + 1) for n in range(len(spheres)))]


class Runner:
    """Starts LIGGGHTS for one scene after the other, each in a fresh folder that goes away."""

    def __init__(self, program):
        self.program = Path(program)
        self.runs, self.banner = 0, ""

    def __call__(self, scene, method):
        """Frames (time, rows) from the start on; rows are dicts of the dump's columns, by the number of the body.

        scene["kick"]: the acceleration that all spheres start with, m/s^2.
        """
        self.runs += 1
        settings = dict(scene, motion=f'"{method.motion}"', bodies=method.bodies, law=method.law)
        spheres, kick = settings.pop("spheres"), settings.pop("kick", (0, 0))
        if method.name == "multisphere":
            # A body of the built-in fix gets half a kick in the step of its birth, before time starts.
            half = 0.5 * scene["dt"]
            spheres = [dict(s, vx=s["vx"] - half * kick[0], vy=s["vy"] - half * kick[1]) for s in spheres]
        with tempfile.TemporaryDirectory(prefix="thirdparty.") as folder:
            self.start("\n".join([*variables(settings, spheres), DECK.read_text()]), folder, method.name)
            return read_frames(Path(folder, "spheres.dump"), scene["dt"])

    def fields(self, spheres, grids, after=None, **settings):
        """Rows (dicts of columns) of `compute stress/goldhirsch` of spheres at rest, for each of `grids`,
        name: arguments; and the sum of the three diagonals of LIGGGHTS's own `compute stress/atom`, J.

        `spheres`: dicts of in.fields's lists; `settings`: its other variables. `after(folder)` gives rows of
        its own, from the dumps, that are returned third.
        """
        self.runs += 1
        lines = [*variables(settings, spheres), FIELDS.read_text()]
        lines += [f"compute {name} all stress/goldhirsch {words}" for name, words in grids.items()]
        lines.append("run 0")
        lines += [f"write_dump all stress/goldhirsch {name}.csv {name}" for name in grids]
        lines += ["variable trace equal c_total[1]+c_total[2]+c_total[3]", 'print "trace ${trace}"', ""]
        with tempfile.TemporaryDirectory(prefix="thirdparty.") as folder:
            said = self.start("\n".join(lines), folder, "fields")
            tables = {name: read_table(Path(folder, name + ".csv")) for name in grids}
            trace = float(said.rsplit("trace ", 1)[1].split()[0])
            return tables, trace, after(folder) if after else None

    def output_of(self, text):
        """What a deck of one's own says."""
        with tempfile.TemporaryDirectory(prefix="thirdparty.") as folder:
            return self.start(text, folder, "deck")

    def start(self, text, folder, name):
        Path(folder, "in.run").write_text(text)
        done = self.execute([self.program, "-in", "in.run"], folder, name)
        self.banner = done.split("\n", 1)[0]
        return done

    def execute(self, command, folder, name):
        """What a command says that has been run in a folder."""
        # A program started alone would else look for Open MPI's daemon, and several at once would share a folder.
        environment = dict(os.environ, OMPI_MCA_ess_singleton_isolated="1", OMPI_MCA_orte_tmpdir_base=folder)
        done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode:
            log = Path(folder, "log.liggghts")
            said = log.read_text().splitlines()[-3:] if log.exists() else []
            raise Failed("\n".join([f"{name}: exit status {done.returncode}", *said, done.stderr]))
        return done.stdout


def read_table(file):
    """Rows of a CSV file of numbers, as dicts."""
    with open(file) as lines:
        names = next(lines).strip().split(",")
        return [dict(zip(names, map(float, line.split(",")))) for line in lines]


def read_frames(file, dt):
    frames, first = [], None
    with open(file) as lines:
        for line in lines:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(next(lines))
                first = step if first is None else first
            elif line.startswith("ITEM: NUMBER"):
                number = int(next(lines))
            elif line.startswith("ITEM: ATOMS"):
                names = line.split()[2:]
                rows = [dict(zip(names, map(float, next(lines).split()))) for _ in range(number)]
                frames.append(((step - first) * dt, rows))
    return frames
