// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_scene.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "atom.h"
#include "domain.h"
#include "fix_gravity.h"
#include "fix_mesh_surface.h"
#include "fix_property_global.h"
#include "fix_template_multisphere.h"
#include "fix_wall_gran.h"
#include "group.h"
#include "json_text.h"
#include "modify.h"
#include "run_files.h"
#include "stop_run.h"
#include "tri_mesh.h"
#include "update.h"
#include "wall_shape.h"

namespace LAMMPS_NS {

namespace {

/// Entries of a list or an object, one a line.
std::string lines_of(const std::vector<std::string>& entries) {
  std::string text;
  for (const std::string& entry : entries) text += (text.empty() ? "\n    " : ",\n    ") + entry;
  return text.empty() ? text : text + "\n  ";
}

std::string axis_name(int axis) { return json_string(std::string(1, "xyz"[axis])); }

/// The box around the nodes of a mesh, on all ranks.
void find_extent(TriMesh& mesh, MPI_Comm world, double (&low)[3], double (&high)[3]) {
  double bounds[6];  // the lower ones with the other sign, so that all are maxima
  std::fill_n(bounds, 6, -std::numeric_limits<double>::infinity());
  for (int element = 0; element < mesh.sizeLocal(); ++element)
    for (int corner = 0; corner < 3; ++corner) {
      double node[3];
      mesh.node(element, corner, node);
      for (int d = 0; d < 3; ++d) {
        bounds[d] = std::max(bounds[d], -node[d]);
        bounds[3 + d] = std::max(bounds[3 + d], node[d]);
      }
    }
  double all[6];
  MPI_Allreduce(bounds, all, 6, MPI_DOUBLE, MPI_MAX, world);
  for (int d = 0; d < 3; ++d) {
    low[d] = -all[d];
    high[d] = all[3 + d];
  }
}

/// Members of the JSON object of a wall.
std::string members_of(const WallShape& shape) {
  const std::string axis = "\"axis\": " + axis_name(shape.axis);
  if (shape.kind == WallShape::Kind::plane)
    return "\"kind\": \"plane\", " + axis + ", \"position_m\": " + json_number(shape.position) +
           ", \"free_side\": " + std::to_string(shape.free_side);
  return "\"kind\": \"cylinder\", " + axis + ", \"middle_m\": " + json_vector(shape.middle) +
         ", \"radius_m\": " + json_number(shape.radius);
}

}  // namespace

DumpScene::DumpScene(LAMMPS* lmp, int narg, char** arg) : FileDump(lmp, narg, arg) {
  if (narg > 5) stop_run(lmp, *this, std::string("unknown argument ") + arg[5]);
  require_ending({".json"});
}

void DumpScene::init_style() {
  if (domain->triclinic) stop_run(lmp, *this, "does not support a triclinic box");
  require_si_and_folder("keys");
}

void DumpScene::write() {
  const std::string text = scene();
  if (me != 0) return;
  const std::string fault = write_whole(file_name(), text);
  if (!fault.empty()) stop_run_from_one_rank(lmp, *this, fault);
}

std::string DumpScene::scene() const {
  return "{\n  \"format\": \"rodpack-scene 1\",\n  \"units\": \"si\",\n  \"timestep\": " +
         std::to_string(update->ntimestep) + ",\n  \"timestep_s\": " + json_number(update->dt) +
         ",\n  \"box\": " + box() + ",\n  \"gravity_m_s2\": " + gravity() + ",\n  \"walls\": [" +
         walls() + "],\n  \"friction\": " + friction() + ",\n  \"templates\": [" + templates() +
         "]\n}\n";
}

std::string DumpScene::box() const {
  std::string periodic;
  for (const int each : {domain->xperiodic, domain->yperiodic, domain->zperiodic})
    periodic += std::string(periodic.empty() ? "" : ", ") + (each ? "true" : "false");
  const double low[] = {domain->boxlo[0], domain->boxlo[1], domain->boxlo[2]};
  const double high[] = {domain->boxhi[0], domain->boxhi[1], domain->boxhi[2]};
  return "{\"low_m\": " + json_vector(low) + ", \"high_m\": " + json_vector(high) +
         ", \"periodic\": [" + periodic + "]}";
}

/// The acceleration of all particles; null where a fix gravity has a part of them alone.
std::string DumpScene::gravity() const {
  double sum[3] = {0.0, 0.0, 0.0};
  for (int k = 0; k < modify->nfix; ++k) {
    FixGravity* const fix = dynamic_cast<FixGravity*>(modify->fix[k]);
    if (!fix) continue;
    if (fix->igroup != 0) return "null";
    double each[3];
    fix->get_gravity(each);
    for (int d = 0; d < 3; ++d) sum[d] += each[d];
  }
  return json_vector(sum);
}

std::string DumpScene::walls() const {
  std::vector<std::string> entries;
  for (int k = 0; k < modify->nfix; ++k) {
    Fix& fix = *modify->fix[k];
    std::string begin =
        "{\"fix\": " + json_string(fix.id) + ", \"style\": " + json_string(fix.style) + ", ";
    if (fix.igroup != 0) begin += "\"group\": " + json_string(group->names[fix.igroup]) + ", ";
    if (FixWallGran* const wall = dynamic_cast<FixWallGran*>(&fix)) {
      const WallShape shape = shape_of(*wall);
      entries.push_back(shape.kind == WallShape::Kind::none
                            ? meshes_of(*wall, begin)
                            : begin + members_of(shape) + ", \"atom_type\": " +
                                  std::to_string(wall->atom_type_wall()) + "}");
      if (entries.back().empty()) entries.pop_back();
    } else if (std::strncmp(fix.style, "wall/", 5) == 0) {
      entries.push_back(begin + "\"kind\": \"other\"}");
    }
  }
  return lines_of(entries);
}

std::string DumpScene::meshes_of(FixWallGran& wall, const std::string& begin) const {
  std::string text;
  for (int k = 0; k < wall.n_meshes(); ++k) {
    FixMeshSurface& fix = *wall.mesh_list()[k];
    TriMesh& mesh = *fix.triMesh();
    double low[3], high[3];
    find_extent(mesh, world, low, high);
    text += (k ? ",\n    " : "") + begin + "\"kind\": \"mesh\", \"mesh\": " + json_string(fix.id) +
            ", \"triangles\": " + std::to_string(mesh.sizeGlobal()) +
            ", \"low_m\": " + json_vector(low) + ", \"high_m\": " + json_vector(high) +
            ", \"moves\": " + (mesh.isMoving() ? "true" : "false") +
            ", \"atom_type\": " + std::to_string(fix.atomTypeWall()) + "}";
  }
  return text;
}

/// Coefficients between the atom types, row by row; null where the deck has none.
std::string DumpScene::friction() const {
  const int types = atom->ntypes;
  FixPropertyGlobal* const property = static_cast<FixPropertyGlobal*>(modify->find_fix_property(
      "coefficientFriction", "property/global", "peratomtypepair", types, types, style, false));
  if (!property) return "null";
  std::string rows;
  for (int i = 0; i < types; ++i) {
    std::string row;
    for (int j = 0; j < types; ++j)
      row += (j ? ", " : "") + json_number(property->compute_array(i, j));
    rows += (i ? ", [" : "[") + row + "]";
  }
  return "[" + rows + "]";
}

/// The bodies' templates: `type` is that of the dump of bodies, `atom_type` that of the friction.
std::string DumpScene::templates() const {
  std::vector<std::string> entries;
  for (int k = 0; k < modify->nfix; ++k) {
    FixTemplateMultisphere* const body = dynamic_cast<FixTemplateMultisphere*>(modify->fix[k]);
    if (!body) continue;
    const int first = body->mintype(), last = body->maxtype();
    entries.push_back("{\"fix\": " + json_string(body->id) +
                      ", \"type\": " + std::to_string(body->type()) +
                      ", \"atom_type\": " + (first == last ? std::to_string(first) : "null") + "}");
  }
  return lines_of(entries);
}

}  // namespace LAMMPS_NS
