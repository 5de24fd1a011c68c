// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies and contacts of this rank, from LIGGGHTS to the planar engine and back.
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_gravity.h"
#include "fix_multisphere_ab.h"
#include "modify.h"
#include "multisphere.h"
#include "neighbor.h"
#include "planar_stop.h"
#include "rodpack/geometry/order_by_place.h"
#include "rodpack/planar/scene.h"
#include "run_planar.h"
#include "running_dashpots.h"
#include "update.h"

namespace LAMMPS_NS {

/// Finds the bodies of this rank, in an order that follows from their positions and tags, so that a
/// restart keeps it, and the atoms of each.
void RunPlanar::find_bodies() {
  owners_.renew(*bodies_);
  const int bodies = bodies_->n_body();
  const auto tag_of = [&](int body) { return bodies_->data().tag(body); };
  std::vector<rodpack::TaggedPlace> places;
  double reach = 0.0;
  for (int body = 0; body < bodies; ++body) {
    double x[3];
    bodies_->data().xcm(x, body);
    places.push_back({x[0], x[1], tag_of(body)});
    reach = std::max(reach, bodies_->data().r_bound(body));
  }
  // Bodies next to other ranks come last, since they wait for messages.
  order_ = rodpack::order_by_place(places, 2.0 * reach, comm->nprocs > 1);
  std::vector<int> place(bodies);
  for (int k = 0; k < bodies; ++k) place[order_[k]] = k;
  atoms_.assign(bodies, std::vector<int>());
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    const int tag = bodies_->belongs_to(i), body = tag < 0 ? -1 : bodies_->data().map(tag);
    if (body >= 0)
      atoms_[place[body]].push_back(i);
    else if (i < atom->nlocal && (tag < 0 || owners_.of_body(i) < 0 || comm->nprocs == 1))
      refuse_from_one_rank(lmp, "atom " + std::to_string(atom->tag[i]) +
                                    " belongs to no body of fix multisphere/ab");
  }
  for (int k = 0; k < bodies; ++k) {
    std::sort(atoms_[k].begin(), atoms_[k].end(),
              [&](int i, int j) { return atom->tag[i] < atom->tag[j]; });
    const int expected = bodies_->data().nrigid(order_[k]);
    if (static_cast<int>(atoms_[k].size()) != expected)
      refuse_from_one_rank(lmp, "body " + std::to_string(tag_of(order_[k])) + " has " +
                                    std::to_string(atoms_[k].size()) +
                                    " spheres on its rank, expected " + std::to_string(expected));
  }
}

rodpack::PlanarBody RunPlanar::take_body(int body, const std::vector<int>& atoms) {
  rodpack::PlanarBody taken = bodies_->to_planar(body, atoms);
  taken.type = atom->type[atoms[0]] - 1;
  return taken;
}

std::vector<rodpack::PlanarBody> RunPlanar::take_bodies() {
  std::vector<rodpack::PlanarBody> bodies;
  for (size_t k = 0; k < order_.size(); ++k) bodies.push_back(take_body(order_[k], atoms_[k]));
  return bodies;
}

void RunPlanar::check_plane(const std::vector<rodpack::PlanarBody>& bodies) const {
  double z[2] = {-1e300, -1e300};  // of the highest sphere, and the lowest times -1
  for (const std::vector<int>& atoms : atoms_) {
    z[0] = std::max(z[0], atom->x[atoms[0]][2]);
    z[1] = std::max(z[1], -atom->x[atoms[0]][2]);
  }
  ranks_->largest(z, 2);
  for (const rodpack::PlanarBody& body : bodies) {
    if (z[0] + z[1] <= 1e-9 * body.radius) continue;
    char planes[128];
    std::snprintf(planes, sizeof planes, "spheres lie in planes from z = %g to %g m", -z[1], z[0]);
    refuse_from_one_rank(lmp, std::string(planes) + ", expected one plane z = const");
  }
}

