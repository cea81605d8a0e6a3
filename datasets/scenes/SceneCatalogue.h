// The scenes that the program brings, procedural or read from installed models.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra {

// A number that can be set in a scene, such as a depth of three-planes.
struct SceneParameter {
  std::string name;  // kebab-case
  std::string doc;
  double low = 0.0, high = 1.0, value = 0.5;
};

struct SceneInfo {
  std::string name, title, description, figure;
  std::vector<SceneParameter> parameters;
  // For a scene that consists of planes across the light: the parameters that are their depths,
  // nearest to the light first; the last one is the receiver's. Otherwise empty.
  std::vector<std::string> planes;
  std::string missing;  // why it cannot be opened here, with the package to install; else ""
};

std::vector<SceneInfo> sceneCatalogue();

// Throws BadInput for an unknown name (with the nearest one), an unknown parameter and a value out
// of range.
void checkScene(const std::string& name, const std::map<std::string, double>& parameters = {});

// Deterministic: the same name and parameters give the same vertices. Throws as checkScene,
// and BadInput for a missing package.
Scene makeScene(const std::string& name, const std::map<std::string, double>& parameters = {});

// The depths of the scene's planes with these parameters; empty for any other scene and for an
// unknown name. Throws as makeScene for a wrong parameter.
std::vector<double> planeDepthsOf(const std::string& name,
                                  const std::map<std::string, double>& parameters = {});

}  // namespace umbra
