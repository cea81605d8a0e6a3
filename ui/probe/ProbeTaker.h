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

// With the session's settings, in the last frame's maps. A technique is adapted to a map once,
// whoever takes a probe in it.
class ProbeTaker {
 public:
  ProbeTaker(SessionController& controller, SceneView& view);

  // At a place of the last frame; `receiver` takes the place of the surface's own depth.
  ProbeReport at(const SurfacePlace& place, const std::optional<double>& receiver);
  // At a texel of the depth file; none where the file has no such texel.
  std::optional<ProbeReport> at(const Pixel& texel, const std::optional<double>& receiver);

 private:
  using SharedMap = std::shared_ptr<const DepthMap>;
  struct Adapted {
    std::shared_ptr<const Technique> asSet;  // the controller's
    std::vector<double> splits;              // that the frame was drawn with
    std::shared_ptr<const Technique> technique;
  };

  void adaptTechniques(const SharedMap& map);
  // `first` is the map of the first cascade, to which techniques are adapted; the report keeps
  // `maps`, which the request refers to.
  ProbeReport probe(ProbeRequest request, const SharedMap& first, std::vector<SharedMap> maps);

  SessionController& controller_;
  SceneView& view_;
  std::vector<Adapted> adapted_;
  SharedMap adaptedTo_;
};

}  // namespace umbra
