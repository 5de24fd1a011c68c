// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_contact_overlap.h"

#include <mpi.h>
#include <algorithm>
#include <set>
#include <utility>
#include "gather.h"
#include "particle_identity.h"
#include "style_arguments.h"

namespace LAMMPS_NS {

ComputeContactOverlap::ComputeContactOverlap(LAMMPS* lmp, int& iarg, int narg, char** arg)
    : VectorCompute(lmp, iarg, narg, arg, 3, false),
      recorder_(lmp, std::string("compute ") + style,
                [this](bigint step) { return matchstep(step) != 0; }) {
  timeflag = 1;
  StyleArguments arguments(lmp, narg, arg, iarg, "Compute");
  limit_ = arguments.number("L", a_length);
  arguments.require_end();
  ++iarg;
  arguments.require_group_all("counts all contacts");
}

void ComputeContactOverlap::init() { recorder_.check_models(); }

void ComputeContactOverlap::evaluate() {
  const ParticleIdentity particles(lmp);
  double deepest = 0.0;
  bigint contacts = 0;
  std::vector<int> deep;  // pairs of particle ids, flat
  for (const ContactRecord& contact : recorder_.collect()) {
    if (!contact.primary) continue;
    ++contacts;
    deepest = std::max(deepest, contact.overlap);
    if (contact.j < 0 || contact.overlap <= limit_) continue;
    const std::pair<int, int> ids =
        std::minmax({particles.id_of(contact.i), particles.id_of(contact.j)});
    deep.push_back(ids.first);
    deep.push_back(ids.second);
  }

  // Two chains may touch on several ranks, so the pairs are counted where all of them are known.
  const std::vector<int> all = gather_on_all(world, deep);
  std::set<std::pair<int, int>> pairs;
  for (std::size_t k = 0; k < all.size(); k += 2) pairs.insert({all[k], all[k + 1]});

  bigint all_contacts = 0;
  MPI_Allreduce(&contacts, &all_contacts, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  MPI_Allreduce(&deepest, &vector[1], 1, MPI_DOUBLE, MPI_MAX, world);
  vector[0] = static_cast<double>(pairs.size());
  vector[2] = static_cast<double>(all_contacts);
}

}  // namespace LAMMPS_NS
