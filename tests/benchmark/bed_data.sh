#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# The last dump of a bed as a data file of LAMMPS and LIGGGHTS: spheres at rest, each as dense as gives its
# body the mass that it has; bodies as molecules, for what reads them.
#
#   tests/benchmark/bed_data.sh RUN-FOLDER > bed.data
set -eu
# shellcheck disable=SC2012  # names without blanks
awk 'FNR == 1 { file++ }
  file == 1 && FNR > 9 { mass[$1] = $NF; spheres[$1] = $3 }
  file == 2 && FNR == 6 { x = $0 }
  file == 2 && FNR == 7 { y = $0 }
  file == 2 && FNR > 9 {
    density = mass[$2] / spheres[$2] / (4 / 3 * 3.14159265358979 * $7 ^ 3)
    atom[++n] = $1 " 1 " 2 * $7 " " density " " $4 " " $5 " 0"
    body[n] = $1 " " $2
  }
  END {
    print "bed\n\n" n " atoms\n1 atom types\n" x " xlo xhi\n" y " ylo yhi\n-0.012 0.012 zlo zhi\n\nAtoms\n"
    for (k = 1; k <= n; ++k) print atom[k]
    print "\nMolecules\n"
    for (k = 1; k <= n; ++k) print body[k]
  }' "$(ls -t "$1"/dumps/bodies.* | head -n 1)" "$(ls -t "$1"/dumps/spheres.* | head -n 1)"
