// Pictures of the window as images that compare.
#pragma once

#include <QImage>
#include <string>
#include <vector>

#include "datasets/session/Workspace.h"
#include "ui/picture/SceneView.h"
#include "ui/window/MainWindow.h"

namespace umbra {

// A comparison on the three planes; the shared technique is the first of `techniques`.
inline Workspace comparing(ComparisonMode mode, const std::vector<std::string>& techniques) {
  Workspace workspace;
  workspace.shared.source.name = "three-planes";
  workspace.shared.technique = techniques.front();
  workspace.comparison = {mode, linkedPanes(techniques), 0, 0.5};
  return workspace;
}

// The last frame of the live view, without what is drawn over it.
inline QImage liveFrame(MainWindow& window) {
  const Image<std::uint8_t> colour = window.view().lastFrame()->colour();
  return QImage(colour.values().data(), colour.width(), colour.height(), colour.width() * 3,
                QImage::Format_RGB888)
      .copy();
}

inline QImage bare(QImage picture) {
  picture.setDevicePixelRatio(1.0);
  return picture.convertToFormat(QImage::Format_RGB888);
}

}  // namespace umbra
