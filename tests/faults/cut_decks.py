# SPDX-License-Identifier: GPL-2.0-or-later
"""Every deck of inputs/verification/ is cut at half: from a restart file there it has to come to the bits
of the run that was not cut, on one rank and on two.

  cut_decks.py PROGRAMS WORK [DECK ...]

A deck's own text is what is run, so that a new deck is cut by itself. Its last `run` ends at half, with a
restart file; the second half starts from that file as the deck says itself, by its variable `from` or
`begin`, or else with the file in place of the box, the particles and the groups.
"""

import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

DECKS = Path(__file__).resolve().parents[2] / "inputs" / "verification"

# What a deck is run with, in place of its defaults and besides: shorter runs, and the integrators that it offers.
# LIGGGHTS's own velocity Verlet shows dashpots the velocities of half a step, and its `tangential history` adds a
# dashpot to a sliding contact that it evaluates twice: set-up, at the beginning of any run, does both otherwise than
# the steps do. So decks with that integrator and dashpots are here with ours, and those with that law end
# before their particles slide.
VARIANTS = {
    "bouncing_spheres": [{}, {"integrator": "nve/sphere"}],
    "chains": [{}, {"order": 2}],
    "collision": [{}, {"order": 0, "eta": 0}],
    "lines": [{"steps": 12000, "move": "multisphere/ab"}, {"steps": 12000}],
    "pile": [{"order": 3}],
    "planar": [{"steps": 8000, "mixture": "rods 2 ball 1", "move_bodies": "multisphere/ab",
                "move_balls": "nve/sphere/ab"}, {"steps": 8000}],
    "sliding_sphere": [{}, {"order": 3}],
    "stress": [{"steps": 16000, "every": 4000}, {"steps": 16000, "every": 4000, "periodic": 1}],
}

DIGITS = " ".join(["%.17g"] * 14)
END = f"""
write_dump all custom end.atoms id type x y z vx vy vz omegax omegay omegaz fx fy fz radius mass &
  modify format "%d %d {DIGITS}"
write_dump all multisphere/body end.bodies modify format %.17g
"""
CONTACTS = "write_dump all contact/gran end.contacts modify format %.17g\n"
# What a restart file brings along: particles, what they have, groups.
IN_FILE = re.compile(r"create_atoms|set\s|group\s|run\s|fix\s.*insert_every once")


class Deck:
    """A deck's text as commands, those that are continued with & as one."""

    def __init__(self, file):
        text = file.read_text()
        self.commands = re.sub(r"&[ \t]*\n", "&\v", text).split("\n")
        self.variables = set(re.findall(r"^variable\s+(\w+)\s+index", text, re.MULTILINE))
        runs = [k for k, command in enumerate(self.commands) if re.match(r"run\s", command)]
        self.last = runs[-1]
        found = re.fullmatch(r"run\s+(\S+)(\s+upto)?\s*(#.*)?", self.commands[self.last])
        self.steps, self.upto = found[1], bool(found[2])
        self.end = END + (CONTACTS if "model spring_dashpot" in text else "")
        self.restart = "cut.restart"
        named = re.search(r"read_restart\s+([^\s\"]*\$\{from\})", text)
        if named:
            self.restart = named[1].replace("${folder}", ".").replace("${from}", "${cut_half}")

    def text(self, run, before=None):
        """The deck with another last run and nothing behind it; `before` changes the commands ahead of it."""
        ahead = self.commands[: self.last]
        if before:
            ahead = [before(command) for command in ahead]
        return "\n".join(ahead).replace("\v", "\n") + "\n" + run

    def whole(self):
        return self.text(self.commands[self.last] + self.end)

    def first_half(self):
        start = "0" if self.upto else "v_cut_begin"
        return self.text(f"""
variable cut_step equal step
variable cut_begin string ${{cut_step}}
variable cut_end equal {start}+{self.steps}
variable cut_half equal floor(0.5*(v_cut_begin+v_cut_end))
run ${{cut_half}} upto
write_restart {self.restart}
print "cut at ${{cut_half}} of ${{cut_end}}" file cut.txt
""")

    def second_half(self, step, end):
        """The text and the variables that make it start from the file."""
        run = f"run {end} upto\n{self.end}"
        if "from" in self.variables:
            return self.text(run), {"from": step}
        if "begin" in self.variables:
            return self.text(run), {"begin": f"read_restart {self.restart}"}

        def from_file(command):
            if re.match(r"create_box", command):
                return f"read_restart {self.restart}"
            return "" if IN_FILE.match(command) else command

        return self.text(run, from_file), {}


