// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS

// clang-format off
FixStyle(insert/line,FixInsertLine)
// clang-format on

#else

#ifndef RODPACK_FIX_INSERT_LINE_H
#define RODPACK_FIX_INSERT_LINE_H

#include <memory>
#include <vector>

#include "fix.h"
#include "line_options.h"

namespace LAMMPS_NS {

class FixMultisphere;
class Irregular;
class RanPark;

/// fix insert/line: inserts horizontal lines of particles, n side by side at one height, each at a
/// random angle in the x-y plane and with a random horizontal velocity, the next line after a given
/// fall or time. All ranks draw the same numbers, so that the particles do not depend on the number
/// of ranks.
class FixInsertLine : public Fix {
 public:
  FixInsertLine(LAMMPS* lmp, int narg, char** arg);
  ~FixInsertLine();

  int setmask();
  void init();
  void setup(int);
  void pre_exchange();
  void reset_timestep(bigint new_step, bigint old_step);

  void write_restart(FILE* file);
  void restart(char* buffer);

  // LIGGGHTS sizes its cutoffs and material tables from these before a particle exists.
  int min_type();
  int max_type();
  double min_rad(int type);
  double max_rad(int type);
  double extend_cut_ghost();

  /// Whether all that it inserts are bodies, whose spheres stay off the plane where the coordinate
  /// `axis` (0 or 1) is `position` (m).
  bool keeps_clear_of(int axis, double position) const;

  double compute_scalar() { return inserted_; }
  double compute_vector(int index);

 private:
  struct Source {
    FixTemplateSphere* particles;
    int total;     // of its particles over the whole run
    int inserted;  // so far
  };
  /// The numbers drawn for one particle of a line, in the order of the draws.
  struct Draw {
    Source* source;
    double size;       // draw from [0, 1) for its diameter
    double angle;      // of its body x axis, rad
    double velocity;   // along x, m/s
    double x;          // centre of mass, m
    bool mine;         // this rank owns the spot
    int first_sphere;  // index into the line's spheres
  };
  struct Sphere {
    double x[3], radius;
    int particle;  // of the line, counted from 0
  };

  double line_interval() const;
  bigint line_step(int line) const;
  std::vector<Draw> draw_line();
  void prepare(const Draw& draw) const;
  std::vector<Sphere> spheres_of(std::vector<Draw>& line) const;
  class SpheresAlongX;
  void check_overlaps(const std::vector<Draw>& line, const std::vector<Sphere>& spheres) const;
  void create(const std::vector<Draw>& line, const std::vector<Sphere>& spheres);
  bool mine(const double* x) const;

  const LineOptions options_;
  std::vector<Source> sources_;
  std::unique_ptr<RanPark> random_;
  std::unique_ptr<Irregular> irregular_;
  FixMultisphere* multisphere_ = NULL;

  // State. Line k starts at anchor_time_ + (step - anchor_step_) dt = k intervals after the first.
  int lines_ = 0, inserted_ = 0;
  double mass_inserted_ = 0;
  bigint anchor_step_ = -1, last_line_step_ = -1;
  double anchor_time_ = 0, time_step_ = 0;
};

}  // namespace LAMMPS_NS

#endif
#endif
