// A probe of one pixel of a rendered scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/probe/Probe.h"
#include "app/display/Display.h"
#include "app/output/Output.h"

namespace umbra {

struct SceneProbe {
  Probe probe;
  Pixel pixel;  // valid where the surface is in sight
  SurfacePoint surface;
  bool hidden = false;  // whether the camera does not see it: the GPU then has no result for it
};

// Takes the region apart that the shaded frame reads at `pixel`, in the session's format, and
// renders every technique for the GPU's own result. Throws BadCommandLine for a pixel outside the
// frame, without a surface or outside the light's frame.
SceneProbe probeScene(HeadlessFrame& frame, const Session& session,
                      const std::vector<std::shared_ptr<Technique>>& techniques, Pixel pixel);

// A saved probe of a scene, or one sentence that says why it cannot be read.
struct SavedSceneProbe {
  std::optional<SceneProbe> probe;
  std::string reason;
};

// Does the same for points. Where a pixel's middle shows the point, the probe has the read of that
// pixel; elsewhere it has the read that such a pixel would have with nothing in front of the point.
// `receiver` replaces each probe's own.
std::vector<SavedSceneProbe> probeSaved(HeadlessFrame& frame, const Session& session,
                                        const std::vector<std::shared_ptr<Technique>>& techniques,
                                        const std::vector<NamedProbe>& saved,
                                        const std::optional<double>& receiver);

// The technique whose worst pixel is shown: VSM, which bleeds, where it is among `chosen`; else the
// first one that is an upper bound, else the first.
std::shared_ptr<Technique> suspectOf(const std::vector<std::shared_ptr<Technique>>& chosen);

// The pixel where `technique` bleeds most plainly. In a picture without a plainly bleeding spot, it
// is the pixel that receives shadow and is farthest above the reference. Throws WorkFailed where
// the light's map lights no pixel of the frame.
Pixel worstBleeding(HeadlessFrame& frame, const Technique& technique);

// The fields of probeToJson with "pixel", "world" and "uv", which is on the map of "cascade".
// "nextCascade" is the weight of the next one, in a seam only. "filter" is the frame's;
// "footprint", in texels, is there for filters that have one. "hidden" replaces "pixel" where it is
// true. `map` may be any cascade's: all have one size.
Json sceneProbeToJson(const SceneProbe& probe, const DepthMap& map, const std::string& name,
                      ReadFilter filter, int bins, int samples);

}  // namespace umbra
