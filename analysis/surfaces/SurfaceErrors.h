// A technique's error on the surfaces of a scene, whoever looks at them: at vertices, over faces,
// and as areas.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/surfaces/SurfaceMesh.h"
#include "filters/core/maps/Image.h"
#include "filters/core/scene/FieldMesh.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

struct SurfaceSubject {
  const Scene& scene;
  const LightFrame& light;     // of the whole map
  const DepthMap& map;         // as drawn
  const FrameSettings& frame;  // that whyNoSurfaceErrors has nothing against
  const Technique& technique;  // parameters set, adapted to the map
};

struct WorstPlace {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  // world
  double error = 0.0;                       // visibility − reference
};

// Areas are in square world units, of surfaces that face the light and lie inside its map: only
// these receive shadow. Nobody looks whether they can be seen: what faces the light inside another
// body, such as the part of a floor under a foot that stands on it, receives and bleeds as the rest
// does. The catalogue's ground has a hole where its paving is set in.
struct SurfaceSums {
  std::string name;                 // of the object
  std::size_t faces = 0;            // all of them
  double area = 0.0;                // that receives shadow
  double shadowedArea = 0.0;        // of it in shadow; of penumbrae the part that is dark
  double bleedingArea = 0.0;        // of it with an error of visibleError or more
  double meanBleeding = 0.0;        // mean of max(error, 0) over `area`; 0 without any
  std::optional<WorstPlace> worst;  // where most light bleeds; none where none does visibly
};

struct SurfaceSummary {
  SurfaceSums all;                   // named ""
  std::vector<SurfaceSums> objects;  // in the scene's order
  double edge = 0.0;                 // SurfaceMesh::edge
};

struct SurfaceErrors {
  // Vertices: "visibility", "reference", "error", "bleeding", "receives" (0 or 1). Faces: "error",
  // "bleeding", "receives", means over the whole face with 0 for what receives no shadow, so that
  // their sums weighted by "area" are integrals. "visibility" and "reference" are 1 beyond the
  // map, and 0 where a vertex faces away from the light, as in the visibility view.
  FieldMesh mesh;
  SurfaceSummary summary;
};

// Why errors on surfaces cannot be had with these settings; empty where they can. One clause that
// names the setting and says what would go.
std::string whyNoSurfaceErrors(const FrameSettings& frame);

// A vertex is read as the shaded frame would read it, on the plane across its normal. A face is the
// mean of three reads inside it, exact where the error changes evenly or quadratically (Strang &
// Fix 1973, three interior points), on its own plane: no edge between two planes is read. Works on
// every core; `progress` is called on the calling thread alone with the part that is done, 0 … 1;
// what it throws ends the work.
SurfaceErrors surfaceErrors(
    const SurfaceMesh& mesh, const SurfaceSubject& subject,
    const std::function<void(double)>& progress = [](double) {});

}  // namespace umbra
