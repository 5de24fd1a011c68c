// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef INTEGRATE_CLASS

// clang-format off
IntegrateStyle(verlet/planar,RunPlanar)
// clang-format on

#else

#ifndef LMP_RUN_PLANAR_H
#define LMP_RUN_PLANAR_H

#include <functional>
#include <memory>
#include <vector>
#include "mpi_ranks.h"
#include "planar_contact_transfer.h"
#include "planar_owners.h"
#include "rodpack/planar/instructions.h"
#include "verlet.h"

namespace LAMMPS_NS {

/// run_style verlet/planar: runs a planar scene of rigid bodies in the planar engine
/// (rodpack/planar/scene.h) in all steps that nobody observes.
///
/// A step is observed if there is output, insertion, or a fix that acts at its end. Between two
/// such steps bodies and contacts are taken from LIGGGHTS, and they are given back in the step
/// before the next observed one, which is LIGGGHTS's own, with everything that belongs to it. Each
/// rank runs the bodies that fix multisphere keeps there. On one rank the engine takes a line of
/// fix insert/line in by itself, if nothing else happens in the step.
class RunPlanar : public Verlet {
 public:
  RunPlanar(class LAMMPS* lmp, int narg, char** arg);
  ~RunPlanar();

  void setup() override;
  void setup_minimal(int) override;
  void run(int steps) override;

 private:
  void read_options(int narg, char** arg);
  void check();
  void check_scene();
  void check_fixes() const;
  bigint next_step_of(int k) const;
  bigint next_observed_step() const;
  bool anywhere(bool here) const;
  void run_until(bigint last);
  void report(bigint steps) const;
  void run_engine(bigint observed, bigint last);
  void run_scene(bigint steps);
  void count_steps();

  // lines of new particles (run_planar_lines.cpp)
  class FixInsertLine* line_alone_in(bigint step) const;
  void take_in_line(class FixInsertLine& line);
  rodpack::PlanarBody new_body(int body, const std::vector<int>& atoms);

  // to the engine and back (run_planar_transfer.cpp)
  void take_over();
  void find_bodies();
  std::vector<rodpack::PlanarBody> take_bodies();
  rodpack::PlanarBody take_body(int body, const std::vector<int>& atoms);
  void check_plane(const std::vector<rodpack::PlanarBody>& bodies) const;
  rodpack::PlanarSettings settings(const std::vector<rodpack::PlanarBody>& bodies) const;
  void make_scene(const std::vector<rodpack::PlanarBody>& bodies,
                  const std::function<std::vector<rodpack::PlanarContactState>()>& contacts);
  std::vector<rodpack::PlanarContactState> take_contacts();
  void give_back();
  void give_bodies_back();
  std::vector<PlanarContactRecord> contacts_of_atoms() const;
  void exchange_and_list();

  double min_skin_, max_skin_;  // m; 0: from the particles
  rodpack::PlanarInstructions instructions_ = rodpack::PlanarInstructions::automatic;
  class FixMultisphereAB* bodies_ = NULL;
  class FixGravity* gravity_ = NULL;
  PlanarContactTransfer contacts_;
  PlanarOwners owners_;
  std::vector<int> order_;                // bodies of this rank in the order of the scene
  std::vector<std::vector<int> > atoms_;  // of each of them by their tags, ghosts among them
  std::unique_ptr<MpiRanks> ranks_;
  std::unique_ptr<rodpack::PlanarScene> scene_;
  bool lists_lack_atoms_ = false;          // LIGGGHTS's: those of a line that the engine took in
  rodpack::PlanarScene::Statistics done_;  // what the engine did in this run on this rank
};

}  // namespace LAMMPS_NS

#endif
#endif
