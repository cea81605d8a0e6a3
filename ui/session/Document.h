// What the window has open: the workspace, and what its source was read into.
#pragma once

#include <QPoint>
#include <string>
#include <utility>

#include "datasets/session/LoadSource.h"
#include "datasets/session/Workspace.h"

namespace umbra {

struct Document {
  Document() = default;
  Document(Workspace opened, Content read)
      : workspace(std::move(opened)), content(std::move(read)), session(sessionOf(workspace)) {}

  Workspace workspace;
  Content content;
  Session session;  // what the active pane of the workspace shows
};

// What the first texel of an open depth map is called, in the file's own count.
QPoint originOf(const Content& content);

// "Tree over a bench", "truck.obj": for title bars and messages.
std::string titleOf(const SceneSource& source);

}  // namespace umbra
