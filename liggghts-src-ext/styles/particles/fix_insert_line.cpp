// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_insert_line.h"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "atom.h"
#include "comm.h"
#include "container.h"
#include "domain.h"
#include "fix_gravity.h"
#include "fix_template_multisphere.h"
#include "fix_template_spherocylinder.h"
#include "irregular.h"
#include "modify.h"
#include "multisphere_fix.h"
#include "particleToInsert.h"
#include "prime_seed.h"
#include "random_park.h"
#include "stop_run.h"
#include "update.h"

namespace LAMMPS_NS {

using namespace FixConst;

namespace {

bool is_multisphere(const FixTemplateSphere* particles) {
  return dynamic_cast<const FixTemplateMultisphere*>(particles) != NULL;
}

}  // namespace

FixInsertLine::FixInsertLine(LAMMPS* lmp, int narg, char** arg)
    : Fix(lmp, narg, arg),
      options_(read_line_options(lmp, narg, arg)),
      random_(new RanPark(lmp, prime_seed(options_.seed).c_str(), false)),
      irregular_(new Irregular(lmp)) {
  const std::vector<int> numbers = options_.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    sources_.push_back({options_.parts[i].particles, numbers[i], 0});

  restart_global = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  scalar_flag = vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
}

FixInsertLine::~FixInsertLine() {}

int FixInsertLine::setmask() { return PRE_EXCHANGE; }

void FixInsertLine::init() {
  const int bodies = modify->n_fixes_style("multisphere");
  multisphere_ = multisphere_fix(modify);
  for (const Source& source : sources_)
    if (is_multisphere(source.particles) && bodies != 1) {
      const std::string message = std::string("template ") + source.particles->id +
                                  " needs exactly one fix multisphere, got '" +
                                  std::to_string(bodies) + "'";
      stop_run(lmp, *this, message);
    }
  if (options_.fall > 0 && options_.gravity == 0 && !modify->find_fix_style("gravity", 0))
    stop_run(lmp, *this, "fall needs a fix gravity or keyword gravity");
}

// This is not done in init(), where a fix gravity defined later does not know its direction yet.
void FixInsertLine::setup(int) {
  const bigint now = update->ntimestep;
  if (anchor_step_ < 0) {
    anchor_step_ = now + 1;
    time_step_ = update->dt;
  } else if (time_step_ != update->dt) {
    anchor_time_ += static_cast<double>(now - anchor_step_) * time_step_;
    anchor_step_ = now;
    time_step_ = update->dt;
  }
  if (line_interval() < time_step_) {
    const bool by_time = options_.interval > 0;
    char text[160];
    std::snprintf(text, sizeof text, "%s is '%.15g', expected at least a time step between lines",
                  by_time ? "interval" : "fall", by_time ? options_.interval : options_.fall);
    stop_run(lmp, *this, text);
  }
  next_reneighbor = inserted_ < options_.total ? std::max(now + 1, line_step(lines_)) : -1;
}

double FixInsertLine::line_interval() const {
  if (options_.interval > 0) return options_.interval;
  double downward = options_.gravity;
  if (downward == 0) {
    double gravity[3];
    static_cast<FixGravity*>(modify->find_fix_style("gravity", 0))->get_gravity(gravity);
    downward = -gravity[1];
  }
  if (!(downward > 0)) stop_run(lmp, *this, "fall needs gravity along -y");
  return std::sqrt(2. * options_.fall / downward);
}

bigint FixInsertLine::line_step(int line) const {
  // Beyond the last step that there can be, a line does not come.
  const double steps = std::min((line * line_interval() - anchor_time_) / time_step_, 1e18);
  return anchor_step_ + std::llround(steps);
}

void FixInsertLine::pre_exchange() {
  const bigint now = update->ntimestep;
  if (next_reneighbor != now || last_line_step_ == now) return;
  std::vector<Draw> line = draw_line();
  const std::vector<Sphere> spheres = spheres_of(line);
  check_overlaps(line, spheres);
  create(line, spheres);

  for (const Draw& draw : line) ++draw.source->inserted;
  inserted_ += static_cast<int>(line.size());
  ++lines_;
  last_line_step_ = now;
  next_reneighbor = inserted_ < options_.total ? line_step(lines_) : -1;
}

std::vector<FixInsertLine::Draw> FixInsertLine::draw_line() {
  const int n = std::min(options_.per_line, options_.total - inserted_);
  const double cell = (options_.x_high - options_.x_low) / n;
  std::vector<int> left;
  for (const Source& source : sources_) left.push_back(std::max(0, source.total - source.inserted));

  std::vector<Draw> line;
  for (int i = 0; i < n; ++i) {
    // Drawn without putting back, so that the fractions are met exactly at the end.
    int sum = 0;
    for (int number : left) sum += number;
    double choice = random_->uniform() * sum;
    std::size_t s = 0;
    while (s + 1 < left.size() && choice >= left[s]) choice -= left[s++];
    --left[s];
    Draw draw;
    draw.source = &sources_[s];
    draw.size = random_->uniform();
    draw.angle =
        options_.angle_low + (options_.angle_high - options_.angle_low) * random_->uniform();
    draw.velocity = options_.velocity_low +
                    (options_.velocity_high - options_.velocity_low) * random_->uniform();
    draw.x = options_.x_low + (i + 0.5) * cell;
    const double centre[3] = {draw.x, options_.y, options_.z};
    draw.mine = mine(centre);
    draw.first_sphere = 0;
    line.push_back(draw);
  }
  return line;
}

bool FixInsertLine::keeps_clear_of(int axis, double position) const {
  double reach = 0.0;
  for (const Source& source : sources_) {
    if (!is_multisphere(source.particles)) return false;
    reach = std::max(reach, source.particles->max_r_bound());
  }
  // Across the line, particles fit their cells.
  return axis == 0 ? position <= options_.x_low || position >= options_.x_high
                   : std::fabs(position - options_.y) >= reach;
}

/// Whether this rank owns the point x. Sub-domains are half-open, and those at the edge of the box
/// reach outwards without end, so that exactly one rank owns a point, also one outside a
/// shrink-wrapped box.
bool FixInsertLine::mine(const double* x) const {
  for (int d = 0; d < 3; ++d) {
    if (x[d] < domain->sublo[d] && comm->myloc[d] > 0) return false;
    if (x[d] >= domain->subhi[d] && comm->myloc[d] < comm->procgrid[d] - 1) return false;
  }
  return true;
}

/// Makes the template's `pti`, its particle on the way into the simulation, the one drawn.
void FixInsertLine::prepare(const Draw& draw) const {
  FixTemplateSphere& particles = *draw.source->particles;
  if (auto* rods = dynamic_cast<FixTemplateSpherocylinder*>(&particles))
    rods->prepare_single(draw.size);
  else
    particles.randomize_single();  // the public version's templates are of one size
  double x[3] = {draw.x, options_.y, options_.z}, v[3] = {draw.velocity, 0., 0.},
         omega[3] = {0., 0., 0.};
  double quat[4] = {std::cos(0.5 * draw.angle), 0., 0., std::sin(0.5 * draw.angle)};
  particles.pti->set_x_v_omega(x, v, omega, quat);
  particles.pti->groupbit |= groupbit;
}

std::vector<FixInsertLine::Sphere> FixInsertLine::spheres_of(std::vector<Draw>& line) const {
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < line.size(); ++i) {
    prepare(line[i]);
    line[i].first_sphere = static_cast<int>(spheres.size());
    const ParticleToInsert& particle = *line[i].source->particles->pti;
    for (int j = 0; j < particle.nparticles; ++j) {
      const double* x = particle.x_ins[j];
      spheres.push_back({{x[0], x[1], x[2]}, particle.radius_ins[j], static_cast<int>(i)});
    }
  }
  return spheres;
}

