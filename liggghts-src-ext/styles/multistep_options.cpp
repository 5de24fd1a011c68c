// SPDX-License-Identifier: GPL-2.0-or-later
#include "multistep_options.h"

#include <cstdlib>
#include <cstring>
#include <string>

#include "domain.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "rodpack/multistep.h"

using namespace LAMMPS_NS;

int MultistepOptions::read(int iarg, int narg, char** arg) {
  if (strcmp(arg[iarg], "order") == 0) {
    const char* text = value(iarg, narg, arg);
    char* end = nullptr;
    const long order = strtol(text, &end, 10);
    if (*text == '\0' || *end != '\0' || order < 1 || order > rodpack::max_multistep_order)
      refuse("order", text, "an integer from 1 to 4");
    order_ = static_cast<int>(order);
    return 2;
  }
  if (strcmp(arg[iarg], "planar") == 0) {
    const char* text = value(iarg, narg, arg);
    if (strcmp(text, "auto") == 0)
      planar_ = AUTO;
    else if (strcmp(text, "yes") == 0)
      planar_ = YES;
    else if (strcmp(text, "no") == 0)
      planar_ = NO;
    else
      refuse("planar", text, "auto, yes or no");
    return 2;
  }
  return 0;
}

const char* MultistepOptions::value(int iarg, int narg, char** arg) const {
  if (iarg + 1 >= narg) {
    const std::string text = std::string("keyword '") + arg[iarg] + "' needs a value";
    error->fix_error(FLERR, owner_, text.c_str());
  }
  return arg[iarg + 1];
}

bool MultistepOptions::yes_or_no(int iarg, int narg, char** arg) const {
  const char* text = value(iarg, narg, arg);
  const bool yes = strcmp(text, "yes") == 0;
  if (!yes && strcmp(text, "no") != 0) refuse(arg[iarg], text, "yes or no");
  return yes;
}

void MultistepOptions::refuse(const char* keyword, const char* value, const char* expected) const {
  const std::string text =
      std::string("keyword '") + keyword + "': expected " + expected + ", got '" + value + "'";
  error->fix_error(FLERR, owner_, text.c_str());
}

bool MultistepOptions::planar() const {
  if (planar_ != AUTO) return planar_ == YES;
  return domain->dimension == 2 || modify->n_fixes_style("enforce2d") > 0;
}
