// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_template_spherocylinder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "atom.h"
#include "memory.h"
#include "modify.h"
#include "multisphere_fix.h"
#include "particle_to_insert_spherocylinder.h"
#include "prime_seed.h"
#include "random_park.h"
#include "rod_properties.h"
#include "rodpack/averaging/volume_shares.h"
#include "rodpack/geometry/pi.h"
#include "stop_run.h"

namespace LAMMPS_NS {

using namespace LMP_PROBABILITY_NS;

namespace {

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

/// Mean over the diameters drawn, by Simpson's rule: exact for a cubic, as volume and mass are to
/// within the small spread.
double mean_over_draws(const SpherocylinderOptions& options,
                       double (*quantity)(const Spherocylinder&)) {
  const double low = quantity(options.particle(options.diameter(0.)));
  const double middle = quantity(options.particle(options.diameter(0.5)));
  const double high = quantity(options.particle(options.diameter(1.)));
  return (low + 4. * middle + high) / 6.;
}

}  // namespace

/// The same particle in the words of fix particletemplate/multisphere, whose constructors allocate
/// what this class fills with exact numbers in post_create().
class FixTemplateSpherocylinder::StockArguments {
 public:
  StockArguments(char** own, const SpherocylinderOptions& options) {
    const Spherocylinder nominal = options.particle(options.shape.nominal_diameter);
    // The stock style refuses a single sphere: two are declared, and later shrink to one.
    const bool single = nominal.centres.size() == 1;
    words_ = {own[0],
              own[1],
              own[2],
              prime_seed(options.seed),
              "atom_type",
              std::to_string(options.atom_type),
              "density",
              "constant",
              text(options.density),
              "nspheres",
              std::to_string(single ? 2 : nominal.centres.size()),
              "ntry",
              "100000",  // below this there is a warning; nothing is sampled
              "spheres"};
    for (int copy = 0; copy < (single ? 2 : 1); ++copy)
      for (const auto& centre : nominal.centres)
        for (double number : {centre[0], centre[1], 0., 0.5 * options.shape.nominal_diameter})
          words_.push_back(text(number));
    const auto& inertia = nominal.mass.inertia;
    for (const std::string& word :
         {std::string("type"), std::to_string(options.body_type), std::string("mass"),
          text(nominal.mass.mass), std::string("inertia_tensor"), text(inertia[0]),
          std::string("0"), std::string("0"), text(inertia[1]), std::string("0"), text(inertia[2]),
          std::string("use_volume")})
      words_.push_back(word);
    for (std::string& word : words_) pointers_.push_back(&word[0]);
  }
  int count() const { return static_cast<int>(pointers_.size()); }
  char** data() { return pointers_.data(); }