/// Spheres of a line in the order of x, to find those near a place without going through all.
class FixInsertLine::SpheresAlongX {
 public:
  /// `period` is that of the scene along x, m; 0 where it is not periodic.
  SpheresAlongX(const std::vector<Sphere>& spheres, double period) : widest_(0.0), period_(period) {
    for (const Sphere& sphere : spheres) {
      sorted_.push_back(&sphere);
      widest_ = std::max(widest_, sphere.radius);
    }
    std::sort(sorted_.begin(), sorted_.end(),
              [](const Sphere* a, const Sphere* b) { return a->x[0] < b->x[0]; });
  }

  /// Calls visitor(sphere) for all that a sphere of this radius at x may touch, and some others.
  template <class Visitor>
  void visit(double x, double radius, Visitor visitor) const {
    for (int image = period_ > 0.0 ? -1 : 0; image <= (period_ > 0.0 ? 1 : 0); ++image) {
      const double here = x + image * period_, reach = radius + widest_;
      auto next = std::lower_bound(sorted_.begin(), sorted_.end(), here - reach,
                                   [](const Sphere* a, double low) { return a->x[0] < low; });
      for (; next != sorted_.end() && (*next)->x[0] <= here + reach; ++next) visitor(**next);
    }
  }

 private:
  std::vector<const Sphere*> sorted_;
  double widest_, period_;
};

