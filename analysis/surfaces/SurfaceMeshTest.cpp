#include "analysis/surfaces/SurfaceMesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "filters/core/scene/ClosedBody.h"

namespace umbra {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Light lightFrom(const Vector3d& position, LightKind kind = LightKind::Directional) {
  Light light;
  light.kind = kind;
  light.position = position;
  return light;
}

LightFrame frameOf(const Light& light) {
  return fitLightFrame(light, Eigen::AlignedBox3d(Vector3d(-2, -2, -2), Vector3d(2, 2, 2)));
}

Scene sceneOf(std::vector<Mesh> meshes) {
  Scene scene;
  for (Mesh& mesh : meshes) scene.objects.push_back({"part", std::move(mesh), {}});
  return scene;
}

Mesh octahedron() {
  Mesh mesh;
  for (const Vector3f& axis : {Vector3f(1, 0, 0), Vector3f(0, 1, 0), Vector3f(0, 0, 1)})
    for (float sign : {1.0f, -1.0f}) {
      mesh.positions.push_back(sign * 1.5f * axis);
      mesh.normals.push_back(sign * axis);
    }
  for (std::uint32_t x : {0u, 1u})
    for (std::uint32_t y : {2u, 3u})
      for (std::uint32_t z : {4u, 5u}) {
        const bool even = (x + y + z) % 2 == 0;
        mesh.triangles.push_back({x, even ? y : z, even ? z : y});
      }
  return mesh;
}

// The triangle's front is up.
Mesh ground(float half, float height = 0.0f) {
  Mesh mesh;
  mesh.positions = {
      {-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half}};
  mesh.normals.assign(4, Vector3f::UnitY());
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

double areaOf(const SurfaceMesh& mesh, const SurfaceFace& face) {
  const Vector3d a = mesh.positions[face.corners[0]].cast<double>();
  const Vector3d b = mesh.positions[face.corners[1]].cast<double>();
  const Vector3d c = mesh.positions[face.corners[2]].cast<double>();
  return 0.5 * (b - a).cross(c - a).norm();
}

// The longest edge of a face on the map, texels.
double longestEdge(const SurfaceMesh& mesh, const SurfaceFace& face, const LightFrame& light,
                   int size) {
  double longest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const LightPoint a = light.project(mesh.positions[face.corners[i]].cast<double>());
    const LightPoint b = light.project(mesh.positions[face.corners[(i + 1) % 3]].cast<double>());
    longest = std::max(longest, size * std::hypot(a.u - b.u, a.v - b.v));
  }
  return longest;
}

TEST(SurfaceMesh, EdgesTurnedToTheLightAreNoLongerThanAskedFor) {
  for (LightKind kind : {LightKind::Directional, LightKind::Spot}) {
    const LightFrame light = frameOf(lightFrom({3, 9, 2}, kind));
    const SurfaceMesh mesh = surfaceMeshOf(sceneOf({octahedron()}), light, 256, {.edge = 5.0});
    EXPECT_EQ(mesh.edge, 5.0);
    std::size_t towards = 0;
    double area = 0.0;
    for (const SurfaceFace& face : mesh.faces) {
      area += areaOf(mesh, face);
      const Vector3d a = mesh.positions[face.corners[0]].cast<double>();
      const Vector3d b = mesh.positions[face.corners[1]].cast<double>();
      const Vector3d c = mesh.positions[face.corners[2]].cast<double>();
      if (cosineToLight(light, a, (b - a).cross(c - a)) < edgeOnCosine) continue;
      ++towards;
      EXPECT_LE(longestEdge(mesh, face, light, 256), 5.0);
    }
    // Eight triangles of side 1.5·√2; positions are floats.
    EXPECT_NEAR(area, 8 * std::sqrt(3.0) / 4 * 2 * 1.5 * 1.5, 1e-5);
    EXPECT_GT(towards, 300u);
  }
}

// Faces that are divided, faces that are not and faces that are turned away share their edges
// without gaps.
TEST(SurfaceMesh, StaysClosed) {
  const LightFrame light = frameOf(lightFrom({3, 9, 2}));
  const SurfaceMesh divided = surfaceMeshOf(sceneOf({octahedron()}), light, 64);
  Mesh mesh{divided.positions, divided.normals, {}};
  for (const SurfaceFace& face : divided.faces) {
    mesh.triangles.push_back(face.corners);
    EXPECT_FALSE(face.twoSided);
  }
  EXPECT_GT(mesh.triangles.size(), 100u);
  EXPECT_TRUE(isClosedBody(mesh));
}

TEST(SurfaceMesh, TheGroundToTheHorizonIsDividedUnderTheLightOnly) {
  const LightFrame light = frameOf(lightFrom({0, 9, 0}));
  const SurfaceMesh mesh = surfaceMeshOf(sceneOf({ground(200.0f)}), light, 64, {.edge = 2.0});
  double inside = 0.0;
  std::size_t beyond = 0;
  for (const SurfaceFace& face : mesh.faces) {
    EXPECT_TRUE(face.twoSided);
    if (longestEdge(mesh, face, light, 64) <= 2.0)
      inside += areaOf(mesh, face);
    else
      ++beyond;
  }
  // The map is 4.04 units wide, the divided part no more than the faces that cross its border
  // wider; halving 400 units gets there in seven steps, whose parts beyond stay.
  EXPECT_GE(inside, 4.04 * 4.04);
  EXPECT_LT(inside, 16.0 * 16.0);
  EXPECT_LT(beyond, mesh.faces.size() / 4);
  double all = 0.0;
  for (const SurfaceFace& face : mesh.faces) all += areaOf(mesh, face);
  EXPECT_NEAR(all, 400.0 * 400.0, 1e-6 * 400.0 * 400.0);
}

// A spot light lies within the height range of the ground, so that a part of the ground is behind
// it.
TEST(SurfaceMesh, WhatReachesBehindASpotLightIsDividedInFrontOfIt) {
  Light light = lightFrom({0, 1, 3}, LightKind::Spot);
  light.target = {0, 0.5, 0};
  light.halfAngle = 40;
  const SurfaceMesh mesh = surfaceMeshOf(sceneOf({ground(50.0f)}), frameOf(light), 64);
  EXPECT_EQ(mesh.edge, 4.0);
  EXPECT_GT(mesh.faces.size(), 100u);
  EXPECT_LT(mesh.faces.size(), 20'000u);
}

TEST(SurfaceMesh, StopsEvenlyWhereThereAreTooManyFaces) {
  const LightFrame light = frameOf(lightFrom({0, 9, 0}));
  const Scene scene = sceneOf({ground(2.0f, 1.0f), ground(0.5f, -1.0f)});
  const SurfaceMesh mesh = surfaceMeshOf(scene, light, 256, {.edge = 2.0, .mostFaces = 3000});
  EXPECT_LE(mesh.faces.size(), 3000u);
  EXPECT_GT(mesh.faces.size(), 500u);
  EXPECT_GT(mesh.edge, 2.0);
  for (const SurfaceFace& face : mesh.faces)
    EXPECT_LE(longestEdge(mesh, face, light, 256), mesh.edge);
}

// The setting is a detailed model on a plain ground.
TEST(SurfaceMesh, WhatTheSceneHasDoesNotCountAgainstWhatMayBeAdded) {
  Mesh detailed;
  for (int i = 0; i < 2000; ++i) {
    const auto offset = std::uint32_t(detailed.positions.size());
    const Mesh tile = ground(0.01f, 0.001f * float(i));
    detailed.positions.insert(detailed.positions.end(), tile.positions.begin(),
                              tile.positions.end());
    detailed.normals.insert(detailed.normals.end(), tile.normals.begin(), tile.normals.end());
    for (auto [a, b, c] : tile.triangles)
      detailed.triangles.push_back({a + offset, b + offset, c + offset});
  }
  const LightFrame light = frameOf(lightFrom({0, 9, 0}));
  const SurfaceMeshSettings settings{.edge = 4.0, .mostFaces = 3000};
  const SurfaceMesh alone = surfaceMeshOf(sceneOf({ground(2.0f, -1.0f)}), light, 64, settings);
  const SurfaceMesh both =
      surfaceMeshOf(sceneOf({ground(2.0f, -1.0f), detailed}), light, 64, settings);
  EXPECT_EQ(both.edge, 4.0);
  EXPECT_GT(alone.faces.size(), 100u);
  EXPECT_EQ(both.faces.size(), alone.faces.size() + detailed.triangles.size());
}

// A square of side 4 on a map of 4.04; no face may be divided, so that its diagonal is the longest
// edge.
TEST(SurfaceMesh, WhatIsNotDividedAtAllTellsItsOwnLongestEdge) {
  const LightFrame light = frameOf(lightFrom({0, 9, 0}));
  const SurfaceMesh mesh =
      surfaceMeshOf(sceneOf({ground(2.0f)}), light, 64, {.edge = 2.0, .mostFaces = 0});
  EXPECT_EQ(mesh.faces.size(), 2u);
  // Lengths are floats of less than 2^7.
  EXPECT_NEAR(mesh.edge, longestEdge(mesh, mesh.faces.front(), light, 64), 0x1p-17);
  EXPECT_NEAR(mesh.edge, 64 * 4.0 * std::sqrt(2.0) / 4.04, 0x1p-16);
}

TEST(SurfaceMesh, FacesWithoutAreaAreLeftOut) {
  Mesh mesh = ground(1.0f);
  mesh.triangles.push_back({0, 1, 1});
  const LightFrame light = frameOf(lightFrom({0, 9, 0}));
  EXPECT_EQ(surfaceMeshOf(sceneOf({mesh}), light, 16, {.edge = 200.0}).faces.size(), 2u);
}

}  // namespace
}  // namespace umbra
