// What the window has open: the session, and what its source was read into.
#pragma once

#include <string>

#include "datasets/session/LoadSource.h"
#include "datasets/session/Session.h"

namespace umbra {

struct Document {
  Session session;
  Content content;
};

// "Tree over a bench", "truck.obj": for title bars and messages.
std::string titleOf(const SceneSource& source);

}  // namespace umbra