rodpack::PlanarSettings RunPlanar::settings(const std::vector<rodpack::PlanarBody>& bodies) const {
  rodpack::PlanarSettings settings;
  settings.dt = update->dt;
  settings.order = bodies_->order();
  settings.slots = contacts_.slots();
  settings.events = bodies_->follows_events();
  settings.total_force_cap = contacts_.has_total_cap();
  settings.dashpot_relaxation = dashpot_relaxation(lmp);
  settings.mass_scaling = bodies_->mass_scaling();
  settings.types = atom->ntypes;
  settings.laws = contacts_.laws();
  settings.walls = contacts_.walls();
  if (gravity_) {
    double acceleration[3];
    gravity_->get_gravity(acceleration);
    std::copy(acceleration, acceleration + 2, settings.gravity);
  }
  // The smallest radius and the narrowest sub-box, times -1, and the largest radius.
  double largest[4] = {-1e300, -(domain->subhi[0] - domain->sublo[0]),
                       -(domain->subhi[1] - domain->sublo[1]), 0.0};
  for (const rodpack::PlanarBody& body : bodies) {
    largest[0] = std::max(largest[0], -body.radius);
    largest[3] = std::max(largest[3], body.radius);
  }
  ranks_->largest(largest, 4);
  settings.instructions = instructions_;
  // A pair that parts has to be listed still.
  const double least = (neighbor->contactDistanceFactor - 1.0) * largest[3];
  if (min_skin_ > 0.0 && min_skin_ < least) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "skin is at least %g m, expected %g m or more: the contact distance factor less 1 "
        "times the largest radius",
        min_skin_, least);
    refuse(lmp, text);
  }
  settings.min_skin = min_skin_ > 0.0 ? min_skin_ : std::max(-0.12 * largest[0], least);
  settings.max_skin = max_skin_ > 0.0 ? max_skin_ : std::max(-0.6 * largest[0], settings.min_skin);
  // LIGGGHTS passes atoms and bodies on to the next rank, not beyond it; they may have gone half
  // its skin before.
  for (int axis = 0; axis < 2; ++axis)
    if (comm->procgrid[axis] > 1) settings.farthest[axis] = -largest[1 + axis] - neighbor->skin;
  return settings;
}

/// The contacts of the bodies of this rank, whichever rank's lists LIGGGHTS has them in.
std::vector<rodpack::PlanarContactState> RunPlanar::take_contacts() {
  std::vector<PlanarContactRecord> records = contacts_.read(owners_);
  struct TaggedSphere {
    int tag, body, sphere;
  };
  const auto before = [](const TaggedSphere& a, const TaggedSphere& b) { return a.tag < b.tag; };
  std::vector<TaggedSphere> first, all;  // the first sphere of each body; all spheres
  for (int body = 0; body < scene_->size_with_ghosts(); ++body)
    if (scene_->spheres(body) > 0) first.push_back({scene_->sphere_tag(body, 0), body, 0});
  std::sort(first.begin(), first.end(), before);
  all.reserve(first.empty() ? 0 : first.size() * scene_->spheres(first[0].body));
  for (const TaggedSphere& at : first)
    for (int sphere = 0; sphere < scene_->spheres(at.body); ++sphere)
      all.push_back({scene_->sphere_tag(at.body, sphere), at.body, sphere});
  if (!std::is_sorted(all.begin(), all.end(), before)) std::sort(all.begin(), all.end(), before);
  const auto sphere_of = [&](int tag) -> const TaggedSphere& {
    const auto found = std::lower_bound(all.begin(), all.end(), TaggedSphere{tag, 0, 0}, before);
    if (found == all.end() || found->tag != tag)
      refuse_from_one_rank(
          lmp, "a contact of atom " + std::to_string(tag) + " is on a rank that does not know it");
    return *found;
  };
  std::vector<rodpack::PlanarContactState> contacts;
  contacts.reserve(records.size());
  for (const PlanarContactRecord& record : records) {
    contacts.push_back(record.state);
    rodpack::PlanarContactState& contact = contacts.back();
    const TaggedSphere& i = sphere_of(record.atom);
    contact.body_i = i.body;
    contact.sphere_i = i.sphere;
    contact.body_j = record.partner;
    contact.sphere_j = 0;
    if (record.partner < 0) continue;
    const TaggedSphere& j = sphere_of(record.partner);
    contact.body_j = j.body;
    contact.sphere_j = j.sphere;
  }
  return contacts;
}

