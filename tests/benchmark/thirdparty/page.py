# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of the page, in Markdown."""
from collections import namedtuple

# `text` stands above the table; `rows` are lists of words and numbers, as many as the header has columns.
Table = namedtuple("Table", "title text header rows")


def number(value, digits=2):
    """An error or a small number; a word stays what it is, None is a place that nobody has filled."""
    if value is None:
        return ""
    return value if isinstance(value, str) else f"{value:.{digits - 1}e}"


def fixed(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def markdown(table):
    lines = [f"### {table.title}", "", table.text, "", "| " + " | ".join(table.header) + " |",
             "|" + "---|" * len(table.header)]
    for row in table.rows:
        if len(row) != len(table.header):
            raise ValueError(f"{table.title}: a row of {len(row)} under {len(table.header)} names")
        lines.append("| " + " | ".join(number(value) for value in row) + " |")
    return "\n".join(lines) + "\n"


INTRODUCTION = """\
# Other people's tests

What other programs use as their tests, run here: the reference, the peer's published figure, ours and LIGGGHTS's own.
Written by `tests/benchmark/thirdparty/run.py build/bin/liggghts` in some ten minutes; nothing in the tables is typed in
but the peers' figures, and a peer's place is empty where it states none. The references are derived in the scripts
(`laws.py` and the module of each peer) and use no code of the program.

| column | |
|---|---|
| ours | `fix multisphere/ab`, order 3 with events unless stated, each sphere a body, `model spring_dashpot` |
| nve/sphere/ab | ours for plain spheres, order 3, which follows no events |
| nve/sphere, multisphere | LIGGGHTS's own, velocity Verlet, with its `model hooke/stiffness tangential history` |
| | and `limitForce on`, the same constants |
| 30 steps | per contact time π √(m/k) |

What they show:

- Restitution with dashpots is met in third order, the built-in's in first. Where bounces with little damping follow one
  another (DEM02 at e = 0.9), what order 3 loses shows as well.
- Without dashpots order 3 loses energy in every contact: 73/N³ of it at N steps per contact
  ([why](../../../liggghts-src-ext/doc/background/theory.md#energy-of-an-undamped-contact)), three times what MFiX's
  scheme gains. Velocity Verlet keeps it. Order 4 loses 1040/N⁵. [Which order to
  take](../../../liggghts-src-ext/doc/fix_multisphere_ab.md#which-order).
- LIGGGHTS's own `tangential history` adds up Δt v_t. Under velocity Verlet v_t is that of the middle of the step, under
  Adams–Bashforth that of its end, which makes the spring one of first order: give `tangential spring_dashpot` to
  Hertz's law too.
- Friction with a dashpot has a band of angles in which the law itself has no limit of small steps, under either cap.
- That `tangential history` adds its dashpot on top of Coulomb's cap, and LIGGGHTS's Hertz law rebounds faster than the
  restitution it is told, by a closed form (test 3 of Chung and Ooi), which has an inverse.
- A force that depends on velocity, such as drag or a dashpot, is of first order under velocity Verlet (DEM06).
- Two spheres in one rigid body meet as the impulse of rigid bodies says. Fields of a few particles are exact to rounding.
- Velocity Verlet holds a small grain between two large ones from a ratio of sizes of about 10 on; ours lets it fall.

Left out: MFiX's DEM06 where it solves for the gas, which this package does not have, and MercuryDPM's moments of
particle sizes, for which it has no field.

"""


def write(file, program, tables):
    file.write_text(INTRODUCTION + f"Program: {program}.\n\n" + "\n".join(tables))
