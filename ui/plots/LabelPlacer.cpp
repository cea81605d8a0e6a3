#include "ui/plots/LabelPlacer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace umbra {
namespace {

constexpr double cellSize = 4.0;  // pixels: about the gap that the eye wants beside a curve

double areaOf(const QRectF& r) {
  return r.isValid() ? r.width() * r.height() : 0.0;
}

}  // namespace

LabelPlacer::LabelPlacer(const QRectF& area)
    : area_(area),
      columns_(std::max(1, int(std::ceil(area.width() / cellSize)))),
      rows_(std::max(1, int(std::ceil(area.height() / cellSize)))),
      occupied_(std::size_t(columns_) * std::size_t(rows_), 0) {}

void LabelPlacer::mark(double x, double y) {
  const int column = int(std::floor((x - area_.left()) / cellSize));
  const int row = int(std::floor((y - area_.top()) / cellSize));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
  occupied_[std::size_t(row) * columns_ + column] = 1;
}

void LabelPlacer::avoid(const QLineF& line) {
  if (!std::isfinite(line.dx()) || !std::isfinite(line.dy())) return;
  // Enough steps to touch every cell inside the area, however far outside the line ends.
  const int steps = int(std::min(4096.0, std::ceil(line.length() / (cellSize / 2)))) + 1;
  for (int i = 0; i <= steps; ++i) {
    const QPointF p = line.pointAt(double(i) / steps);
    mark(p.x(), p.y());
  }
}

void LabelPlacer::avoid(const QRectF& rectangle) {
  const QRectF inside = rectangle.normalized() & area_;
  for (double y = inside.top(); y < inside.bottom(); y += cellSize)
    for (double x = inside.left(); x < inside.right(); x += cellSize) mark(x, y);
}

int LabelPlacer::covered(const QRectF& rectangle) const {
  const auto clampedTo = [](double value, int end) {
    return std::clamp(int(std::floor(value / cellSize)), 0, end - 1);
  };
  const int left = clampedTo(rectangle.left() - area_.left(), columns_);
  const int right = clampedTo(rectangle.right() - area_.left(), columns_);
  const int top = clampedTo(rectangle.top() - area_.top(), rows_);
  const int bottom = clampedTo(rectangle.bottom() - area_.top(), rows_);
  int count = 0;
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column)
      count += occupied_[std::size_t(row) * columns_ + column];
  return count;
}

double LabelPlacer::cost(const QRectF& candidate) const {
  const double outside = areaOf(candidate) - areaOf(candidate & area_);
  double overlap = 0.0;
  for (const QRectF& other : taken_) overlap += areaOf(candidate & other);
  return 1e6 * outside + 1e3 * overlap + covered(candidate);
}

QRectF LabelPlacer::place(const std::vector<QRectF>& candidates) {
  QRectF best;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    // A label that is a little further down is better than one that covers half a curve.
    const double total = cost(candidates[i]) + 0.4 * double(i);
    if (total < lowest) {
      lowest = total;
      best = candidates[i];
    }
  }
  taken_.push_back(best);
  return best;
}

}  // namespace umbra
