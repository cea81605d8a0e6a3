// What the window has open: the session, and what its source was read into.
#pragma once

#include <memory>

#include "datasets/Session.h"
#include "filters/core/Image.h"

namespace umbra {

// Exactly one of the two is set. Shared and never changed, so that an undo step costs nothing.
struct Content {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const DepthMap> depth;

  bool operator==(const Content&) const = default;
};

struct Document {
  Session session;
  Content content;
};

// Reads or builds what `source` names. Throws BadInput. Safe on any thread.
Content loadContent(const SceneSource& source);

// "Tree over a bench", "truck.obj": for title bars and messages.
std::string titleOf(const SceneSource& source);

}  // namespace umbra
