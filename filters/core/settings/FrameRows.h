// The parts of the frame's table, each in a file of its own: see SettingsTable.h.
#pragma once

#include <span>

#include "filters/core/settings/FrameSettings.h"
#include "filters/core/settings/Setting.h"

namespace umbra {

std::span<const SettingRow<FrameSettings>> kernelRows();
std::span<const SettingRow<FrameSettings>> mapRows();   // map, cascades and bias
std::span<const SettingRow<FrameSettings>> readRows();  // read and view

}  // namespace umbra
