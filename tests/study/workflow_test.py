# SPDX-License-Identifier: GPL-2.0-or-later
"""A miniature study from its table to its ensemble, and what a later call makes of what is there."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest

from support import CASES, DEPOSITION, LONGEST_STUDY, PROGRAMS, SMALL, UNTIL_ENSEMBLE, WORKFLOW, StudyTest, ensemble, ensemble_text


class Workflow(StudyTest):
    def setUp(self):
        super().setUp()
        self.know_speed()

    def cases(self):
        return json.loads((self.out / "cases.json").read_text())

    def test_a_study_is_made_once_and_then_only_what_changed(self):
        self.write_table("title: test\nrepetitions: 2\n" + SMALL + CASES)
        printed = self.run_study(*UNTIL_ENSEMBLE)
        self.assertIn("runs    4, of 2 cases: 0 done, 0 to go on, 4 to do", printed)
        self.assertRegex(printed, r"\n\d of 4 runs done, \d+\.\d % of the work")
        self.assertEqual((self.out / "study.yaml").read_text(), self.table.read_text())
        cases = self.cases()
        self.assertEqual(cases["format"], "rodpack-study 1")
        self.assertEqual(cases["columns"][:2], ["aspect_ratio", "particles"])
        self.assertEqual(cases["cases"]["rods"]["seeds"], [1, 2])
        self.assertEqual(cases["cases"]["rods"]["parameters"]["aspect_ratio"], 3)
        for seed in (1, 2):
            self.assertEqual(self.result("rods", seed)["particles"], 30)
            restarts = os.listdir(self.run_folder("rods", seed) / "restart")
            self.assertEqual(restarts, ["deposition.end.restart"])
            # before the first particle and at rest
            self.assertEqual(len(list((self.run_folder("rods", seed) / "dumps").glob("bodies.*"))), 2)
        self.assertEqual(set(ensemble(self.out)["cases"]), {"spheres", "rods"})
        # seeds differ, so repetitions do
        self.assertNotEqual(self.result("rods", 1)["largest_overlap_m"], self.result("rods", 2)["largest_overlap_m"])
        once = {f"{case}-seed-{seed}": 1 for case in ("spheres", "rods") for seed in (1, 2)}
        self.assertEqual(self.started(), once)
        self.then_nothing_is_made_again(once)
        self.then_the_report_is_made(once)
        self.then_a_copy_counts_as_done(once)
        self.then_an_archive_makes_the_same_ensemble()
        self.then_another_table_makes_what_it_changed(once)

    def then_nothing_is_made_again(self, once):
        written = (self.out / "ensemble" / "ensemble.json").stat().st_mtime_ns
        self.assertIn("4 done, 0 to go on, 0 to do", self.run_study(*UNTIL_ENSEMBLE))
        self.assertEqual(self.started(), once)
        self.assertEqual((self.out / "ensemble" / "ensemble.json").stat().st_mtime_ns, written)

    def then_the_report_is_made(self, once):
        printed = self.run_study()
        self.assertIn(str(self.out / "report.html"), printed)
        self.assertIn("spheres", (self.out / "report.html").read_text())
        self.assertEqual(self.started(), once)

    def then_a_copy_counts_as_done(self, once):
        original, self.out = self.out, self.folder / "copy"
        shutil.copytree(original / "runs", self.out / "runs", copy_function=shutil.copyfile)
        self.know_speed()
        self.assertIn("4 done, 0 to go on, 0 to do", self.run_study(*UNTIL_ENSEMBLE))
        self.assertEqual(self.started(), {})
        self.assertEqual(ensemble(self.out), ensemble(original))
        self.out = original

    def then_an_archive_makes_the_same_ensemble(self):
        original, archive = self.out, self.folder / "runs.tar.xz"
        self.assertIn("4 runs in", self.archive(original, archive))
        self.assertLess(archive.stat().st_size, 4 * 30_000)
        self.assertIn("exists, expected the name of a new file", self.archive(original, archive, expect=1))
        self.out = self.folder / "unpacked"
        self.know_speed()
        subprocess.run(["tar", "xf", archive, "-C", self.out], check=True)
        self.assertIn("4 done, 0 to go on, 0 to do", self.run_study(*UNTIL_ENSEMBLE))
        self.assertEqual(self.started(), {})
        self.assertEqual(ensemble_text(self.out), ensemble_text(original))
        self.out = original

    def test_what_is_no_study_is_not_archived(self):
        self.out.mkdir(exist_ok=True)
        printed = self.archive(self.out, self.folder / "a.tar.xz", expect=1)
        self.assertIn(f"{self.out}/cases.json: no such file, expected the folder of a study", printed)
        (self.out / "cases.json").write_text('{"cases": {"rods": {"seeds": [1]}}}')
        self.assertIn("no run is finished", self.archive(self.out, self.folder / "a.tar.xz", expect=1))
        self.assertIn("expected OUT FILE.tar.xz", self.archive(self.out, self.folder / "a.zip", expect=1))
        self.assertEqual([file.name for file in self.folder.iterdir()], ["out"])

    def archive(self, out, file, expect=0):
        """Runs archive.py. Returns what it printed."""
        done = subprocess.run(
            [sys.executable, str(WORKFLOW / "archive.py"), str(out), str(file)], stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True,
        )
        self.assertEqual(done.returncode, expect, done.stdout)
        return done.stdout

    def then_another_table_makes_what_it_changed(self, once):
        # Friction of the rods is another, spheres have one repetition, a case is new.
        text = self.table.read_text().replace("aspect_ratio: 3", "aspect_ratio: 3\n    friction: 0.4")
        text = text.replace("aspect_ratio: 1", "aspect_ratio: 1\n    seeds: [2]")
        self.write_table(text + "  long:\n    aspect_ratio: 4\n    seeds: [3]\n")
        before = self.result("rods", 1)
        printed = self.run_study(*UNTIL_ENSEMBLE)
        self.assertIn("runs    4, of 3 cases: 1 done, 0 to go on, 3 to do", printed)
        self.assertIn("changed rods seed 1: friction was 0.3, is 0.4", printed)
        self.assertIn("table   another one", printed)
        again = {"rods-seed-1": 2, "rods-seed-2": 2, "long-seed-3": 1}
        self.assertEqual(self.started(), {**once, **again})
        aside = list((self.out / "aside" / "rods").glob("seed-1.before.*"))
        self.assertEqual([json.loads((run / "result.json").read_text()) for run in aside], [before])
        self.assertEqual(ensemble(self.out)["cases"]["spheres"]["seeds"], [2])
        self.assertTrue(self.run_folder("spheres", 1).exists())
        # The spheres leave the table, their runs stay.
        self.write_table(text.replace("  spheres:", "  spheres:\n    run: no"))
        printed = self.run_study(*UNTIL_ENSEMBLE)
        self.assertIn("no part of the table, left alone: long, spheres", printed)
        self.assertEqual(set(ensemble(self.out)["cases"]), {"rods"})
        self.assertTrue(self.run_folder("spheres", 2).exists())

    def test_a_run_that_fails_is_reported_and_the_others_go_on(self):
        # Rods that may not relax for longer than a millisecond do not come to rest.
        failing = SMALL + CASES + "    relaxation_limit: 1e-3\n"
        self.write_table(failing)
        printed = self.run_study(*UNTIL_ENSEMBLE, expect=1)
        self.assertRegex(printed, r"FAILED rods seed 1: ERROR: kinetic over elastic energy is \S+ after")
        self.assertIn(f"log: {self.out / 'logs' / 'rods-seed-1.log'}", printed)
        self.assertEqual(self.result("spheres", 1)["particles"], 30)
        self.assertFalse((self.out / "ensemble").exists())
        printed = self.run_study(*UNTIL_ENSEMBLE, "--partial", expect=1)
        self.assertIn("ensemble and report are without rods seed 1", printed)
        self.assertEqual(set(ensemble(self.out)["cases"]), {"spheres"})
        # Given the time it needs it goes on from where it was: the limit is no part of the physics.
        self.write_table(failing.replace("1e-3", "20"))
        self.assertIn("1 done, 1 to go on, 0 to do", self.run_study(*UNTIL_ENSEMBLE))
        self.assertIn("going on from", (self.out / "logs/rods-seed-1.log").read_text())
        self.assertEqual(set(ensemble(self.out)["cases"]), {"spheres", "rods"})

    def programs_with(self, name, script):
        """The programs, one of them replaced by a script."""
        folder = self.folder / "bin"
        folder.mkdir()
        for program in ("liggghts", "rodpack"):
            (folder / program).symlink_to((PROGRAMS / program).resolve())
        (folder / name).unlink()
        (folder / name).write_text(f"#!/bin/sh\n{script}\n")
        (folder / name).chmod(0o755)
        return {**os.environ, "RODPACK_BIN": str(folder), "PROGRESS_S": "0.5"}

    def test_an_analysis_that_fails_is_reported(self):
        self.write_table(SMALL + CASES)
        script = f"case $2 in *rods*) echo 'rodpack: no' >&2; exit 1 ;; esac\nexec {PROGRAMS}/rodpack \"$@\""
        self.environment = lambda made=self.programs_with("rodpack", script): made
        printed = self.run_study("--runs-only", expect=1)
        self.assertIn("FAILED rods seed 1: analysis: rodpack: no", printed)
        self.assertTrue((self.run_folder("spheres", 1) / "analysis" / "summary.json").exists())
        del self.environment
        self.run_study("--runs-only")
        self.assertEqual(self.started(), {"spheres-seed-1": 1, "rods-seed-1": 1})

    def test_a_run_that_is_killed_is_reported_and_the_others_go_on(self):
        # As for want of memory: the rods alone, in the middle.
        self.write_table(SMALL + CASES)
        script = (
            f'case "$*" in *rods*) {PROGRAMS}/liggghts "$@" & sleep 0.3; kill -9 $!; wait $! ;;\n'
            f'*) exec {PROGRAMS}/liggghts "$@" ;; esac'
        )
        self.environment = lambda made=self.programs_with("liggghts", script): made
        printed = self.run_study("--no-report", expect=1)
        self.assertIn("FAILED rods seed 1: stopped, exit status 137", printed)
        self.assertEqual(self.result("spheres", 1)["particles"], 30)
        del self.environment
        self.run_study("--no-report")
        self.assertEqual(set(ensemble(self.out)["cases"]), {"spheres", "rods"})

    def test_an_ensemble_that_fails_is_reported(self):
        self.write_table(SMALL + CASES)
        script = f"[ $1 = ensemble ] && echo 'rodpack: no' >&2 && exit 1\nexec {PROGRAMS}/rodpack \"$@\""
        self.environment = lambda made=self.programs_with("rodpack", script): made
        printed = self.run_study("--no-report", expect=1)
        self.assertIn(f"FAILED: rodpack: no (log: {self.out / 'logs' / 'ensemble.log'})", printed)

    def test_a_restart_file_that_was_cut_off_is_not_used(self):
        self.write_table(SMALL + "cases:\n  rods: {aspect_ratio: 3, keep_restarts: all}\n")
        self.run_study("--runs-only")
        run = self.run_folder("rods", 1)
        files = {int(file.name.split(".")[1]): file for file in (run / "restart").glob("deposition.[0-9]*")}
        self.assertGreaterEqual(len(files), 3)
        expected = {file.name: file.read_bytes() for file in (run / "dumps").iterdir()}
        expected["energies.csv"] = (run / "energies.csv").read_bytes()
        result = (run / "result.json").read_bytes()
        steps = sorted(files)
        os.truncate(files[steps[-1]], files[steps[-1]].stat().st_size - 8)
        os.truncate(files[steps[-2]], files[steps[-2]].stat().st_size // 2)
        # As kill -9 leaves a run that was writing its result.
        (run / "result.json").write_text("")
        self.run_study("--runs-only")
        self.assertIn(f"going on from {files[steps[-3]]}", (self.out / "logs/rods-seed-1.log").read_text())
        self.assertEqual((run / "result.json").read_bytes(), result)
        for name, content in expected.items():
            file = run / name if name == "energies.csv" else run / "dumps" / name
            self.assertEqual(file.read_bytes(), content, name)

    def test_a_run_made_by_hand_counts_as_done(self):
        run = self.run_folder("rods", 1)
        words = ["-var", "preset", "quick", "-var", "particles", "30", "-var", "aspect_ratio", "3"]
        subprocess.run(
            [DEPOSITION / "run_one.sh", run, *words], check=True, stdout=subprocess.DEVNULL,
            env={**os.environ, "LIGGGHTS": str(PROGRAMS / "liggghts")},
        )
        self.write_table(SMALL + "cases:\n  rods: {aspect_ratio: 3}\n")
        self.assertIn("1 done, 0 to go on, 0 to do", self.run_study("--runs-only"))
        self.assertEqual(self.started(), {})
        self.assertTrue((run / "analysis" / "summary.json").exists())

    def test_a_dry_run_says_what_it_costs_and_changes_nothing(self):
        self.write_table("repetitions: 3\n" + SMALL + CASES)
        shutil.rmtree(self.out)
        printed = self.run_study("--dry-run")
        self.assertIn("runs    6, of 2 cases: 0 done, 0 to go on, 6 to do", printed)
        self.assertRegex(printed, r"work    \S+ core-hours, .* on 2 cores \(measured: \S+ times the speed")
        self.assertRegex(printed, r"disk    \S+ MB in the end, \S+ MB more .* are free")
        self.assertRegex(printed, r"\nrods +3 +0 ")
        self.assertFalse(self.out.exists())

    def test_two_at_once_are_refused(self):
        self.write_table(SMALL + CASES)
        first = subprocess.Popen(
            self.command("--runs-only"), env=self.environment(), stdout=subprocess.DEVNULL
        )
        while not self.run_folder("spheres", 1).exists():
            self.assertIsNone(first.poll())
            time.sleep(0.05)
        self.assertIn(f"is at work in {self.out}", self.run_study("--runs-only", expect=1))
        self.assertEqual(first.wait(timeout=LONGEST_STUDY), 0)

    def test_ctrl_c_ends_it_and_the_same_command_goes_on(self):
        self.write_table(SMALL.replace("particles: 30", "particles: 150") + CASES)
        study = subprocess.Popen(
            self.command("--runs-only"), env=self.environment(), stdout=subprocess.PIPE, text=True,
            start_new_session=True,
        )
        while not list((self.run_folder("rods", 1) / "restart").glob("*")):
            self.assertIsNone(study.poll())
            time.sleep(0.05)
        # As a terminal does: to all of them.
        os.killpg(study.pid, signal.SIGINT)
        self.assertIn("interrupted: the same command goes on", study.communicate(timeout=LONGEST_STUDY)[0])
        self.assertEqual(study.returncode, 130)
        self.assertFalse((self.run_folder("rods", 1) / "result.json").exists())
        self.run_study("--runs-only")
        self.assertIn("going on from", (self.out / "logs/rods-seed-1.log").read_text())
        self.assertEqual(self.result("rods", 1)["particles"], 150)

    def test_a_folder_that_is_no_study_is_refused(self):
        self.write_table(SMALL + CASES)
        shutil.rmtree(self.out)
        self.out.mkdir()
        (self.out / "thesis.tex").write_text("all of it")
        self.assertIn("is no study", self.run_study(expect=1))
        self.assertEqual(os.listdir(self.out), ["thesis.tex"])


if __name__ == "__main__":
    unittest.main()
