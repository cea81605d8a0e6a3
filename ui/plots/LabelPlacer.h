// Finds places for a plot's labels: beside what they name, off the curves and off one another.
#pragma once

#include <QLineF>
#include <QRectF>
#include <vector>

namespace umbra {

class LabelPlacer {
 public:
  // Labels stay inside `area`; all lengths are in the painter's pixels.
  explicit LabelPlacer(const QRectF& area);

  // What a label had better not cover: a piece of a curve, or a filled shape.
  void avoid(const QLineF& line);
  void avoid(const QRectF& rectangle);

  // The best of `candidates`, which is taken from now on; of equally good ones the first. An
  // overlap with another label is worse than any number of covered curves, and leaving the area is
  // worse than an overlap.
  QRectF place(const std::vector<QRectF>& candidates);

 private:
  int covered(const QRectF& rectangle) const;
  double cost(const QRectF& candidate) const;
  void mark(double x, double y);

  QRectF area_;
  int columns_ = 0, rows_ = 0;
  std::vector<char> occupied_;  // by cells of cellSize pixels, row by row
  std::vector<QRectF> taken_;
};

}  // namespace umbra
