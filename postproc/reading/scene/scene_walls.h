// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_SCENE_SCENE_WALLS_H
#define RODPACK_READING_SCENE_SCENE_WALLS_H

#include "reading/packing.h"
#include "reading/scene/run_scene.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

// What of a scene's walls is the container. A plane bounds the particles on the side where it is
// free, or, if it is solid on both, where all centres lie beyond it; of several on one side the
// nearest counts. An upright cylinder around all centres is the side wall. Where no wall is left,
// the dump's box stands in; every wall that is not taken is named in the notes.

/// The container in a plane, y up. `frame`: of bodies, spheres or contacts.
Walls walls_of_scene(const RunScene& scene, const Frame& frame);

/// The container in space.
SpatialWalls spatial_walls_of_scene(const RunScene& scene, const Frame& bodies,
                                    std::size_t vertical);

}  // namespace rodpack

#endif
