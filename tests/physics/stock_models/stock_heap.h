// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_STOCK_HEAP_H
#define RODPACK_TESTS_STOCK_HEAP_H

#include <filesystem>
#include <string>

namespace rodpack::test {

/// Twelve rods of three spheres, of LIGGGHTS's own multisphere and contact law, that have fallen
/// onto two triangles, x periodic. Its own dumps, pairs.dump, walls.dump and spheres.dump, lie in
/// the folder that is returned beside ours of the same step, contacts.dump and bodies.dump.
/// `tangential`: the model of the tangential force, "history" or "no_history".
std::filesystem::path stock_heap(const std::string& tangential);

/// The words behind the two computes of contacts in that deck.
inline const std::string stock_words = "pos id force delta";

/// The options that make rodpack read them, in that folder.
inline const std::string stock_contacts = "--local " + stock_words + " --local-walls walls.dump";

}  // namespace rodpack::test

#endif
