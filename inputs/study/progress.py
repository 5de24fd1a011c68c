# SPDX-License-Identifier: GPL-2.0-or-later
"""One line on how far a study is and when it will be done, as long as its run.sh lives.

  progress.py OUT SECONDS PID               a line each so many seconds, as long as its parent PID lives

Reads the run folders, whoever works on them: this machine or a cluster. The time left follows from the
work done since it began to watch.
"""

import os
import sys
import time
from pathlib import Path

import estimate
from folder import Study, last_time, read_json
from words import clock, duration

SHORTEST_WATCH_S = 20  # before it ventures a time


def fraction(run, case):
    """Share of a run's work that is done; case: its entry of plan.json."""
    if read_json(run / "result.json") is not None:
        return 1.0
    # The end of the relaxation is a guess: never all of it before the run says so.
    time_s = min(last_time(run / "energies.csv"), 0.98 * case["times"]["t_rest"])
    return estimate.work_until(time_s, case["times"]) / case["work_s"]


class Watch:
    def __init__(self, study):
        self.study = study
        self.cases = read_json(study.cases_file)["cases"]
        self.plan = read_json(study.plan_file)
        self.keys = [(name, seed) for name, case in self.cases.items() for seed in case["seeds"]]
        self.total = sum(self.plan[name]["work_s"] for name, _ in self.keys)
        self.whole = set()  # runs that are done need no second look
        self.told = set()
        self.begin = None

    def look(self):
        """Work done and failures not yet told."""
        done, news = 0.0, []
        for key in self.keys:
            name, seed = key
            share = 1.0 if key in self.whole else fraction(self.study.run(name, seed), self.plan[name])
            if share == 1.0:
                self.whole.add(key)
            done += share * self.plan[name]["work_s"]
            failure = self.study.failure(name, seed)
            if key not in self.told and failure.exists():
                self.told.add(key)
                news.append(f"FAILED {name} seed {seed}: {failure.read_text().strip()}")
        return done, news

    def line(self):
        """(the line, news to print on lines of their own)"""
        now = time.time()
        done, news = self.look()
        if self.begin is None:
            self.begin = (now, done)
        runs, count = len(self.whole), len(self.keys)
        text = f"{runs} of {count} runs done, {100 * done / self.total:.1f} % of the work"
        if self.told:
            text += f", {len(self.told)} failed"
        watched, gained = now - self.begin[0], done - self.begin[1]
        if runs == count:
            text += ", analyses and figures"
        elif watched >= SHORTEST_WATCH_S and gained > 0:
            left = (self.total - done) * watched / gained
            text += f", about {duration(left)} left, until {clock(now + left)}"
        return text, news


def main():
    watch, interval, parent = Watch(Study(Path(sys.argv[1]))), float(sys.argv[2]), int(sys.argv[3])
    terminal = sys.stdout.isatty()
    last = None
    while os.getppid() == parent:
        text, news = watch.line()
        for item in news:
            print(("\r\033[K" if terminal else "") + item, flush=True)
        if terminal:
            print(f"\r\033[K{text}", end="", flush=True)
        elif text != last:
            print(text, flush=True)
        last = text
        time.sleep(interval)


if __name__ == "__main__":
    try:
        main()
    except (KeyboardInterrupt, BrokenPipeError):
        pass