void FixInsertLine::check_overlaps(const std::vector<Draw>& line,
                                   const std::vector<Sphere>& spheres) const {
  struct {
    double depth;
    int rank;
  } worst = {0., comm->me}, all;
  // Which particle of the line it is, and the tag of the sphere in its way: 0 if that is one of
  // another particle of the line.
  int found[2] = {-1, 0};
  const auto keep_deepest = [&](const Sphere& sphere, const double* x, double radius, int tag) {
    double dx = x[0] - sphere.x[0], dy = x[1] - sphere.x[1], dz = x[2] - sphere.x[2];
    domain->minimum_image(dx, dy, dz);
    const double reach = sphere.radius + radius;
    const double depth = reach - std::sqrt(dx * dx + dy * dy + dz * dz);
    if (depth <= 1e-9 * reach || depth <= worst.depth) return;  // touching is no overlap
    worst.depth = depth;
    found[0] = sphere.particle;
    found[1] = tag;
  };
  const SpheresAlongX near(spheres, domain->xperiodic ? domain->xprd : 0.0);
  double highest = options_.y, lowest = options_.y;
  for (const Sphere& sphere : spheres) {
    highest = std::max(highest, sphere.x[1] + sphere.radius);
    lowest = std::min(lowest, sphere.x[1] - sphere.radius);
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    const double y = atom->x[i][1], radius = atom->radius[i];
    if (!domain->yperiodic && (y - radius > highest || y + radius < lowest)) continue;
    near.visit(atom->x[i][0], radius, [&](const Sphere& sphere) {
      keep_deepest(sphere, atom->x[i], radius, atom->tag[i]);
    });
  }
  for (const Sphere& sphere : spheres)
    near.visit(sphere.x[0], sphere.radius, [&](const Sphere& other) {
      if (&other > &sphere && other.particle != sphere.particle)
        keep_deepest(sphere, other.x, other.radius, 0);
    });

  MPI_Allreduce(&worst, &all, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  if (all.depth <= 0) return;
  MPI_Bcast(found, 2, MPI_INT, all.rank, world);
  char text[320];
  const std::string other = found[1] ? "sphere " + std::to_string(found[1]) : "another one of it";
  std::snprintf(text, sizeof text,
                "line %d at step %ld: its particle at x = %g, y = %g would overlap %s by %g m; let "
                "more time or height pass between lines, or put fewer particles on them",
                lines_ + 1, static_cast<long>(update->ntimestep), line[found[0]].x, options_.y,
                other.c_str(), all.depth);
  stop_run(lmp, *this, text);
}

void FixInsertLine::create(const std::vector<Draw>& line, const std::vector<Sphere>& spheres) {
  for (int i = 0; i < modify->nfix; ++i)
    if (modify->fix[i]->create_attribute) modify->fix[i]->pre_set_arrays();

  // Ids are given out here, along the line: LIGGGHTS's own depend on the ranks.
  const int last_sphere = atom->tag_max();
  int body = multisphere_ ? multisphere_->tag_max_body() : 0;
  FixTemplateSphere* bodies_from = NULL;
  for (const Draw& draw : line) {
    prepare(draw);
    ParticleToInsert& particle = *draw.source->particles->pti;
    mass_inserted_ += particle.mass_ins;
    const bool is_body = is_multisphere(draw.source->particles);
    if (is_body) {
      bodies_from = draw.source->particles;
      ++body;
    }
    if (!draw.mine) continue;
    const int first = atom->nlocal;
    particle.insert();
    for (int i = first; i < atom->nlocal; ++i)
      atom->tag[i] = last_sphere + draw.first_sphere + 1 + (i - first);
    if (!is_body) continue;
    Multisphere& data = multisphere_->data();
    data.prop()
        .getElementProperty<ScalarContainer<int>>("id_multisphere")
        ->set(data.n_body() - 1, body);
    // There fix multisphere keeps the bodies of its spheres; its extract() would need all ranks.
    for (int i = first; i < atom->nlocal; ++i) atom->molecule[i] = body;
  }
  atom->natoms += static_cast<bigint>(spheres.size());
  if (atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
  if (bodies_from) bodies_from->finalize_insertion();
  if (irregular_->migrate_check()) irregular_->migrate_atoms();
}

void FixInsertLine::reset_timestep(bigint new_step, bigint old_step) {
  if (anchor_step_ >= 0) anchor_step_ += new_step - old_step;
  if (last_line_step_ >= 0) last_line_step_ += new_step - old_step;
}

void FixInsertLine::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::vector<double> state = {static_cast<double>(sources_.size()),
                               static_cast<double>(random_->state()),
                               static_cast<double>(lines_),
                               static_cast<double>(inserted_),
                               mass_inserted_,
                               static_cast<double>(anchor_step_),
                               static_cast<double>(last_line_step_),
                               anchor_time_,
                               time_step_};
  for (const Source& source : sources_) state.push_back(source.inserted);
  const int size = static_cast<int>(state.size() * sizeof(double));
  std::fwrite(&size, sizeof size, 1, file);
  std::fwrite(state.data(), sizeof(double), state.size(), file);
}

void FixInsertLine::restart(char* buffer) {
  const double* state = reinterpret_cast<const double*>(buffer);
  if (static_cast<std::size_t>(state[0]) != sources_.size()) {
    const std::string message =
        "template must name as many templates as the run that wrote the "
        "restart file, " +
        std::to_string(static_cast<int>(state[0])) + ", got '" + std::to_string(sources_.size()) +
        "'";
    stop_run(lmp, *this, message);
  }
  random_->reset(static_cast<int>(state[1]));
  lines_ = static_cast<int>(state[2]);
  inserted_ = static_cast<int>(state[3]);
  mass_inserted_ = state[4];
  anchor_step_ = static_cast<bigint>(state[5]);
  last_line_step_ = static_cast<bigint>(state[6]);
  anchor_time_ = state[7];
  time_step_ = state[8];
  for (std::size_t i = 0; i < sources_.size(); ++i)
    sources_[i].inserted = static_cast<int>(state[9 + i]);
}

int FixInsertLine::min_type() {
  int type = atom->ntypes;
  for (const Source& source : sources_) type = std::min(type, source.particles->mintype());
  return type;
}

int FixInsertLine::max_type() {
  int type = 0;
  for (const Source& source : sources_) type = std::max(type, source.particles->maxtype());
  return type;
}

double FixInsertLine::min_rad(int type) {
  double radius = 0;
  for (const Source& source : sources_) {
    FixTemplateSphere& t = *source.particles;
    if (type < t.mintype() || type > t.maxtype()) continue;
    radius = radius > 0 ? std::min(radius, t.min_rad()) : t.min_rad();
  }
  return radius;
}

double FixInsertLine::max_rad(int type) {
  double radius = 0;
  for (const Source& source : sources_) {
    FixTemplateSphere& t = *source.particles;
    if (type >= t.mintype() && type <= t.maxtype()) radius = std::max(radius, t.max_rad());
  }
  return radius;
}

// A rank that owns a body must see all of its spheres.
double FixInsertLine::extend_cut_ghost() {
  double reach = 0;
  for (const Source& source : sources_)
    if (is_multisphere(source.particles))
      reach = std::max(reach, 2. * source.particles->max_r_bound());
  return reach;
}

double FixInsertLine::compute_vector(int index) {
  if (index == 0) return inserted_;
  if (index == 1) return lines_;
  if (index == 2)
    return last_line_step_ < 0 ? -1. : static_cast<double>(last_line_step_) * update->dt;
  return mass_inserted_;
}

}  // namespace LAMMPS_NS
