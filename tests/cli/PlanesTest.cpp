// Renders the analytic scenes and compares them with their closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/plots/PlanesForm.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

constexpr double minVariance = 1e-6;  // the default of vsm

// The share of the region in each plane's bin, among 2000 bins over [min, max], which are the
// depths of the two planes.
PlaneShares sharesOf(const Json& probe, const std::vector<double>& depths) {
  PlaneShares planes{depths, std::vector<double>(depths.size(), 0.0)};
  const Json &edges = probe["histogram"]["edges"], &weights = probe["histogram"]["weights"];
  for (std::size_t bin = 0; bin < weights.size(); ++bin) {
    if (weights[bin] == 0.0) continue;
    const double low = edges[bin].get<double>(), high = edges[bin + 1].get<double>();
    for (std::size_t i = 0; i < depths.size(); ++i)
      if (depths[i] > low - planeTolerance && depths[i] < high + planeTolerance)
        planes.shares[i] += weights[bin].get<double>();
  }
  return planes;
}

// How far a measured bound may be from the closed form. Depths of the map are off by δ: sixteen
// roundings of coordinates up to 12 over a range of 3.3 units (as for every rendered depth map).
// The bound V/(V + D²) moves by at most (|dV| + |dD|)/(V + D²), where dV ≤ 2δ and dD ≤ δ. Storing
// and filtering M1 and M2 in 32 bits adds to each up to 20 roundings of values below 1, thus to V
// 3·20 and to D 20 of them.
double toleranceOf(const PlaneShares& planes, double receiver) {
  const double u = std::ldexp(1.0, -24), delta = 16.0 * u * 12.0 / 3.3;
  double mean = 0.0, square = 0.0;
  for (std::size_t i = 0; i < planes.depths.size(); ++i) {
    mean += planes.shares[i] * planes.depths[i];
    square += planes.shares[i] * planes.depths[i] * planes.depths[i];
  }
  const double distance = receiver - mean;
  return (3.0 * delta + 80.0 * u) / (square - mean * mean + distance * distance);
}

Json probeOf(const std::string& scene, const std::string& pixel) {
  return run({"probe", "--json", "--scene", scene, "--pixel", pixel, "--technique", "vsm", "--size",
              "320x240", "--map-size", "256", "--bins", "2000"})
      .json();
}

void expectTheClosedForm(const Json& probe, const PlaneShares& planes) {
  const double receiver = probe["receiver"], tolerance = toleranceOf(planes, receiver);
  const double predicted = predictedVisibility(planes, receiver, minVariance);
  const Json& vsm = probe["techniques"][0];
  EXPECT_NEAR(vsm["visibility"], predicted, tolerance);
  EXPECT_NEAR(vsm["gpu"], predicted, tolerance);
  EXPECT_LT(tolerance, 1e-2);  // otherwise the above says little
}

TEST(Planes, ThreePlanesBleedAsPredicted) {
  const std::vector<double> depths = planeDepthsOf("three-planes");
  ASSERT_EQ(depths, (std::vector<double>{0.12, 0.74, 0.94}));
  const Json probe = probeOf("three-planes", "worst");
  const PlaneShares planes = sharesOf(probe, depths);
  ASSERT_NEAR(planes.shares[0] + planes.shares[1] + planes.shares[2], 1.0, 1e-9) << probe;
  EXPECT_GT(planes.shares[0], 0.1);
  EXPECT_GT(planes.shares[1], 0.1);
  EXPECT_NEAR(probe["reference"], planes.shares[2], 1e-9);
  expectTheClosedForm(probe, planes);
}

// The penumbra of the occluder's edge, found by the pixels of a row that cross it.
TEST(Planes, TwoPlanesAreExactAcrossTheEdge) {
  const std::vector<double> depths = planeDepthsOf("two-planes");
  int penumbrae = 0;
  for (int x = 0; x < 320 && penumbrae < 3; x += 2) {
    const Outcome outcome =
        run({"probe", "--json", "--scene", "two-planes", "--pixel", std::to_string(x) + ",150",
             "--technique", "vsm", "--size", "320x240", "--map-size", "256", "--bins", "2000"});
    if (outcome.status != 0) {  // the light does not see this part of the ground
      ASSERT_NE(outcome.err.find("outside the shadow map"), std::string::npos) << outcome.err;
      continue;
    }
    const Json probe = outcome.json();
    const PlaneShares planes = sharesOf(probe, depths);
    if (std::abs(planes.shares[0] + planes.shares[1] - 1.0) > 1e-9) continue;
    if (planes.shares[0] < 0.1 || planes.shares[1] < 0.1) continue;
    if (probe["receiver"].get<double>() < depths[1] - 0.01)
      continue;  // the pixel shows the occluder
    ++penumbrae;
    EXPECT_NEAR(probe["reference"], planes.shares[1], 1e-9);
    expectTheClosedForm(probe, planes);
    // At the receiver's own depth the bound is the unoccluded share.
    EXPECT_NEAR(predictedVisibility(planes, depths[1]), planes.shares[1], 1e-12);
  }
  EXPECT_GT(penumbrae, 0);
}

}  // namespace
}  // namespace umbra::cli
