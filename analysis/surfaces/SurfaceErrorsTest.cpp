#include "analysis/surfaces/SurfaceErrors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/plots/PlanesForm.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int mapSize = 32;
constexpr double halfMap = 2.02;  // of the map's width, world units: fitLightFrame adds 1 %
constexpr double texelWidth = 2.0 * halfMap / mapSize;

// The front is up, or down.
Mesh square(double side, float height, bool up = true) {
  const float s = float(side);
  Mesh mesh;
  mesh.positions = {{-s, height, s}, {s, height, s}, {s, height, -s}, {-s, height, -s}};
  mesh.normals.assign(4, up ? Vector3f(0, 1, 0) : Vector3f(0, -1, 0));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (!up) mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  return mesh;
}

// A light from straight above and a map that is drawn by hand.
struct HandDrawn {
  HandDrawn() {
    Light light;
    light.position = {0, 9, 0};
    frame = fitLightFrame(light, Eigen::AlignedBox3d(Vector3d(-2, 0, -2), Vector3d(2, 4, 2)));
    settings.map.size = mapSize;
    settings.map.format = StorageFormat::Double;
    settings.bias = {.constant = 0.0, .slope = 0.0, .receiverPlane = false};
  }

  SurfaceErrors errors(const char* id, double edge = 1.5) const {
    const auto technique = allTechniques().make(id);
    const SurfaceMesh mesh = surfaceMeshOf(scene, frame, mapSize, {.edge = edge});
    return surfaceErrors(mesh, {scene, frame, map, settings, *technique});
  }
  void add(const char* name, Mesh mesh) { scene.objects.push_back({name, std::move(mesh), {}}); }

  Scene scene;
  LightFrame frame;
  DepthMap map{mapSize, mapSize, 1, 1.0};
  FrameSettings settings;
};

const std::vector<float>& fieldOf(const std::vector<MeshField>& fields, const char* name) {
  return std::find_if(fields.begin(), fields.end(),
                      [&](const MeshField& f) { return f.name == name; })
      ->values;
}

// A square that covers the map exactly is divided along the borders of its texels, so that with
// point reads every face lies in one texel: areas are exact but for positions being floats.
TEST(SurfaceErrors, AnUmbraHasTheAreaOfItsTexels) {
  HandDrawn drawn;
  drawn.add("ground", square(halfMap, 0.0f));
  drawn.settings.kernel = {KernelShape::None, 0};
  drawn.settings.read.filter = ReadFilter::Point;
  for (int y = 10; y < 14; ++y)
    for (int x = 8; x < 20; ++x) drawn.map(x, y) = 0.3;
  for (const char* id : {"pcf", "hard", "vsm"}) {
    const SurfaceSums all = drawn.errors(id).summary.all;
    EXPECT_NEAR(all.area, 4 * halfMap * halfMap, 1e-5);
    EXPECT_NEAR(all.shadowedArea, 12 * 4 * texelWidth * texelWidth, 1e-5);
    EXPECT_EQ(all.faces, std::size_t(2 * mapSize * mapSize));
  }
}

TEST(SurfaceErrors, PercentageCloserFilteringHasNone) {
  HandDrawn drawn;
  drawn.add("ground", square(halfMap, 0.0f));
  for (int y = 10; y < 20; ++y)
    for (int x = 8; x < 20; ++x) drawn.map(x, y) = 0.01 * x + 0.02 * y;
  const SurfaceErrors errors = drawn.errors("pcf");
  for (const char* name : {"error", "bleeding"}) {
    for (float value : fieldOf(errors.mesh.vertexFields, name)) EXPECT_EQ(value, 0.0f);
    for (float value : fieldOf(errors.mesh.faceFields, name)) EXPECT_EQ(value, 0.0f);
  }
  EXPECT_EQ(errors.summary.all.bleedingArea, 0.0);
  EXPECT_EQ(errors.summary.all.meanBleeding, 0.0);
  EXPECT_FALSE(errors.summary.all.worst);
  EXPECT_GT(errors.summary.all.shadowedArea, 0.0);
}

// Lauritzen 2008, fig. 3.4: A left of the middle of the map, B to its right, C below all of them. A
// bilinear read of a box is the box at the read's position, so that A covers that part of it which
// is left of the middle.
class ThreePlanes : public testing::Test {
 protected:
  ThreePlanes() {
    for (int y = 0; y < mapSize; ++y)
      for (int x = 0; x < mapSize; ++x) drawn.map(x, y) = x < mapSize / 2 ? 0.12 : 0.74;
    drawn.settings.kernel = {KernelShape::Box, 3};
    drawn.add("C", square(halfMap, 0.0f));
  }

