// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_VTK_EXPORT_H
#define RODPACK_FIGURES_VTK_EXPORT_H

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "reading/dump.h"

class vtkDataSetAttributes;
class vtkPolyData;

namespace rodpack {

/// What the rows of a dump are; decides geometry and arrays of the VTK file.
///  - bodies: one vertex per particle at its centre of mass;
///  - spheres: one vertex per primary sphere (glyph with `radius_m`);
///  - contacts: one line per contact, from centre of mass to centre of mass (wall: contact point).
/// Three columns that form a vector become one array with the unit in its name: `velocity_m_s`,
/// `angular_velocity_rad_s`, `contact_force_N`, `contact_normal`; known scalars get their unit
/// appended (`radius_m`, `overlap_n_m`, `area_m2`, ...); every other column keeps its name.
enum class DumpKind { bodies, spheres, contacts };

/// Tells the kind of a frame by its columns. @throws DataError when they fit none.
DumpKind kind_of(const Frame& frame);
/// The name of a kind, as in the names of files: "bodies".
std::string kind_name(DumpKind kind);

/// Writes one frame as a compressed VTK PolyData file (.vtp), lengths in m.
/// @throws DataError when a column is missing or the file cannot be written.
void write_vtp(const Frame& frame, DumpKind kind, const std::string& file);

/// Adds the columns of a frame but for those in `used`, one value per row, named as above.
void add_frame_arrays(const Frame& frame, std::set<std::string> used,
                      vtkDataSetAttributes* attributes);
/// Writes a compressed .vtp. @throws DataError when that fails.
void write_poly_data(vtkPolyData* data, const std::string& file);

/// Writes every frame of every dump as `folder`/<kind>.<timestep>.vtp and, per kind, the time index
/// `folder`/<kind>.pvd, which ParaView opens; the files written are returned. Times are
/// timestep * `timestep_s`, in s; 0 = unknown: the index then holds timesteps. `capsules`: of
/// bodies write_capsules() too, as capsules.<timestep>.vtp. Spheres of a stock dump are written as
/// the bodies that they make; `contacts_of`: what makes contacts of LIGGGHTS's own dump local,
/// which is refused without. A frame for which it throws NoSuchFrame is passed over.
std::vector<std::string> export_vtk(const std::vector<std::string>& files,
                                    const std::string& folder, double timestep_s,
                                    bool capsules = false,
                                    const std::function<Frame(const Frame&)>& contacts_of = {});

}  // namespace rodpack

#endif
