#include "datasets/meshes/MaterialFile.h"

#include <algorithm>
#include <cmath>

#include "datasets/meshes/MeshFileText.h"

namespace umbra {
namespace {

using namespace meshfile;

std::optional<Eigen::Vector3d> colourFrom(std::string_view line) {
  Eigen::Vector3d colour;
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> value = realFrom(nextWord(line));
    if (!value || !std::isfinite(*value)) return std::nullopt;
    colour[i] = std::clamp(*value, 0.0, 1.0);
  }
  return colour;
}

}  // namespace

std::map<std::string, Material> materialsFrom(const std::string& content) {
  std::map<std::string, Material> materials;
  Material* current = nullptr;
  std::string converted;
  TextLines lines(plainText(content, converted));
  while (auto line = lines.next()) {
    const std::string_view key = nextWord(*line);
    if (key == "newmtl") {
      current = &materials[std::string(trimmed(*line))];
    } else if (current && (key == "Kd" || key == "Ks")) {
      const std::optional<Eigen::Vector3d> colour = colourFrom(*line);
      if (colour && key == "Kd") current->colour = *colour;
      // A mirror is read as a full highlight, which would hide the shadows.
      if (colour && key == "Ks") current->specular = 0.3 * colour->mean();
    } else if (current && key == "Ns") {
      const std::optional<double> value = realFrom(nextWord(*line));
      if (value && std::isfinite(*value)) current->shininess = std::clamp(*value, 1.0, 128.0);
    }
  }
  return materials;
}

}  // namespace umbra
