// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_VERSION_H
#define RODPACK_VERSION_H

namespace rodpack {

/// Version of rodpack that this program was built from, such as "0.2".
const char* version();

/// Commit that this program was built from, as `git describe --always --dirty` names it: "-dirty"
/// behind it means that files differed from that commit; "unknown" for a tree without git.
const char* commit();

}  // namespace rodpack

#endif
