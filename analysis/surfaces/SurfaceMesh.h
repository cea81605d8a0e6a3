// A scene's triangles, divided until they are as fine as the shadow map that falls on them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

struct SurfaceMeshSettings {
  static constexpr double shortestEdge = 0.5, longestEdge = 256.0;

  double edge = 4.0;  // texels of the map, within the range above; no edge on the map is longer
  std::size_t mostFaces = 2'000'000;  // that dividing may add to the scene's
};

struct SurfaceFace {
  std::array<std::uint32_t, 3> corners;  // counter-clockwise seen from its front
  std::uint32_t object = 0;              // index of the scene's object
  // The face belongs to no solid body: it is part of a sheet, whose back is seen as well.
  bool twoSided = false;
};

struct SurfaceMesh {
  std::vector<Eigen::Vector3f> positions;  // world
  std::vector<Eigen::Vector3f> normals;    // unit, for shading
  std::vector<SurfaceFace> faces;          // without faces of area 0
  // Texels: the longest edge allowed. It exceeds the one asked for where that would add too many
  // faces.
  double edge = 0.0;
};

// The mesh of all objects, in their order. Only faces that are turned to the light and may lie on
// its map are divided, by halving edges, together with neighbours that share these edges: faces
// beyond the map, such as a ground to the horizon, stay as they are. `check` is called between the
// steps; an exception that it throws ends them.
SurfaceMesh surfaceMeshOf(
    const Scene& scene, const LightFrame& light, int mapSize,
    const SurfaceMeshSettings& settings = {}, const std::function<void()>& check = [] {});

// How a surface at `world` with this normal (of any length) is turned: the cosine between the
// normal and the direction to the light.
double cosineToLight(const LightFrame& light, const Eigen::Vector3d& world,
                     const Eigen::Vector3d& normal);

// A surface with a smaller cosine than this catches less than a thousandth of the light: it is
// edge-on, and its depth on the map is noise.
inline constexpr double edgeOnCosine = 1e-3;

}  // namespace umbra
