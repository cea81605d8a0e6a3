// A scene as plain data: what datasets build and what the renderer draws.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "filters/core/scene/Camera.h"
#include "filters/core/scene/Light.h"

namespace umbra {

// Triangles, counter-clockwise seen from outside. `normals` has one unit vector per position.
struct Mesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  Eigen::AlignedBox3d bounds() const;
};

struct Material {
  Eigen::Vector3d colour{0.8, 0.8, 0.8};    // sRGB in [0,1]
  bool physicallyBased = false;             // VTK's PBR in place of Phong
  double roughness = 0.6, metallic = 0.0;   // PBR
  double specular = 0.1, shininess = 20.0;  // Phong
};

struct SceneObject {
  std::string name;  // "bench", for tooltips and tables
  Mesh mesh;
  Material material;
  // Whether the light's frame must hold the object. A ground that reaches to the horizon need not
  // be held.
  bool boundsLight = true;
};

struct Scene {
  std::string name;         // "tree-bench"
  std::string title;        // "Tree over a bench"
  std::string description;  // two lines: what to look at
  std::string figure;       // what it stands for: "Lauritzen 2008, fig. 3.5"
  std::vector<SceneObject> objects;
  Light light;
  Camera camera;

  // The bounds of the objects with boundsLight, or of all objects where none has it.
  Eigen::AlignedBox3d lightBounds() const;
  Eigen::AlignedBox3d bounds() const;
  std::size_t triangleCount() const;
};

}  // namespace umbra
