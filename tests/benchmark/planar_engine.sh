#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Time of a step of run_style verlet/planar against the built-in multisphere at the best of some skins
# (spheres: nve/sphere) and the sphere-level multisphere/ab: whole decks (in.steps) from the same state,
# one core, in turns.
#
#   tests/benchmark/planar_engine.sh BUILD-FOLDER [ROUNDS [CASE ...]]
#
# Prints ns per sphere and step, and writes the ratios to BUILD-FOLDER/benchmark/planar_engine.json.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
rounds=${2:-5}
[ $# -lt 2 ] || shift
shift
cases=${*:-rest falling ar2 ar7 coarse curved spheres}
export OMPI_MCA_ess_singleton_isolated=1
"$here/beds.sh" "$build"
work=$build/benchmark/planar_engine
mkdir -p "$work"
cd "$work"

# Sets `bed` (its restart file), `stock_bed` (the same for `stock`), `particle` (variables of in.steps) and the
# methods; makes the second.
describe() {
  others="spheres planar planar:events=no"
  skins="1e-4 3e-4 1e-3"
  stock=builtin
  state=end
  folder=$1
  particle=
  case $1 in
    rest)
      folder=ar5
      others="$others planar:instructions=avx2 planar:instructions=baseline"
      ;;
    falling)
      folder=ar5
      state='[0-9]*'
      skins="3e-4 1e-3 2e-3 4e-3"
      ;;
    ar2) particle="aspect_ratio=2 width=0.12" ;;
    ar7) particle="aspect_ratio=7 width=0.42" ;;
    coarse) particle="overlap=0" ;;
    curved) particle="curvature=120" ;;
    spheres)
      particle="aspect_ratio=1 width=0.06"
      stock=nve
      ;;
    *)
      echo "planar_engine.sh: unknown case '$1', expected rest falling ar2 ar7 coarse curved spheres" >&2
      exit 2
      ;;
  esac
  # shellcheck disable=SC2012,SC2086  # a pattern; names without blanks
  bed=$(ls "$build/benchmark/beds/$folder"/restart/deposition.$state.restart | head -n 1)
  stock_bed=$work/$1.$stock
  case $stock in
    nve) "$here/bed_data.sh" "$build/benchmark/beds/$folder" | sed '/^Molecules/,$d' ;;
    builtin) "$here/for_builtin.sh" "$bed" ;;
  esac > "$stock_bed"
  methods=
  for skin in $skins; do methods="$methods $stock:skin=$skin"; done
  methods="$methods $others"
}

for case in $cases; do
  describe "$case"
  rm -f "$case.times"
  round=0
  while [ $round -lt "$rounds" ]; do
    for method in $methods; do
      arguments=
      for setting in $(echo "$particle ${method#"${method%%:*}"}" | tr ':' ' '); do
        arguments="$arguments -var ${setting%%=*} ${setting#*=}"
      done
      start=$bed
      case $method in "$stock":*) start=$stock_bed ;; esac
      steps=1000
      case $method in planar*) steps=4000 ;; esac
      # shellcheck disable=SC2086  # words
      taskset -c 1 "$build/bin/liggghts" -in "$here/in.steps" -var start "$start" \
        -var method "${method%%:*}" -var steps $steps $arguments > run.out 2>&1 || { tail -3 run.out; exit 1; }
      # shellcheck disable=SC2016  # awk's
      awk -v name="$method" '/^Loop time/ { time = $4; steps = $9; spheres = $12 }
        END { print name, time / steps / spheres * 1e9 }' run.out >> "$case.times"
    done
    round=$((round + 1))
  done
done

for case in rest falling ar2 ar7 coarse curved spheres; do
  [ ! -e "$case.times" ] || sort -k1,1 -k2,2g "$case.times" | sed "s|^|$case/|"
done | awk -v file="$build/benchmark/planar_engine.json" "$(cat "$here/medians.awk")"'
  function case_of(m) { return substr(m, 1, index(m, "/") - 1) }
  function method_of(m) { return substr(m, index(m, "/") + 1) }
  count[$1] == 1 { names[++n] = $1 }
  END {
    for (k = 1; k <= n; ++k) {
      m = names[k]
      c = case_of(m)
      if (m ~ "/(builtin|nve)" && (!(c in best) || median(m) < median(best[c]))) best[c] = m
    }
    print "[" > file
    for (k = 1; k <= n; ++k) {
      m = names[k]
      stock = best[case_of(m)]
      printf "%-38s %8.2f ns per sphere and step, spread %3.0f %%, %5.2f times less than %s\n",
             m, median(m), 100 * spread(m), median(stock) / median(m), method_of(stock)
      if (m !~ "/planar") continue
      printf "%s%s", separator, pair(case_of(m) ", " method_of(stock) " over " method_of(m), stock, m) > file
      separator = ",\n"
    }
    print "\n]" > file
  }'
