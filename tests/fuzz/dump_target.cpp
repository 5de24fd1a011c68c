// SPDX-License-Identifier: GPL-2.0-or-later
// A dump of bodies, contacts or spheres, plain or .gz: read, and measured in every way.
#include "analysis/contact_forces.h"
#include "analysis/fields.h"
#include "analysis/force_chains.h"
#include "analysis/long_axis.h"
#include "analysis/orientation.h"
#include "analysis/pressure_profile.h"
#include "analysis/rdf.h"
#include "analysis/solid_fraction.h"
#include "analysis/space/axial_rdf.h"
#include "analysis/space/body_volumes.h"
#include "analysis/space/fabric.h"
#include "analysis/space/spatial_orientation.h"
#include "analysis/space/spatial_rdf.h"
#include "analysis/space/vertical_profile.h"
#include "input_file.h"
#include "reading/checks/frame_pool.h"
#include "reading/checks/planar.h"

using namespace rodpack;

namespace {

// One after the other: what refuses the input must not keep the others from seeing it.
template <class Measure>
void attempt(Measure measure) {
  try {
    measure();
  } catch (const DataError&) {
  }
}

void measure_bodies(const Frame& frame) {
  const Packing packing = read_packing(frame);
  attempt([&] {
    OrientationSample sample;
    sample.add(packing);
    sample.distribution();
  });
  attempt([&] {
    RdfSample sample({});
    sample.add(packing);
    sample.result();
  });
  attempt([&] { solid_fraction(packing); });
  attempt([&] {
    FieldSample sample({});
    sample.add(packing, frame, nullptr);
    sample.fields();
  });
}

// The same in space, along any axis.
void measure_in_space(const Frame& frame) {
  const std::string axis(1, "xyz"[frame.rows % 3]);
  const SpatialPacking packing = read_spatial_packing(frame, {}, {axis, {}, {}});
  attempt([&] {
    SpatialOrientationSample sample;
    sample.add(packing);
    sample.result();
  });
  attempt([&] {
    SpatialRdfSample sample({0.5, 3, 1});
    sample.add(packing);
    sample.result();
  });
  attempt([&] {
    AxialRdfSample sample({0.5, 3});
    sample.add(packing);
    sample.result();
  });
  attempt([&] { body_volumes(frame); });
}

void measure_contacts(const Frame& frame) {
  attempt([&] {
    ContactForceSample sample({});
    sample.add(frame);
    sample.result();
    measure_fabric(sample.normals(), sample.normal_forces(), frame.rows % 3);
  });
  attempt([&] { force_lines(frame); });
  attempt([&] { read_contacts(frame); });
  attempt([&] { require_planar_contacts(frame); });
}

// The last contacts with the last bodies, if the input holds both.
void measure_stress(const Frame& bodies, const Frame& contacts) {
  const Packing packing = read_packing(bodies);
  attempt([&] {
    FieldSample sample({});
    sample.add(packing, bodies, &contacts);
    sample.fields();
  });
  attempt([&] {
    ProfileSample sample({});
    sample.add(packing, bodies, contacts);
    sample.result();
  });
}

void measure_stress_in_space(const Frame& bodies, const Frame& contacts) {
  VerticalProfileSample sample({});
  sample.add(read_spatial_packing(bodies, {}, {"z", {}, {}}), bodies, &contacts);
  fit_janssen(sample.result());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const rodpack::test::InputFile file(data, size);
  Frame bodies, contacts;
  attempt([&] {
    FramePool pool;
    for_each_frame({file.name()}, [&](const Frame& frame) {
      attempt([&] { pool.take(frame); });
      attempt([&] { measure_bodies(frame); });
      attempt([&] { measure_in_space(frame); });
      attempt([&] { measure_contacts(frame); });
      attempt([&] {
        require_planar_spheres(frame, sphere_diameter(frame, {}));
        long_axis_degrees(frame.column("body"), frame.column("x"), frame.column("y"), 0);
      });
      (frame.has("body_i") ? contacts : bodies) = frame;
    });
  });
  if (bodies.rows > 0 && contacts.rows > 0) {
    attempt([&] { measure_stress(bodies, contacts); });
    attempt([&] { measure_stress_in_space(bodies, contacts); });
  }
  return 0;
}
