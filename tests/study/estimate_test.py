# SPDX-License-Identifier: GPL-2.0-or-later
"""What a run is said to cost, and how far it is said to be."""

import contextlib
import io
import json
import math
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from support import CASES, SMALL, WORKFLOW, StudyTest

import estimate
import words
from deck import DECK, Deck
from folder import Study
from progress import Watch, fraction
from plan import Plan
from prepare import prepare

VALUES = Deck().evaluate({"aspect_ratio": "3", "particles": "3000"})


class Work(unittest.TestCase):
    def test_work_is_the_integral_of_the_cost_of_the_particles_present(self):
        # By the midpoint rule over the life of the run, from what the deck says of its times.
        steps, values = 200000, VALUES
        dt, total = values["t_rest"] / steps, 0.0
        fill, rest = estimate.filling_ns(5), estimate.resting_ns(5)
        for k in range(steps):
            t = (k + 0.5) * dt
            present = 3000 * min(t / values["t_last"], 1)
            total += present * (fill if t < values["t_landed"] else rest) * dt
        total *= 1e-9 / values["timestep"] * (1 + estimate.OBSERVED / values["n_observe"])
        self.assertAlmostEqual(estimate.work(values) - estimate.START_S, total, delta=1e-4 * total)

    def test_work_so_far_grows_from_nothing_to_all(self):
        times = [VALUES["t_rest"] * k / 50 for k in range(51)]
        work = [estimate.work_until(t, VALUES) for t in times]
        self.assertEqual(work[0], 0)
        self.assertEqual(estimate.START_S + work[-1], estimate.work(VALUES))
        self.assertEqual(work, sorted(work))

    def test_a_single_line_of_particles_has_no_time_of_filling(self):
        values = Deck().evaluate({"particles": "10"})
        self.assertEqual(values["t_last"], 0)
        self.assertTrue(0 < estimate.work(values) < math.inf)

    def test_more_and_longer_particles_and_smaller_steps_cost_more(self):
        deck = Deck()
        for name, value in (("particles", "6000"), ("aspect_ratio", "5"), ("timestep", "5e-6"),
                            ("engine", "spheres")):
            other = deck.evaluate({"aspect_ratio": "3", "particles": "3000", name: value})
            self.assertGreater(estimate.work(other), 1.2 * estimate.work(VALUES), name)

    def test_speed_is_from_the_processor_time_of_the_probe_alone(self):
        # A program that works for 0.4 s, sleeps for longer, and refuses other variables than the probe's.
        with tempfile.TemporaryDirectory(prefix="rodpack-study-") as folder:
            program = Path(folder) / "liggghts"
            program.write_text(f"""#!{sys.executable}
import pathlib, sys, time
given = dict(zip(sys.argv[sys.argv.index("-var") + 1::3], sys.argv[sys.argv.index("-var") + 2::3]))
run = pathlib.Path(given.pop("out"))
if given != {({name: str(value) for name, value in estimate.PROBE.items()})!r}:
    sys.exit(f"other variables: {{given}}")
time.sleep(1)
while time.process_time() < 0.4:
    pass
run.mkdir()
(run / "result.json").touch()
""")
            program.chmod(0o755)
            taken = estimate.PROBE_S / estimate.measure_speed(program, DECK)
        self.assertGreater(taken, 0.38)  # the kernel counts in ticks of up to 10 ms
        self.assertLess(taken, 1)

    def test_a_program_that_does_not_run_is_named(self):
        with self.assertRaisesRegex(RuntimeError, "speed.*nowhere"):
            estimate.measure_speed("/nowhere/liggghts", DECK)
        with self.assertRaisesRegex(RuntimeError, "speed.*exit status 1"):
            estimate.measure_speed("/bin/false", DECK)

    def test_disk_of_what_is_kept(self):
        one = estimate.restart_bytes(VALUES)
        end, none = (estimate.disk(VALUES, keep)[0] for keep in ("end", "none"))
        self.assertAlmostEqual(end - none, one, delta=1)
        self.assertGreater(estimate.disk(VALUES, "all")[0], end)

    def test_times_and_sizes_in_words(self):
        self.assertEqual([words.duration(s) for s in (5, 600, 7200, 360000)],
                         ["5 s", "10 min", "2 h", "4 days"])
        self.assertEqual([words.size(n) for n in (12, 1.5e6, 2e9, 3e13)], ["12 B", "1.5 MB", "2 GB", "30 TB"])


