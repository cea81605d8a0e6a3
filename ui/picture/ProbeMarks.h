// Saved probes over the picture: a numbered disc at each, its name beside it.
#pragma once

#include <Eigen/Core>
#include <QPainter>
#include <QString>
#include <vector>

#include "ui/picture/SceneProjection.h"

namespace umbra {

struct ProbeMark {
  int number = 1;  // of its row in the table
  QString name;
  Eigen::Vector3d point;  // world
  bool hidden = false;    // from the camera: its disc is hollow
};

// `avoid` are shapes (logical pixels) that no name had better cover. Names keep off one another;
// one that finds no room is left out.
void drawMarks(QPainter& painter, const std::vector<ProbeMark>& marks,
               const SceneProjection& projection, const QRectF& area,
               const std::vector<QRectF>& avoid);

}  // namespace umbra
