// Takes the regions apart that the picture, or a depth file, is read over.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/picture/ProbeReport.h"
#include "ui/probe/HeldPoint.h"

namespace umbra {

class SceneView;
class SessionController;
struct Document;

// With the session's settings, in the last frame's maps. Techniques are adapted to a map once,
// whoever takes a probe in it.
class ProbeTaker {
 public:
  ProbeTaker(SessionController& controller, SceneView& view);

  // At a place of the last frame; `receiver` takes the place of the surface's own depth.
  ProbeReport at(const SurfacePlace& place, const std::optional<double>& receiver);
  // At a texel of the depth file; none where the file has no such texel.
  std::optional<ProbeReport> at(const Pixel& texel, const std::optional<double>& receiver);

  // What was adapted may be of settings that are gone.
  void sessionChanged(const Document& before, const Document& after);

 private:
  void adaptTechniques(const DepthMap& map, int revision);
  // `first` is the map of the first cascade, to which techniques are adapted.
  ProbeReport probe(ProbeRequest request, const DepthMap& first, int revision);

  SessionController& controller_;
  SceneView& view_;
  std::vector<std::shared_ptr<const Technique>> adapted_;  // to the map of `adaptedTo_`
  int adaptedTo_ = -1;
  std::vector<double> splits_;  // that the picture's technique has in adapted_
};

}  // namespace umbra