  double closedForm(const Vector3d& world) const {
    const LightPoint point = drawn.frame.project(world);
    const double middle = mapSize / 2, at = point.u * mapSize;
    const double s = std::clamp((middle - (at - 3.5)) / 7.0, 0.0, 1.0);
    return predictedVisibility({{0.12, 0.74}, {s, 1.0 - s}}, point.z, 1e-6);
  }

  HandDrawn drawn;
};

TEST_F(ThreePlanes, VerticesBleedByTheClosedForm) {
  const SurfaceErrors errors = drawn.errors("vsm");
  double most = 0.0;
  for (std::size_t i = 0; i < errors.mesh.positions.size(); ++i) {
    const double expected = closedForm(errors.mesh.positions[i].cast<double>());
    most = std::max(most, expected);
    // Stored as floats; the bound itself is within 50 roundings of doubles over 1e-6.
    ASSERT_NEAR(fieldOf(errors.mesh.vertexFields, "visibility")[i], expected, 1.2e-7);
    ASSERT_NEAR(fieldOf(errors.mesh.vertexFields, "bleeding")[i], expected, 1.2e-7);
    ASSERT_EQ(fieldOf(errors.mesh.vertexFields, "reference")[i], 0.0f);
    ASSERT_EQ(fieldOf(errors.mesh.vertexFields, "receives")[i], 1.0f);
  }
  EXPECT_GT(most, 0.2);
}

TEST_F(ThreePlanes, FacesAreTheMeanOfThreePointsInside) {
  const SurfaceErrors errors = drawn.errors("vsm", 6.0);
  const FieldMesh& mesh = errors.mesh;
  double integral = 0.0, area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Vector3d corners[3];
    for (int c = 0; c < 3; ++c) corners[c] = mesh.positions[mesh.triangles[i][c]].cast<double>();
    const Vector3d centre = (corners[0] + corners[1] + corners[2]) / 3.0;
    double expected = 0.0;
    for (const Vector3d& corner : corners) expected += closedForm(0.5 * (corner + centre)) / 3.0;
    ASSERT_NEAR(fieldOf(mesh.faceFields, "error")[i], expected, 1.2e-7);
    integral +=
        double(fieldOf(mesh.faceFields, "bleeding")[i]) * fieldOf(mesh.faceFields, "area")[i];
    area += fieldOf(mesh.faceFields, "area")[i];
  }
  const SurfaceSums& all = errors.summary.all;
  EXPECT_NEAR(area, all.area, 1e-6 * area);
  EXPECT_NEAR(integral, all.meanBleeding * all.area, 1e-6 * area);
  EXPECT_NEAR(all.shadowedArea, all.area, 1e-12 * area);  // all of C is in shadow
  ASSERT_TRUE(all.worst);
  EXPECT_NEAR(all.worst->error, closedForm(all.worst->position), 1e-7);
}

// C bleeds visibly in a strip along the middle. A face counts by its points: on either side of the
// strip, faces that cross its border may add or miss an area within the length of their edges.
TEST_F(ThreePlanes, TheBleedingAreaIsThatOfTheClosedForm) {
  constexpr double edge = 0.5;  // texels
  constexpr int steps = 1000;   // of each texel
  double width = 0.0;           // width of the strip, texels
  for (int i = 0; i < steps * mapSize; ++i) {
    const double x = -halfMap + texelWidth * (i + 0.5) / steps;
    width += closedForm({x, 0.0, 0.0}) >= visibleError ? 1.0 / steps : 0.0;
  }
  EXPECT_GT(width, 4.0);
  EXPECT_LT(width, 7.0);  // the box holds both here
  const double length = 2.0 * halfMap, tolerance = 2.0 * (edge + 1.0 / steps) * texelWidth * length;
  const double expected = width * texelWidth * length,
               found = drawn.errors("vsm", edge).summary.all.bleedingArea;
  EXPECT_LT(tolerance, 0.3 * expected);
  EXPECT_NEAR(found, expected, tolerance);
}

TEST_F(ThreePlanes, ObjectsAddUpToAll) {
  drawn.add("patch", square(0.5, 0.2f));
  const SurfaceErrors errors = drawn.errors("vsm");
  ASSERT_EQ(errors.summary.objects.size(), 2u);
  const auto &all = errors.summary.all, &c = errors.summary.objects[0];
  const auto& patch = errors.summary.objects[1];
  EXPECT_EQ(c.name, "C");
  EXPECT_EQ(patch.name, "patch");
  EXPECT_EQ(errors.mesh.objectNames, (std::vector<std::string>{"C", "patch"}));
  EXPECT_NEAR(patch.area, 1.0, 1e-6);
  EXPECT_EQ(all.faces, c.faces + patch.faces);
  EXPECT_NEAR(all.area, c.area + patch.area, 1e-12);
  EXPECT_NEAR(all.bleedingArea, c.bleedingArea + patch.bleedingArea, 1e-12);
  EXPECT_NEAR(all.meanBleeding * all.area,
              c.meanBleeding * c.area + patch.meanBleeding * patch.area, 1e-12);
  EXPECT_EQ(all.worst->error, std::max(c.worst->error, patch.worst->error));
}

