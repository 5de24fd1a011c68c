// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS

CommandStyle(parameter, Parameter)

#else

#ifndef LMP_PARAMETER_H
#define LMP_PARAMETER_H

#include "pointers.h"

#include <set>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/// Command parameter: declares, validates and records the parameters that a deck takes from the
/// command line (-var); see doc/parameter.md.
class Parameter : protected Pointers {
 public:
  explicit Parameter(LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);

 private:
  struct Declaration {
    std::string name, type, value, unit;
  };

  void declare(int narg, char** arg);
  void set_folder() const;
  void include(const std::string& file) const;
  void declare_choice(const Declaration& it, class StyleArguments& arguments);
  static void clear();
  std::string automatic_value(const Declaration& it, const class StyleArguments& arguments) const;
  void declare_number(Declaration& it, class StyleArguments& arguments);
  void check_command_line() const;
  void write(const std::string& file) const;
  void compare(const std::string& file, const std::set<std::string>& except) const;
  static std::string json_entry(const Declaration& declaration);
  std::string take_value(const std::string& name, const std::string& fallback) const;
  void set_variable(const std::string& name, const std::string& style,
                    const std::string& value) const;

  // A command object lives for one line only, the declarations for the whole deck.
  static std::vector<Declaration> declared_;
};

}  // namespace LAMMPS_NS

#endif
#endif
