// How far two pictures of the same frame may differ.
#pragma once

#include <QImage>
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace umbra::cli {

// Another processor rounds otherwise, which moves edges: as much as it does to move light and
// camera by one unit in the last place of a float. That changed these frames by 3e-6 at most, and
// no pixel by more than 0.1. A path of some thirty roundings, from vertex to channel and back,
// gives 1e-4; a pixel that an edge crosses changes by up to 1, and about 1e-3 of them could change
// by that 0.1. The planes are lit a little aslant for it: overhead, their sides lie along the
// light's rays, and a last bit decides whether 1 % of the picture faces the light.
inline constexpr double largestMean = 1e-4, largestShare = 1e-3;

// The difference of two pictures, by the largest difference of a pixel's channels in [0,1]: its
// mean, and the share of pixels where it is above 0.1.
struct Difference {
  double mean = 0.0, share = 0.0;

  bool within(double times) const {
    return mean <= times * largestMean && share <= times * largestShare;
  }
  bool beyond(double times) const { return mean > times * largestMean; }
};

inline std::ostream& operator<<(std::ostream& stream, const Difference& difference) {
  return stream << "mean " << difference.mean << ", share " << difference.share;
}

inline Difference differenceOf(const QImage& a, const QImage& b) {
  Difference difference;
  const double pixels = double(a.width()) * a.height();
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      int largest = 0;
      for (int c = 0; c < 3; ++c)
        largest = std::max(largest,
                           std::abs(a.constScanLine(y)[3 * x + c] - b.constScanLine(y)[3 * x + c]));
      difference.mean += largest / 255.0 / pixels;
      difference.share += (largest > 0.1 * 255.0) / pixels;
    }
  return difference;
}

inline QImage readPicture(const std::string& file) {
  return QImage(QString::fromStdString(file)).convertToFormat(QImage::Format_RGB888);
}

}  // namespace umbra::cli
