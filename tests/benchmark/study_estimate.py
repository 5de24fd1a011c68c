#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compares what the study says that a run costs with what it takes, and this machine's speed with the model's.

  tests/benchmark/study_estimate.py BUILD-FOLDER [PARTICLES ...]

For each number of PARTICLES (250 and 1000) and a few aspect ratios one deposition of the study's deck, each
after a measurement of speed; ten minutes. Writes BUILD-FOLDER/benchmark/study_estimate.json.
"""

import json
import statistics
import sys
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(REPOSITORY / "inputs" / "study"), str(REPOSITORY / "inputs" / "deposition")]

import estimate  # noqa: E402
from deck import DECK, Deck  # noqa: E402

ASPECT_RATIOS = (2, 3, 5, 7)


def main(build, counts):
    liggghts = Path(build).resolve() / "bin" / "liggghts"
    deck = Deck()
    print("  AR  particles   said, s  taken, s  taken over said   speed here")
    lines = []
    for particles in counts:
        for aspect_ratio in ASPECT_RATIOS:
            variables = {"aspect_ratio": str(aspect_ratio), "particles": str(particles)}
            speed = statistics.median(estimate.measure_speed(liggghts, DECK) for _ in range(5))
            said = estimate.work(deck.evaluate(variables)) / speed
            taken = estimate.processor_time(liggghts, DECK, variables)
            print(f"{aspect_ratio:4} {particles:10} {said:9.1f} {taken:9.1f} {taken / said:16.2f} {speed:12.2f}",
                  flush=True)
            lines.append({"name": f"taken over estimated, {particles} rods of AR {aspect_ratio}",
                          "ratio": round(taken / said, 3), "said_s": said, "taken_s": taken, "speed": speed})
    folder = Path(build) / "benchmark"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "study_estimate.json").write_text(json.dumps(lines, indent=1) + "\n")


if __name__ == "__main__":
    if len(sys.argv) < 2 or not all(word.isdigit() and int(word) > 0 for word in sys.argv[2:]):
        sys.exit(__doc__)
    try:
        main(sys.argv[1], [int(word) for word in sys.argv[2:]] or [250, 1000])
    except RuntimeError as error:
        sys.exit(f"study_estimate.py: {error}")
