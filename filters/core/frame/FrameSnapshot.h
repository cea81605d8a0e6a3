// What a drawn frame left, as plain data: it is never changed, and read on any thread, without
// OpenGL.
#pragma once

#include <memory>
#include <vector>

#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Image.h"
#include "filters/core/maps/SurfaceImage.h"
#include "filters/core/scene/Camera.h"
#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/technique/Technique.h"

namespace umbra {

// Shared as std::shared_ptr<const FrameSnapshot>. Two snapshots that share a map are of the same
// bake.
struct FrameSnapshot {
  std::shared_ptr<const Scene> scene;
  Camera camera;
  FrameSettings settings;
  LightFrame light;  // of the whole light
  std::vector<Cascade> cascades;
  std::vector<std::shared_ptr<const DepthMap>> maps;  // of each cascade
  SurfaceImage surfaces;
  std::shared_ptr<const Technique> technique;  // as the frame adapted it to map and format
};

}  // namespace umbra
