#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Other people's tests: runs them and writes their numbers into README.md beside this file.

    tests/benchmark/thirdparty/run.py build/bin/liggghts [case ...]

With names of cases (the modules of this folder) their tables are printed and the page stays as it is.
"""
import importlib
import sys
from pathlib import Path

sys.dont_write_bytecode = True

import page  # noqa: E402
from scene import Failed, Runner  # noqa: E402

CASES = ["mfix", "schwager_poeschel", "thornton", "mercurydpm", "mercurydpm_fields", "spheral", "walberla",
         "vyas", "chung_ooi"]


def main(arguments):
    if not arguments or not Path(arguments[0]).is_file():
        sys.exit(f"run.py: expected the program liggghts first, got {arguments[:1]}")
    if not Path(arguments[0]).with_name("rodpack").is_file():
        sys.exit(f"run.py: expected the program rodpack beside {arguments[0]}, found none")
    unknown = set(arguments[1:]) - set(CASES)
    if unknown:
        sys.exit(f"run.py: no case {sorted(unknown)}, expected some of {CASES}")
    runner = Runner(Path(arguments[0]).resolve())
    text = []
    for case in arguments[1:] or CASES:
        for table in importlib.import_module(case).tables(runner):
            text.append(page.markdown(table))
            print(text[-1], flush=True)
    if len(arguments) == 1:
        page.write(Path(__file__).with_name("README.md"), runner.banner, text)
    print(f"{runner.runs} runs", file=sys.stderr)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Failed as failure:
        sys.exit(f"run.py: {failure}")
