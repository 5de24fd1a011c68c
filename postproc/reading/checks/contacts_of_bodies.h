// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_CONTACTS_OF_BODIES_H
#define RODPACK_READING_CHECKS_CONTACTS_OF_BODIES_H

#include <string>

#include "reading/dump.h"

namespace rodpack {

/// Says why contacts are not those of these bodies, both of one timestep: one is of a particle that
/// is not there, or that lies elsewhere; empty if they are. Contacts without places (bix ... bjz)
/// pass, and so do bodies without.
std::string why_not_of_these_bodies(const Frame& contacts, const Frame& bodies);

/// @throws DataError with that reason.
void require_contacts_of_bodies(const Frame& contacts, const Frame& bodies);

/// @throws TooFewParticles when a frame of contacts has none.
void require_any_contact(const Frame& contacts);

}  // namespace rodpack

#endif
