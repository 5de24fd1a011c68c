# SPDX-License-Identifier: GPL-2.0-or-later
# For rows NAME TIME that come sorted by name and time, ns per sphere and step or `unit`: collects them; median and
# spread (largest over smallest, less 1) of a name, and the entry of a benchmark's JSON that sets two side by side.
{ value[$1, ++count[$1]] = $2 }
function median(m) { return value[m, int((count[m] + 1) / 2)] }
function spread(m) { return value[m, count[m]] / value[m, 1] - 1 }
function pair(name, a, b, unit) {
  return sprintf("  {\"name\": \"%s\", \"ratio\": %.3g, \"medians_%s\": [%.4g, %.4g], \"spread\": [%.2g, %.2g]}",
                 name, median(a) / median(b), unit == "" ? "ns_per_sphere_and_step" : unit, median(a), median(b), spread(a), spread(b))
}
