// The trace, the decomposition, the plots, the surfaces and the verdict call the same errors
// errors.
#include "filters/core/technique/VisibleError.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/errors/ErrorDecomposition.h"
#include "analysis/errors/Measure.h"
#include "analysis/plots/ProbePlots.h"
#include "analysis/probe/Explain.h"
#include "analysis/probe/TestProbes.h"
#include "analysis/surfaces/SurfaceErrors.h"

namespace umbra {
namespace {

constexpr double minVariance = 1e-6;  // vsm's default

// The distance between one occluder for all texels and the receiver at which vsm lets `error` of
// the light through: σ²min / (σ²min + d²) = error (Lauritzen 2008, eq. 3.3).
double distanceFor(double error) {
  return std::sqrt(minVariance * (1.0 - error) / error);
}

// A square ground at y = 0 under a light from straight above, whose map holds one depth. The
// occluder is `distance` before the ground, in normalised depth.
SurfaceSums groundBehind(double distance) {
  Light light;
  light.position = {0.0, 9.0, 0.0};
  const LightFrame frame = fitLightFrame(
      light, Eigen::AlignedBox3d(Eigen::Vector3d(-2, 0, -2), Eigen::Vector3d(2, 4, 2)));
  Scene scene;
  scene.objects.push_back({"ground", {}, {}});
  Mesh& ground = scene.objects[0].mesh;
  ground.positions = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}};
  ground.normals.assign(4, {0, 1, 0});
  ground.triangles = {{0, 1, 2}, {0, 2, 3}};
  FrameSettings settings;
  settings.map.size = 16;
  settings.map.format = StorageFormat::Double;
  settings.bias = {.constant = 0.0, .slope = 0.0, .receiverPlane = false};
  const DepthMap map(16, 16, 1, frame.project({0.0, 0.0, 0.0}).z - distance);
  const auto vsm = allTechniques().make("vsm");
  const SurfaceMesh mesh = surfaceMeshOf(scene, frame, 16, {.edge = 8.0});
  return surfaceErrors(mesh, {scene, frame, map, settings, *vsm}).summary.all;
}

// The picture of a single pixel with the probe's visibility, decomposed: its part Small.
double smallPartOf(const Probe& probe) {
  const double visibility = probe.techniques[0].visibility;
  SurfaceImage surfaces(1, 1);
  surfaces.set(0, 0, {.u = 0.5, .v = 0.5, .receiver = probe.receiver, .visibility = visibility});
  Image<float> reference(1, 1);
  reference(0, 0) = float(probe.reference);
  ErrorDecomposition result = emptyDecomposition(1, 1);
  decomposeRow(
      surfaces, reference, 0, false, [&](int, int) { return probe; }, {}, result);
  return result.parts(0, 0, int(ErrorPart::Small));
}

// An error of `share` times the threshold; `share` differs from 1 by more than single precision.
void expectAgreement(double share, bool visible) {
  const double distance = distanceFor(share * visibleError);
  Probe probe = probeOfDepths({0.7 - distance}, 0.7);
  addResult(probe, allTechniques().make("vsm"));
  const TechniqueResult& result = probe.techniques[0];
  ASSERT_NEAR(result.error, share * visibleError, 1e-9);
  EXPECT_EQ(isVisibleError(result.error), visible);
  EXPECT_EQ(explain(probe, result).cause != ErrorCause::None, visible);
  EXPECT_EQ(smallPartOf(probe) == 0.0, visible);
  EXPECT_EQ(curvesPlot(probe, "vsm").errors.size(), visible ? 1u : 0u);
  EXPECT_STREQ(verdictOf(result.error), visible ? "light bleeding" : "no visible error");
  EXPECT_STREQ(verdictOf(-result.error), visible ? "over-darkening" : "no visible error");
  const SurfaceSums ground = groundBehind(distance);
  ASSERT_GT(ground.area, 3.9);
  EXPECT_EQ(ground.bleedingArea, visible ? ground.area : 0.0);
  EXPECT_EQ(ground.worst.has_value(), visible);
}

TEST(VisibleError, AllAgreeJustBelowIt) {
  expectAgreement(0.999, false);
}

TEST(VisibleError, AllAgreeJustAboveIt) {
  expectAgreement(1.001, true);
}

// These are the sizes at which the picture and the trace used to contradict each other.
TEST(VisibleError, AllAgreeOnEverySizeOfError) {
  for (const double error : {5e-4, 1.0 / 512.0, 0.01, 0.02, 0.05, 0.5})
    expectAgreement(error / visibleError, error > visibleError);
}

}  // namespace
}  // namespace umbra
