// SPDX-License-Identifier: GPL-2.0-or-later
#include "multistep_options.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "rodpack/motion/multistep.h"
#include "style_arguments.h"

using namespace LAMMPS_NS;

static_assert(rodpack::max_multistep_order == 4, "range of orders in messages and documentation");

bool MultistepOptions::read(const std::string& keyword, StyleArguments& arguments) {
  if (keyword == "order") {
    order_ = arguments.integer(keyword, leapfrog_ ? "a whole number in [0, 4], 0 for leapfrog"
                                                  : "a whole number in [1, 4]");
  } else if (keyword == "planar") {
    planar_ = arguments.peek();
    arguments.choice(keyword, {"auto", "yes", "no"});
  } else {
    return false;
  }
  return true;
}

bool MultistepOptions::planar() const {
  if (planar_ != "auto") return planar_ == "yes";
  return domain->dimension == 2 || modify->n_fixes_style("enforce2d") > 0;
}

void LAMMPS_NS::warn_of_new_histories(const Fix& fix, LAMMPS* lmp, const std::string& why,
                                      const std::string& whose) {
  if (lmp->comm->me != 0) return;
  const std::string text = std::string("Fix ") + fix.style + ": " + why + ", so the history of " +
                           whose + " starts anew";
  lmp->error->warning(FLERR, text.c_str());
}
