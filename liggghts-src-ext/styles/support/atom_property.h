// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_ATOM_PROPERTY_H
#define LMP_ATOM_PROPERTY_H

#include <string>
#include <vector>
#include "modify.h"

namespace LAMMPS_NS {

/// Makes a fix property/atom of this name with `values` numbers per atom, 0 at first. `restart`,
/// `ghosts`, `reverse`: "yes" or "no". One number makes a vector_atom, more an array_atom.
/// `caller`: style of the fix that asks for it.
inline FixPropertyAtom* add_atom_property(Modify* modify, const std::string& name, int values,
                                          const char* restart, const char* ghosts,
                                          const char* reverse, const char* caller) {
  std::vector<std::string> words = {
      name,    "all",  "property/atom", name, values == 1 ? "scalar" : "vector",
      restart, ghosts, reverse};
  words.resize(words.size() + values, "0.");
  std::vector<char*> arg;
  for (std::string& word : words) arg.push_back(&word[0]);
  return modify->add_fix_property_atom(static_cast<int>(arg.size()), arg.data(), caller);
}

}  // namespace LAMMPS_NS

#endif
