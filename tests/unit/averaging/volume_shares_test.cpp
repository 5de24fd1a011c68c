// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/volume_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using rodpack::ChainShape;
using rodpack::volume_shares;

constexpr double d = 3e-3;

TEST(VolumeShares, TouchingSpheresShareEqually) {
  for (double share : volume_shares(ChainShape{5, d, 0, 0, d})) EXPECT_NEAR(share, 0.2, 1e-14);
}

TEST(VolumeShares, SmoothChainSplitsEachLensBetweenItsTwoSpheres) {
  // AR = 2, f = 1/2: three spheres of radius r, r apart; the outer two touch. The lens of two
  // spheres h apart has the volume pi (2r - h)^2 (h^2 + 4 h r) / (12 h) = 5 pi r^3 / 12 at h = r.
  // Each sphere gives up half of its lenses: in units of pi r^3, 4/3 - 5/24 (ends) and 4/3 - 5/12
  // (middle).
  const double end = 4. / 3. - 5. / 24., middle = 4. / 3. - 5. / 12.;
  const auto shares = volume_shares(ChainShape{2, d, 0.5, 0, d});
  ASSERT_EQ(shares.size(), 3u);
  EXPECT_NEAR(shares[0], end / (2 * end + middle), 1e-13);
  EXPECT_NEAR(shares[1], middle / (2 * end + middle), 1e-13);
  EXPECT_NEAR(shares[2], shares[0], 1e-14);
}

TEST(VolumeShares, AddUpToOneWhereManySpheresOverlap) {
  for (double overlap : {0., 0.3, 0.5, 0.8, 0.95})
    for (double curvature : {0., 2.0}) {
      const auto shares = volume_shares(ChainShape{3, d, overlap, curvature, 0.97 * d});
      EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.), 1., 1e-12);
      for (std::size_t i = 0; i < shares.size(); ++i)  // the chain is its own mirror image
        EXPECT_NEAR(shares[i], shares[shares.size() - 1 - i], 1e-12);
    }
}

TEST(VolumeShares, FourSpheresAgreeWithASumOverAFineGrid) {
  // f = 0.8: a point may lie in all four spheres; no closed form, so points on a grid are counted.
  const ChainShape shape{1.6, d, 0.8, 0, d};
  const auto centres = rodpack::sphere_centres(shape);
  ASSERT_EQ(centres.size(), 4u);
  std::vector<double> sum(4, 0.);
  double total = 0;
  const int n = 240;
  const double half = 0.8 * d, radius = 0.5 * d;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {  // cylinder symmetry: weight rho
      const double x = -half + (i + 0.5) * 2 * half / n, rho = (j + 0.5) * radius / n;
      std::vector<int> in;
      for (int k = 0; k < 4; ++k)
        if (std::hypot(x - centres[k][0], rho) < radius) in.push_back(k);
      for (int k : in) sum[k] += rho / in.size();
      if (!in.empty()) total += rho;
    }
  const auto shares = volume_shares(shape);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(shares[k], sum[k] / total, 1e-4);  // grid: 1 / n^2
}

TEST(VolumeShares, SingleSphereHasAll) {
  EXPECT_EQ(volume_shares(ChainShape{1, d, 0.5, 0, d}), std::vector<double>{1.});
}

}  // namespace
