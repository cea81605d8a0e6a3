// What a frame costs, as one reads it.
#pragma once

#include <QString>
#include <vector>

#include "filters/gpu/ShadowRenderer.h"

namespace umbra {

// "depth 3.1 · prefilter 1.4 · shade 6.0 ms"; empty without passes.
QString passTimesText(const std::vector<PassTime>& times);

// "map 1024² · float · 2 channels · 8 MiB stored, 28 used": by the method's channels, and by all
// textures; see textureBytes.
QString mapText(const FrameSettings& settings, const Technique& technique);
// Says what the two count.
QString mapToolTip();

}  // namespace umbra
