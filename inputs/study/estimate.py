# SPDX-License-Identifier: GPL-2.0-or-later
"""What a run costs before it is made: processor time, disk, memory.

Times are those of the deck itself (its first line starts at 0, its last at t_last, has landed at t_landed
and rests at about t_rest); what a particle costs in a step was measured with the planar engine, on a
processor with AVX2 (tests/benchmark/study_estimate.py compares); how fast this machine is, a small
deposition tells (measure_speed()).
"""

import os
import resource
import subprocess
import tempfile
from pathlib import Path

# Nanoseconds for a particle of so many spheres and a step. While the bed fills, particles collide and are
# listed anew; at rest hardly.
def filling_ns(spheres):
    return 30 + 19.5 * spheres


def resting_ns(spheres):
    return 32 + 15 * spheres


# A step that LIGGGHTS makes itself, to observe the bed, costs as much as so many of the engine.
OBSERVED = 200
START_S = 0.3
# engine spheres instead of planar
SPHERES_ENGINE = 10

# The deposition that tells a machine's speed, and its processor time where the above was measured.
PROBE = {"particles": 150, "particles_per_line": 10, "width_in_lengths": 12, "container_height": 0.4}
PROBE_S = 3.0

# Bytes: constant, for a particle, for a sphere. Restart files hold contacts, too.
RESTART_BYTES = (2e5, 1100, 1350)
DUMP_BYTES = (2e5, 260, 350)
ANALYSIS_BYTES = (2e6, 2000, 300)
LINE_BYTES = 130  # of energies.csv


def work_until(time, values):
    """Processor time, s, of a run up to that time of its own, on the machine of the measurement."""
    spheres, last, landed = values["spheres_each"], values["t_last"], values["t_landed"]
    particles = values["particles"]

    # Particles enter at a steady rate until t_last: particle-seconds so far.
    def present(t):
        return particles * (t * t / (2 * last) if t < last else t - last / 2)

    seconds_filling = present(min(time, landed)) if last > 0 else particles * min(time, landed)
    seconds_resting = particles * max(0.0, time - landed)
    cost = seconds_filling * filling_ns(spheres) + seconds_resting * resting_ns(spheres)
    cost *= 1e-9 / values["timestep"] * (1 + OBSERVED / values["n_observe"])
    return cost * (SPHERES_ENGINE if values["engine"] == "spheres" else 1)


def work(values):
    """Processor time, s, of a whole run, on the machine of the measurement."""
    return START_S + work_until(values["t_rest"], values)



def _bytes(law, values):
    particles = values["particles"]
    return law[0] + particles * (law[1] + law[2] * values["spheres_each"])


def restart_bytes(values):
    """One restart file of the whole bed."""
    return _bytes(RESTART_BYTES, values)


def disk(values, keep_restarts):
    """Bytes of a run in the end, and the most that its restart files take while it runs."""
    files = values["t_rest"] / values["restart_interval"]
    # They grow with the bed: half of the last one on average, the bed at rest besides.
    peak = restart_bytes(values) * (files / 2 + 1)
    kept = {"none": 0.0, "end": restart_bytes(values), "all": peak}[keep_restarts]
    frames = 1 + values["t_rest"] / values["output_interval"]
    lines = values["t_rest"] / values["timestep"] / values["n_observe"]
    dumps = frames * _bytes(DUMP_BYTES, values) + LINE_BYTES * lines
    return kept + dumps + _bytes(ANALYSIS_BYTES, values), peak


def memory_mb(values):
    """Memory to ask of a cluster, with room to spare."""
    return int(500 + 0.02 * values["particles"] * values["spheres_each"])


def processor_time(liggghts, deck_file, variables, longest=None):
    """Processor time, s, of one deposition with these variables in a folder of its own, which goes away.

    Not that of the clock, so that other work on the machine hardly matters.
    @param longest  by the clock, s; None: as long as it takes
    @throws RuntimeError when the deposition fails or takes longer.
    """
    with tempfile.TemporaryDirectory(prefix="rodpack-speed-") as folder:
        command = [liggghts, "-log", "none", "-in", deck_file, "-var", "out", Path(folder) / "run"]
        for name, value in variables.items():
            command += ["-var", name, str(value)]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run(
                command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                timeout=longest,
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            raise RuntimeError(str(error)) from None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if not (Path(folder) / "run" / "result.json").exists():
            last = (done.stdout.strip().splitlines() or [f"exit status {done.returncode}"])[-1]
            raise RuntimeError(f"{liggghts}: {last}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measure_speed(liggghts, deck_file):
    """Speed of this machine's processor in units of that of the measurement: 2 is twice as fast.

    @throws RuntimeError when the small deposition fails.
    """
    try:
        return PROBE_S / processor_time(liggghts, deck_file, PROBE, longest=120)
    except RuntimeError as error:
        raise RuntimeError(f"cannot measure this machine's speed: {error}") from None


def cores_here():
    return len(os.sched_getaffinity(0))
