// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_STOCK_LOCAL_CONTACTS_H
#define RODPACK_ANALYSIS_STOCK_LOCAL_CONTACTS_H

#include <string>
#include <vector>

#include "reading/dump.h"

namespace rodpack {

// LIGGGHTS's `dump local` of its `compute pair/gran/local` or `wall/gran/local` names its columns
// after the compute, c_ID[1] and so on. What they hold follows from the words behind that compute,
// in an order of its own whatever theirs is.

/// What tells contacts in such dumps.
struct LocalContactOptions {
  std::vector<std::string> words;       // behind the compute; none: dumps are `dump contact/gran`
  std::vector<std::string> wall_files;  // names and patterns of dumps of `compute wall/gran/local`
};

/// Returns a frame of contacts of one of `compute pair/gran/local`, and of the wall files' frame of
/// the same timestep, if there are any. @throws DataError as the two functions below, NoSuchFrame
/// where the walls lack the timestep.
Frame read_local_contacts(const Frame& pairs, const LocalContactOptions& options,
                          const Frame& spheres);

/// What such contacts do not tell, for reports.
std::string note_on_local_contacts(const LocalContactOptions& options);

/// All words that may stand behind the compute.
std::vector<std::string> local_contact_words();

/// Returns a frame of contacts as `dump contact/gran` has them, but for `overlap_t`, of the
/// contacts between particles. `words`: those behind the compute; `id` and `force` are needed.
/// `spheres`: the stock dump of all spheres that as_bodies() takes, at the same timestep: it tells
/// places, radii and bodies. Contacts within a body are left out. What `pos` says has to agree.
/// @throws DataError naming the word, the number of columns, or the contact that does not fit.
Frame contacts_of_local_dump(const Frame& pairs, const std::vector<std::string>& words,
                             const Frame& spheres);

/// Adds those with meshes, of `compute wall/gran/local` with the same words, among which `pos` is
/// needed, at the same timestep. Stock LIGGGHTS lists no contacts with primitive walls. A wall's
/// normal points from the contact point to the sphere's centre. @throws DataError as above.
void add_contacts_of_wall_dump(const Frame& walls, const std::vector<std::string>& words,
                               const Frame& spheres, Frame& contacts);

}  // namespace rodpack

#endif
