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

  double edge = 4.0;  // texels of the map, within the range above: no edge on it is longer
  std::size_t mostFaces = 2'000'000;  // that dividing may add to those of the scene
};

struct SurfaceFace {
  std::array<std::uint32_t, 3> corners;  // counter-clockwise seen from its front
  std::uint32_t object = 0;              // of the scene's
  // Part of no solid body: a sheet, whose back is seen as well.
  bool twoSided = false;
};

struct SurfaceMesh {
  std::vector<Eigen::Vector3f> positions;  // world
  std::vector<Eigen::Vector3f> normals;    // unit, for shading
  std::vector<SurfaceFace> faces;          // without those of no area
  // Texels: what was kept to. More than was asked for where that would add too many faces.
  double edge = 0.0;
};

// Of all objects, in their order. Only faces that are turned to the light and may lie on its map
// are divided, by halving edges, and their neighbours as far as they share those edges: what is
// beyond the map, such as the ground to the horizon, stays as it is. `check` is called between the
// steps; what it throws ends them.
SurfaceMesh surfaceMeshOf(
    const Scene& scene, const LightFrame& light, int mapSize,
    const SurfaceMeshSettings& settings = {}, const std::function<void()>& check = [] {});

// Which way a surface at `world` with this normal (of any length) is turned: the cosine between it
// and the way to the light.
double cosineToLight(const LightFrame& light, const Eigen::Vector3d& world,
                     const Eigen::Vector3d& normal);

// A surface with a smaller cosine than this catches less than a thousandth of the light: it is
// edge-on, and its depth on the map is noise.
inline constexpr double edgeOnCosine = 1e-3;

}  // namespace umbra
