// The scenes that the program brings, procedural or read from installed models.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "filters/core/scene/Scene.h"

namespace umbra {

// What a scene lets one adjust, such as the depths of three-planes.
struct SceneParameter {
  std::string name;  // kebab-case
  std::string doc;
  double low = 0.0, high = 1.0, value = 0.5;
};

struct SceneInfo {
  std::string name, title, description, figure;
  std::vector<SceneParameter> parameters;
  // Of a scene that consists of planes across the light: the parameters that are their depths,
  // nearest to the light first; the last is the receiver's. Else empty.
  std::vector<std::string> planes;
  std::string missing;  // why it cannot be opened here: the package that would bring it; else ""
};

std::vector<SceneInfo> sceneCatalogue();

// Deterministic: same name and parameters, same vertices. Throws BadInput for an unknown name
// (with the nearest one), an unknown parameter, a value out of range, or a missing package.
Scene makeScene(const std::string& name, const std::map<std::string, double>& parameters = {});

// The depths of the scene's planes with these parameters; empty for a scene of something else or of
// no known name. Throws as makeScene for a wrong parameter.
std::vector<double> planeDepthsOf(const std::string& name,
                                  const std::map<std::string, double>& parameters = {});

}  // namespace umbra