 private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

FixTemplateSpherocylinder::FixTemplateSpherocylinder(LAMMPS* lmp, int narg, char** arg)
    : FixTemplateSpherocylinder(lmp, read_spherocylinder_options(lmp, narg, arg),
                                StockArguments(arg, read_spherocylinder_options(lmp, narg, arg))) {}

FixTemplateSpherocylinder::FixTemplateSpherocylinder(LAMMPS* lmp,
                                                     const SpherocylinderOptions& options,
                                                     StockArguments&& stock)
    : FixTemplateMultisphere(lmp, stock.count(), stock.data()),
      options_(new SpherocylinderOptions(options)),
      drawn_(new Spherocylinder(options.particle(options.shape.nominal_diameter))) {
  nspheres = static_cast<int>(drawn_->centres.size());
  vol_limit = 0;  // stock refuses volumes below 1e-12 m^3; sizes have been checked here
  delete pti;
  pti = new ParticleToInsertSpherocylinder(lmp, nspheres, options_->planar);
  if (options_->planar) {
    fflag_[2] = false;
    tflag_[0] = tflag_[1] = false;
  }
}

FixTemplateSpherocylinder::~FixTemplateSpherocylinder() {}

void FixTemplateSpherocylinder::post_create() {
  const Spherocylinder nominal = options_->particle(options_->shape.nominal_diameter);
  const std::vector<double> shares = rodpack::volume_shares(nominal.shape);
  const double radius = 0.5 * nominal.shape.diameter;
  for (int i = 0; i < nspheres; ++i) {
    vectorConstruct3D(x_sphere[i], nominal.centres[i][0], nominal.centres[i][1], 0.);
    vectorCopy3D(x_sphere[i], displace_[i]);
    r_sphere[i] = radius;
    volumeweight_[i] = shares[i];
  }
  vectorZeroize3D(x_bound);
  vectorZeroize3D(xcm_to_xb_body_);
  r_bound = 0;
  for (double draw : {0., 0.5, 1.})
    r_bound = std::max(r_bound, options_->particle(options_->diameter(draw)).bounding_radius);

  volume_expect = mean_over_draws(*options_, [](const Spherocylinder& p) { return p.volume; });
  mass_expect = mean_over_draws(*options_, [](const Spherocylinder& p) { return p.mass.mass; });
  r_equiv = std::cbrt(3. * volume_expect / (4. * rodpack::pi));
  pdf_density->set_params<RANDOM_CONSTANT>(mass_expect / volume_expect);

  vectorConstruct3D(ex_space_, 1., 0., 0.);
  vectorConstruct3D(ey_space_, 0., 1., 0.);
  vectorConstruct3D(ez_space_, 0., 0., 1.);
  for (int i = 0; i < 3; ++i) inertia_[i] = nominal.mass.inertia[i];
  check_overlap();
  print_info();
}

void FixTemplateSpherocylinder::init() {
  // LIGGGHTS keeps one table over the body types of all multisphere templates, stock and ours.
  const char* family = "particletemplate/multisphere";
  const int n = modify->n_fixes_style(family);
  std::vector<int> uses(n + 1, 0);
  for (int i = 0; i < n; ++i) {
    const int type =
        static_cast<FixTemplateMultisphere*>(modify->find_fix_style(family, i))->type();
    if (type > n || ++uses[type] > 1) {
      const std::string message = "type must be unique and run from 1 to " + std::to_string(n) +
                                  " over all " + family + " fixes, got '" + std::to_string(type) +
                                  "'";
      stop_run(lmp, *this, message);
    }
  }
  FixMultisphere* const multisphere = multisphere_fix(modify);
  if (!multisphere) return;
  if (!(multisphere->groupbit & groupbit))
    stop_run(lmp, *this, "and fix multisphere must be members of the same group");
  rod_properties(multisphere->data());
}

// Bodies that come from a restart file have lost their rod properties.
void FixTemplateSpherocylinder::setup(int) {
  FixMultisphere* const multisphere = multisphere_fix(modify);
  if (!multisphere) return;
  Multisphere& bodies = multisphere->data();
  auto& type = *bodies.prop().getElementProperty<ScalarContainer<int>>("clumptype");
  const RodProperties rods = rod_properties(bodies);
  const int n = atom->nlocal + atom->nghost;
  for (int i = 0; i < n; ++i) {
    const int tag = multisphere->belongs_to(i);
    const int body = tag < 0 ? -1 : bodies.map(tag);
    if (body < 0 || type(body) != type_ || (*rods.radius)(body) > 0) continue;
    const Spherocylinder chain = options_->particle(2. * atom->radius[i]);
    if (bodies.nrigid(body) != nspheres ||
        std::fabs(bodies.r_bound(body) / chain.bounding_radius - 1.) > 1e-9) {
      stop_run_from_one_rank(
          lmp, *this,
          "body " + std::to_string(tag) + " of type " + std::to_string(type_) + " is a chain of " +
              std::to_string(bodies.nrigid(body)) + " spheres and bounding radius " +
              std::to_string(bodies.r_bound(body)) + " m, expected " + std::to_string(nspheres) +
              " and " + std::to_string(chain.bounding_radius) +
              " m: declare the template of the run that wrote the restart file");
    }
    rods.radius->set(body, atom->radius[i]);
    rods.half_length->set(
        body, nspheres == 1 ? atom->radius[i] : 0.5 * rodpack::axial_length(chain.shape));
    rods.curvature->set(body, chain.shape.curvature_angle);
    rods.area->set(body, chain.area);
  }
}

double FixTemplateSpherocylinder::min_rad() { return 0.5 * options_->diameter(0.); }

double FixTemplateSpherocylinder::max_rad() { return 0.5 * options_->diameter(1.); }

const Spherocylinder& FixTemplateSpherocylinder::particle(double draw) {
  if (options_->size_spread > 0) *drawn_ = options_->particle(options_->diameter(draw));
  return *drawn_;
}

void FixTemplateSpherocylinder::prepare(ParticleToInsertSpherocylinder& insertion, double draw) {
  const Spherocylinder& chain = particle(draw);
  insertion.set_chain(chain);
  insertion.nparticles = nspheres;
  insertion.atom_type = atom_type;
  insertion.type_ms = type_;
  insertion.groupbit = groupbit;
  insertion.volume_ins = chain.volume;
  insertion.mass_ins = chain.mass.mass;
  insertion.density_ins = chain.mass.mass / chain.volume;
  insertion.r_bound_ins = chain.bounding_radius;
  vectorZeroize3D(insertion.x_bound_ins);
  for (int i = 0; i < nspheres; ++i) {
    insertion.radius_ins[i] = 0.5 * chain.shape.diameter;
    insertion.volumeweight[i] = volumeweight_[i];
    vectorConstruct3D(insertion.displace[i], chain.centres[i][0], chain.centres[i][1], 0.);
    vectorCopy3D(insertion.displace[i], insertion.x_ins[i]);
  }
  for (int i = 0; i < 3; ++i) insertion.inertia[i] = chain.mass.inertia[i];
  vectorCopy3D(ex_space_, insertion.ex_space);
  vectorCopy3D(ey_space_, insertion.ey_space);
  vectorCopy3D(ez_space_, insertion.ez_space);
  vectorCopy3D(fflag_, insertion.fflag);
  vectorCopy3D(tflag_, insertion.tflag);
  vectorCopy3D(xcm_to_xb_body_, insertion.xcm_to_xbound);
  vectorZeroize3D(insertion.xcm_ins);
  quatIdentity4D(insertion.quat_ins);
  vectorZeroize3D(insertion.v_ins);
  vectorZeroize3D(insertion.omega_ins);
}

void FixTemplateSpherocylinder::prepare_single(double draw) {
  prepare(static_cast<ParticleToInsertSpherocylinder&>(*pti), draw);
}

void FixTemplateSpherocylinder::randomize_single() { prepare_single(random_insertion->uniform()); }

void FixTemplateSpherocylinder::init_ptilist(int n, const bool, FixPropertyAtom* const) {
  n_pti_max = n;
  pti_list = static_cast<ParticleToInsert**>(
      memory->smalloc(n * sizeof(ParticleToInsert*), "spherocylinder:pti_list"));
  for (int i = 0; i < n; ++i)
    pti_list[i] = new ParticleToInsertSpherocylinder(lmp, nspheres, options_->planar);
}

void FixTemplateSpherocylinder::randomize_ptilist(int n, int distribution_groupbit, int distorder) {
  for (int i = 0; i < n; ++i) {
    auto& insertion = static_cast<ParticleToInsertSpherocylinder&>(*pti_list[i]);
    prepare(insertion, random_insertion->uniform());
    insertion.groupbit |= distribution_groupbit;
    insertion.distorder = distorder;
  }
}

}  // namespace LAMMPS_NS
