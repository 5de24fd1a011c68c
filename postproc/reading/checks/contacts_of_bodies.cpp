// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/contacts_of_bodies.h"

#include <cmath>
#include <map>

#include "reading/number_text.h"

namespace rodpack {

std::string why_not_of_these_bodies(const Frame& contacts, const Frame& bodies) {
  for (const char* name : {"body_i", "body_j", "wall", "bix", "bjz"})
    if (!contacts.has(name)) return "";
  for (const char* name : {"x", "y", "z", "radius"})
    if (!bodies.has(name)) return "";
  std::map<double, std::size_t> rows;
  const auto& ids = bodies.column("id");
  for (std::size_t row = 0; row < bodies.rows; ++row) rows.emplace(ids[row], row);
  const auto place = vector_columns(bodies, {"x", "y", "z"});
  const auto& radius = bodies.column("radius");
  const auto& wall = contacts.column("wall");
  for (const bool second : {false, true}) {
    const auto& id = contacts.column(second ? "body_j" : "body_i");
    const auto said = second ? vector_columns(contacts, {"bjx", "bjy", "bjz"})
                             : vector_columns(contacts, {"bix", "biy", "biz"});
    for (std::size_t row = 0; row < contacts.rows; ++row) {
      if (second && wall[row] != 0) continue;
      const auto found = rows.find(id[row]);
      const auto particle = contacts.file + ": particle " + number_text(id[row]);
      if (found == rows.end()) return particle + " is not in " + bodies.file;
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        double off = (*said[c])[row] - (*place[c])[found->second];
        const double period = bodies.bounds[c][1] - bodies.bounds[c][0];
        if (bodies.periodic[c]) off -= period * std::round(off / period);
        square += off * off;
      }
      if (std::sqrt(square) > radius[found->second])
        return particle + " is " + number_text(std::sqrt(square), 3) + " m from its place in " +
               bodies.file;
    }
  }
  return "";
}

void require_contacts_of_bodies(const Frame& contacts, const Frame& bodies) {
  const auto why = why_not_of_these_bodies(contacts, bodies);
  if (!why.empty()) throw DataError(why + ": expected contacts and bodies of one run");
}

void require_any_contact(const Frame& contacts) {
  if (contacts.rows == 0)
    throw TooFewParticles(contacts.file + ":" + std::to_string(contacts.header_line) +
                          ": no contacts in the frame of timestep " +
                          std::to_string(contacts.timestep));
}

}  // namespace rodpack