class Failure(Exception):
    pass


def run(programs, folder, name, text, variables, ranks):
    (folder / name).write_text(text)
    words = [str(programs / "liggghts"), "-in", name]
    for variable, value in variables.items():
        words += ["-var", variable, str(value)]
    if ranks > 1:
        words = ["mpirun", "--oversubscribe", "-np", str(ranks), *words]
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_ess_singleton_isolated": "1" if ranks == 1 else "0",
                   "OMPI_MCA_mpi_yield_when_idle": "1"}
    done = subprocess.run(words, cwd=folder, env=environment, text=True, timeout=300,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        raise Failure(f"{folder}/{name}: exit status {done.returncode}\n{done.stdout[-2000:]}")


def end_state(folder):
    """The rows of the dumps of the end, whatever their order."""
    state = {}
    for file in sorted(folder.glob("end.*")):
        lines = file.read_text().splitlines()
        head = next(k for k, line in enumerate(lines) if re.match(r"ITEM: (ATOMS|ENTRIES|BODIES)", line))
        state[file.name] = lines[: head + 1] + sorted(lines[head + 1 :])
    if len(state) < 2:
        raise Failure(f"{folder}: no end state was written")
    return state


def difference(whole, cut):
    for name in whole:
        for ours, theirs in zip(whole[name], cut.get(name, [])):
            if ours != theirs:
                return f"{name}\n  not cut: {ours}\n  cut:     {theirs}"
        if len(whole[name]) != len(cut.get(name, [])):
            return f"{name}: {len(whole[name])} lines against {len(cut.get(name, []))}"
    return None


def cut(programs, work, file, variables, ranks):
    deck = Deck(file)
    whole, halves = work / "whole", work / "halves"
    for folder in (whole, halves):
        folder.mkdir(parents=True)
    run(programs, whole, "in.whole", deck.whole(), variables, ranks)
    run(programs, halves, "in.first", deck.first_half(), variables, ranks)
    step, end = re.fullmatch(r"cut at (\d+) of (\d+)\s*", (halves / "cut.txt").read_text()).groups()
    if not 0 < int(step) < int(end):
        raise Failure(f"{file}: cut at step {step} of {end}")
    text, start = deck.second_half(step, end)
    run(programs, halves, "in.second", text, {**variables, **start}, ranks)
    return difference(end_state(whole), end_state(halves))


def outcome(arguments):
    """What is wrong, or None."""
    try:
        return cut(*arguments)
    except Failure as reason:
        return str(reason)


def main(words):
    programs, work = Path(words[1]).resolve(), Path(words[2]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    files = [file for file in sorted(DECKS.glob("*/in.*")) if not words[3:] or file.parent.name in words[3:]]
    cuts = []
    for file in files:
        name = file.parent.name
        one_rank = re.search(r"^processors\s+1 1 1", file.read_text(), re.MULTILINE)
        for k, variables in enumerate(VARIANTS.get(name, [{}])):
            for ranks in (1,) if one_rank else (1, 2):
                cuts.append((programs, work / f"{name}-{k}-{ranks}", file, variables, ranks))
    wrong = 0
    # Two at a time: most of a cut is the start of its programs.
    with ThreadPoolExecutor(max_workers=2) as pool:
        for (_, _, file, variables, ranks), found in zip(cuts, pool.map(outcome, cuts)):
            wrong += found is not None
            what = f"{file.parent.name} {variables or ''} on {ranks} rank(s)"
            print(f"{what}: {'same bits' if found is None else found}", flush=True)
    if not files:
        print("no deck", file=sys.stderr)
        return 1
    if wrong:
        return 1
    shutil.rmtree(work)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
