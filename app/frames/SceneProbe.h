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
  Pixel pixel;  // where the surface is in sight
  SurfacePoint surface;
  bool hidden = false;  // from the camera: what the GPU makes of it is not known
};

// Takes the region that the shaded frame reads at `pixel` apart, in the session's format, and
// renders every technique for what the GPU makes of it. Throws BadCommandLine for a pixel outside
// the frame, without a surface or outside the light's frame.
SceneProbe probeScene(HeadlessFrame& frame, const Session& session,
                      const std::vector<std::shared_ptr<Technique>>& techniques, Pixel pixel);

// A kept probe of a scene, or why it cannot be read: one sentence.
struct KeptSceneProbe {
  std::optional<SceneProbe> probe;
  std::string reason;
};

// The same of points: what the shaded frame reads in the pixel whose middle shows the point; else
// what it would read, were the point such a middle and nothing in front. `receiver` takes the place
// of each probe's own.
std::vector<KeptSceneProbe> probeKept(HeadlessFrame& frame, const Scene& scene,
                                      const Session& session,
                                      const std::vector<std::shared_ptr<Technique>>& techniques,
                                      const std::vector<NamedProbe>& kept,
                                      const std::optional<double>& receiver);

// The technique of which the worst pixel is shown: VSM, which bleeds, where it is among `chosen`;
// else the first that is an upper bound, else the first.
std::shared_ptr<Technique> suspectOf(const std::vector<std::shared_ptr<Technique>>& chosen);

// Where `technique` bleeds most plainly; in a picture that bleeds nowhere visibly, the pixel that
// receives shadow and is farthest above the reference.
// Throws WorkFailed where no pixel of the frame is lit by the light's map.
Pixel worstBleeding(HeadlessFrame& frame, const Technique& technique);

// The fields of probeToJson with "pixel", "world" and "uv", which is on the map of "cascade";
// "nextCascade" is the next one's weight, in a seam only. "filter" is the frame's, "footprint" in
// texels, for filters that have one. "hidden" is there in place of "pixel" where it is true. `map`
// is of any cascade: all are as large.
Json sceneProbeToJson(const SceneProbe& probe, const DepthMap& map, const std::string& name,
                      ReadFilter filter, int bins, int samples);

}  // namespace umbra
