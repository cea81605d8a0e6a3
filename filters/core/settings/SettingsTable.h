// The tables of settings for a frame, its light and its camera: see Setting.h.
#pragma once

#include <span>

#include "filters/core/scene/Camera.h"
#include "filters/core/scene/Light.h"
#include "filters/core/settings/FrameSettings.h"
#include "filters/core/settings/Setting.h"

namespace umbra {

// The rows stand in the order of the help and of the file.
std::span<const SettingRow<FrameSettings>> frameTable();
std::span<const SettingRow<Light>> lightTable();
std::span<const SettingRow<Camera>> cameraTable();

// Finds the first stage that has to be done again when settings change from `before` to `after`. It
// is Stage::Nothing if all that was shaded stays right. A setting that does nothing in either makes
// nothing stale. Cascades that follow the camera move with it; comparing settings does not tell
// that.
Stage firstStaleStage(const FrameSettings& before, const FrameSettings& after);
Stage firstStaleStage(const Light& before, const Light& after);
Stage firstStaleStage(const Camera& before, const Camera& after);

}  // namespace umbra