// A body's underside receives nothing, a sheet does on either side; beyond the map nothing does.
TEST(SurfaceErrors, OnlyWhatTheLightReachesReceives) {
  HandDrawn drawn;
  Mesh tetrahedron;
  tetrahedron.positions = {{0, 0, 1}, {1, 0, -1}, {-1, 0, -1}, {0, 1.5, 0}};
  for (const Vector3f& p : tetrahedron.positions)
    tetrahedron.normals.push_back((p - Vector3f(0, 0.4f, 0)).normalized());
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  drawn.add("body", tetrahedron);
  drawn.add("sheet", square(0.5, 3.0f, false));
  drawn.add("far", square(50.0, 0.0f));
  const SurfaceErrors errors = drawn.errors("vsm");
  const auto& objects = errors.summary.objects;
  // The area of its three upper sides; each is half of a base of 2 times the distance of the top
  // from that base.
  EXPECT_NEAR(objects[0].area,
              0.5 * 2 * std::hypot(1.5, 1.0) + 2 * 0.5 * Vector3d(-3, -1, -1.5).norm(), 1e-5);
  EXPECT_NEAR(objects[1].area, 1.0, 1e-6);
  // Faces across the border count by their points: off by at most the border's faces.
  EXPECT_NEAR(objects[2].area, 4 * halfMap * halfMap, 4 * 2 * halfMap * 2 * texelWidth);
  const auto& receives = fieldOf(errors.mesh.vertexFields, "receives");
  const auto& visibility = fieldOf(errors.mesh.vertexFields, "visibility");
  for (std::size_t i = 0; i < receives.size(); ++i) {
    const Vector3f& p = errors.mesh.positions[i];
    const bool outside = std::max(std::abs(p.x()), std::abs(p.z())) > halfMap + 1e-6;
    if (!outside) continue;
    EXPECT_EQ(receives[i], 0.0f);
    EXPECT_EQ(visibility[i], 1.0f);
  }
}

// The tree's wide ground ends at the paving that is set into it. Ground under the paving would be
// in shadow everywhere, and nobody sees it bleed.
TEST(SurfaceErrors, TheGroundReceivesNothingUnderThePaving) {
  const Scene scene = makeScene("tree-bench");
  const LightFrame light = fitLightFrame(scene.light, scene.lightBounds());
  const DepthMap map(mapSize, mapSize, 1, 1.0);
  const auto technique = allTechniques().make("vsm");
  FrameSettings settings;
  settings.map.size = mapSize;
  const FieldMesh mesh =
      surfaceErrors(surfaceMeshOf(scene, light, mapSize), {scene, light, map, settings, *technique})
          .mesh;
  const auto object = [&](const char* name) {
    return std::uint32_t(std::ranges::find(mesh.objectNames, name) - mesh.objectNames.begin());
  };
  const std::uint32_t ground = object("ground"), paving = object("paving");
  ASSERT_LT(std::max(ground, paving), scene.objects.size());
  const Eigen::AlignedBox3d set = scene.objects[paving].mesh.bounds();
  const auto& receives = fieldOf(mesh.faceFields, "receives");
  std::size_t beside = 0, under = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.objects[i] != ground || receives[i] == 0.0f) continue;
    Vector3d centre = Vector3d::Zero();
    for (std::uint32_t corner : mesh.triangles[i])
      centre += mesh.positions[corner].cast<double>() / 3.0;
    const bool inside = centre.x() > set.min().x() && centre.x() < set.max().x() &&
                        centre.z() > set.min().z() && centre.z() < set.max().z();
    (inside ? under : beside) += 1;
  }
  EXPECT_GT(beside, 0u);
  EXPECT_EQ(under, 0u);
}

TEST(SurfaceErrors, SettingsThatFollowAPictureAreRefused) {
  FrameSettings frame;
  EXPECT_EQ(whyNoSurfaceErrors(frame), "");
  frame.read.filter = ReadFilter::Trilinear;
  EXPECT_NE(whyNoSurfaceErrors(frame).find("filter trilinear"), std::string::npos);
  frame.read.filter = ReadFilter::SummedArea;
  EXPECT_NE(whyNoSurfaceErrors(frame).find("sat-size footprint"), std::string::npos);
  frame.read.satSize = SatSize::Fixed;
  EXPECT_EQ(whyNoSurfaceErrors(frame), "");
  frame.map.cascades.count = 2;
  EXPECT_NE(whyNoSurfaceErrors(frame).find("cascades"), std::string::npos);
}

}  // namespace
}  // namespace umbra
