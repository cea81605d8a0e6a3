// A technique's error on the surfaces of a scene, independent of any camera: at vertices, over
// faces, and as areas.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/rays/RayTracedVisibility.h"
#include "analysis/surfaces/SurfaceMesh.h"
#include "filters/core/maps/Image.h"
#include "filters/core/scene/FieldMesh.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

struct SurfaceSubject {
  const Scene& scene;
  const LightFrame& light;     // the whole map's
  const DepthMap& map;         // as drawn
  const FrameSettings& frame;  // settings that whyNoSurfaceErrors accepts
  const Technique& technique;  // parameters set, adapted to the map
  // The truth, where it is not exact percentage-closer filtering.
  const RayTracedVisibility* rays = nullptr;
};

struct WorstPlace {
  Eigen::Vector3d position{0.0, 0.0, 0.0};  // world
  double error = 0.0;                       // visibility − reference
};

// Areas are in square world units. Only surfaces that face the light and lie inside its map receive
// shadow and count. Whether they can be seen is not checked: a surface that faces the light inside
// another body, such as the part of a floor under a foot that stands on it, receives and bleeds as
// well. The catalogue's ground has a hole where its paving is set in.
struct SurfaceSums {
  std::string name;                 // the object's name
  std::size_t faces = 0;            // all faces
  double area = 0.0;                // area that receives shadow
  double shadowedArea = 0.0;        // shadowed part of `area`; a penumbra counts with its dark part
  double bleedingArea = 0.0;        // part of `area` with an error of at least visibleError
  double meanBleeding = 0.0;        // mean of max(error, 0) over `area`; 0 without any
  std::optional<WorstPlace> worst;  // where most light bleeds; empty where none bleeds visibly
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

// Why errors on surfaces cannot be computed with these settings; empty where they can. One clause
// that names the setting and the settings that work.
std::string whyNoSurfaceErrors(const FrameSettings& frame);

// A vertex is read as the shaded frame would read it, on the plane across its normal. A face's
// value is the mean of three reads inside it, on its own plane, so that no edge between two planes
// is read. The mean is exact where the error changes linearly or quadratically (Strang & Fix 1973,
// three interior points). Works on every core. `progress` is called on the calling thread alone
// with the part that is done, 0 … 1; an exception that it throws ends the work.
SurfaceErrors surfaceErrors(
    const SurfaceMesh& mesh, const SurfaceSubject& subject,
    const std::function<void(double)>& progress = [](double) {});

}  // namespace umbra