/// `contacts` is asked for them once the scene is there, which knows where spheres are.
void RunPlanar::make_scene(
    const std::vector<rodpack::PlanarBody>& bodies,
    const std::function<std::vector<rodpack::PlanarContactState>()>& contacts) {
  check_plane(bodies);
  try {
    scene_.reset(new rodpack::PlanarScene(settings(bodies), bodies, ranks_.get()));
    scene_->set_contacts(contacts());
  } catch (const std::invalid_argument& reason) {
    refuse_from_one_rank(lmp, reason.what());
  }
}

void RunPlanar::take_over() {
  find_bodies();
  make_scene(take_bodies(), [this] { return take_contacts(); });
}

/// The contacts of the atoms of this rank, each as its atom sees it.
std::vector<PlanarContactRecord> RunPlanar::contacts_of_atoms() const {
  std::vector<std::vector<PlanarContactRecord> > records(comm->nprocs);
  const std::vector<rodpack::PlanarContactState> contacts = scene_->contacts();
  records[comm->me].reserve(2 * contacts.size());
  for (const rodpack::PlanarContactState& contact : contacts) {
    const auto send = [&](int body, int sphere, int partner, double sign) {
      if (body >= scene_->size()) return;  // a ghost: its own rank sends it
      const int i = atoms_[body][sphere];
      records[owners_.of_atom(i)].push_back(
          {atom->tag[i], partner, {sign * contact.normal[0], sign * contact.normal[1]}, contact});
    };
    const bool wall = contact.body_j < 0;
    send(contact.body_i, contact.sphere_i,
         wall ? contact.body_j : scene_->sphere_tag(contact.body_j, contact.sphere_j), 1.0);
    if (wall) continue;
    send(contact.body_j, contact.sphere_j, scene_->sphere_tag(contact.body_i, contact.sphere_i),
         -1.0);
  }
  return exchange_records(world, std::move(records));
}

/// Exchanges atoms and builds new lists, as a step of Verlet does between pre_exchange() of the
/// fixes and the forces.
void RunPlanar::exchange_and_list() {
  domain->pbc();
  if (domain->box_change) {
    domain->reset_box();
    comm->setup();
    if (neighbor->style) neighbor->setup_bins();
  }
  comm->exchange();
  comm->borders();
  modify->pre_neighbor();
  neighbor->build();
}

void RunPlanar::give_bodies_back() {
  bodies_->begin_planar();
  for (size_t k = 0; k < order_.size(); ++k)
    bodies_->from_planar(order_[k], atoms_[k], scene_->body(static_cast<int>(k)));
  bodies_->finish_planar();
}

void RunPlanar::give_back() {
  give_bodies_back();
  const std::vector<PlanarContactRecord> contacts = contacts_of_atoms();
  scene_.reset();
  // The next step moves the spheres again, and then decides itself; but contacts of now have to
  // find their pairs in the list.
  const bigint dangerous = neighbor->ndanger;  // the list was not in use meanwhile
  if (lists_lack_atoms_ || !neighbor->dist_check || neighbor->check_distance()) {
    bodies_->keep_loads();
    modify->pre_exchange();
    contacts_.write_to_atoms(contacts);
    exchange_and_list();
    bodies_->restore_loads();
    lists_lack_atoms_ = false;
  } else {
    contacts_.write_to_lists(contacts);
  }
  neighbor->ndanger = dangerous;
}

}  // namespace LAMMPS_NS
