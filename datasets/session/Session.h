// What one picture is drawn with, as one plain value. The window, the command line and the session
// file all edit it; the same session gives the same picture in the window and without one. What
// stands beside the picture to compare it is in the workspace.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/maps/DepthFile.h"
#include "datasets/meshes/MeshFile.h"
#include "datasets/session/NamedProbe.h"
#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {

enum class SourceKind { Catalogue, MeshFile, DepthFile };

struct SceneSource {
  SourceKind kind = SourceKind::Catalogue;
  std::string name = "tree-bench";           // of the catalogue, or a path
  DepthImport depth;                         // DepthFile: how its values are understood
  UpAxis up = UpAxis::Y;                     // MeshFile: which of the file's axes is the world's y
  std::map<std::string, double> parameters;  // Catalogue: what the scene lets one adjust

  bool operator==(const SceneSource&) const = default;
};

// Values that differ from the defaults, by parameter.
using ParameterValues = std::map<std::string, ParameterValue>;
// By technique.
using TechniqueParameters = std::map<std::string, ParameterValues>;

struct Session {
  static constexpr int smallestSide = 16, largestSide = 16384;  // of a picture, pixels

  SceneSource source;
  std::optional<Light> light;    // the scene's own where not set
  std::optional<Camera> camera;  // likewise
  FrameSettings frame;
  std::string technique = "vsm";
  TechniqueParameters parameters;
  int width = 1280, height = 720;  // of a rendered picture, pixels
  std::optional<Pixel> probe;
  std::optional<double> receiver;  // probe on a depth file: z_r; in the window, one dragged by hand
  std::vector<NamedProbe> probes;  // that are saved, in the order of their table
  std::string keptProbe;           // at which of them `probe` is; "" where at none

  bool operator==(const Session&) const = default;
};

// The values of the technique `id` that differ from the defaults.
ParameterValues parametersOf(const Session& session, const std::string& id);
void setParameters(Session& session, const std::string& id, ParameterValues values);

// The technique `id` with the session's parameters, limited to the session's storage format.
// `notices` receives a sentence for each value that was limited. Throws BadInput for a parameter
// that does not exist or a value out of range.
std::unique_ptr<Technique> techniqueOf(const Session& session, const TechniqueCatalogue& catalogue,
                                       const std::string& id,
                                       std::vector<std::string>* notices = nullptr);

// One sentence that says what the session's read of the technique loses; "" where it loses nothing,
// as on a depth file, whose texels are read as they are.
std::string whyReadInexactly(const Session& session, const Technique& technique);

// Lets `change` set parameters of the technique `id`, which have the session's values, and stores
// all of them anew: to set one may change others, as splits change the number of layers.
void editParameters(Session& session, const TechniqueCatalogue& catalogue, const std::string& id,
                    const std::function<void(std::span<const Parameter>)>& change);

// Throws BadInput where `values` cannot stand together, such as two splits and seven layers:
// setting one changed another. `where` is what the message begins with: a file and key.
void checkTogether(const ParameterValues& values, Technique& technique, std::string_view where);

}  // namespace umbra