class Progress(StudyTest):
    def setUp(self):
        super().setUp()
        self.write_table("repetitions: 2\n" + SMALL + CASES)
        self.plan = Plan(str(self.table), self.out)
        with contextlib.redirect_stdout(io.StringIO()):
            prepare(self.plan, 1.0)
        self.watch = Watch(Study(self.out))

    def make_run(self, case, seed, time_s, done=False):
        run = self.run_folder(case, seed)
        run.mkdir(parents=True, exist_ok=True)
        # The last line was cut off in the middle.
        (run / "energies.csv").write_text(f"step,time_s\n1000,{time_s}\n2000,9")
        if done:
            (run / "result.json").write_text('{"step": 3}\n')
        return run

    def test_progress_is_the_share_of_the_work_not_of_the_runs(self):
        self.make_run("rods", 1, 0.1, done=True)
        self.make_run("spheres", 1, 0.1)
        entries = self.watch.plan
        spheres, rods = entries["spheres"], entries["rods"]
        part = estimate.work_until(0.1, spheres["times"])
        share = (rods["work_s"] + part) / (2 * rods["work_s"] + 2 * spheres["work_s"])
        line, news = self.watch.line()
        self.assertEqual(line, f"1 of 4 runs done, {100 * share:.1f} % of the work")
        self.assertEqual(news, [])

    def test_a_run_is_not_done_before_it_says_so(self):
        run = self.make_run("rods", 1, 1e9)
        self.assertLess(fraction(run, self.watch.plan["rods"]), 1)
        (run / "result.json").write_text("{")
        self.assertLess(fraction(run, self.watch.plan["rods"]), 1)
        (run / "result.json").write_text("{}")
        self.assertEqual(fraction(run, self.watch.plan["rods"]), 1)

    def test_the_end_follows_from_the_work_done_since_it_began_to_watch(self):
        # A quarter of the work was there, another quarter took 100 s: half is left, 200 s.
        begin, total = time.time() - 100, self.watch.total
        self.watch.look = lambda: (0.5 * total, [])
        self.watch.begin = (begin, 0.25 * total)
        line, _ = self.watch.line()
        self.assertRegex(line, r"50.0 % of the work, about 3 min left, until \d\d:\d\d$")

    def test_a_failure_is_told_once(self):
        failure = Study(self.out).failure("rods", 2)
        failure.parent.mkdir(parents=True)
        failure.write_text("ERROR: too fast\n")
        line, news = self.watch.line()
        self.assertEqual(news, ["FAILED rods seed 2: ERROR: too fast"])
        self.assertIn(", 1 failed", line)
        self.assertEqual(self.watch.line()[1], [])

    def test_the_watch_ends_with_who_started_it(self):
        script = f"{sys.executable} {WORKFLOW / 'progress.py'} {self.out} 0.1 $$ & sleep 1"
        shown = subprocess.run(["sh", "-c", script], stdout=subprocess.PIPE, text=True, timeout=20).stdout
        self.assertEqual(shown, "0 of 4 runs done, 0.0 % of the work\n")

    def test_what_is_left_of_a_run_that_goes_on(self):
        whole = self.plan.work_left()
        self.make_run("rods", 1, 0.2)
        self.plan.states["rods", 1] = ("to go on", "")
        part = estimate.work_until(0.2, self.plan.table.cases[1].values)
        self.assertAlmostEqual(self.plan.work_left(), whole - part, delta=1e-12)
        self.plan.states["rods", 1] = ("done", "")
        self.assertAlmostEqual(
            self.plan.work_left(), whole - estimate.work(self.plan.table.cases[1].values), delta=1e-12
        )

    def test_plan_holds_what_the_steps_need(self):
        plan = json.loads((self.out / ".study" / "plan.json").read_text())
        self.assertEqual(plan["rods"]["variables"]["aspect_ratio"], "3")
        self.assertGreaterEqual(plan["rods"]["minutes"], 15)


if __name__ == "__main__":
    unittest.main()
