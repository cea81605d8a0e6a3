#include "ui/WorstPixel.h"

#include <algorithm>

namespace umbra {
namespace {

constexpr int reach = 4;          // pixels on either side that are averaged
constexpr double visible = 0.05;  // mean error of a spot that anybody sees

// Errors of the surfaces that the light reaches; a spot across a silhouette counts its outside as
// none.
Image<double> errorsOf(const Image<float>& surfaces, const Image<float>& reference) {
  Image<double> errors(surfaces.width(), surfaces.height());
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x) {
      const float u = surfaces(x, y, 0), v = surfaces(x, y, 1), receiver = surfaces(x, y, 2);
      const bool shaded = u >= 0.0F && u <= 1.0F && v >= 0.0F && v <= 1.0F && receiver > 0.0F;
      if (shaded) errors(x, y) = double(surfaces(x, y, 3)) - double(reference(x, y));
    }
  return errors;
}

}  // namespace

std::optional<Pixel> worstBleeding(const Image<float>& surfaces, const Image<float>& reference) {
  const Image<double> errors = errorsOf(surfaces, reference);
  // Sums from the top-left corner, so that every spot costs four look-ups.
  Image<double> sums(errors.width() + 1, errors.height() + 1);
  for (int y = 0; y < errors.height(); ++y)
    for (int x = 0; x < errors.width(); ++x)
      sums(x + 1, y + 1) = errors(x, y) + sums(x, y + 1) + sums(x + 1, y) - sums(x, y);
  std::optional<Pixel> worst;
  double most = visible;
  const int side = 2 * reach + 1;
  for (int y = reach; y < errors.height() - reach; ++y)
    for (int x = reach; x < errors.width() - reach; ++x) {
      const int left = x - reach, top = y - reach;
      const double mean = (sums(left + side, top + side) - sums(left, top + side) -
                           sums(left + side, top) + sums(left, top)) /
                          (side * side);
      if (mean > most && errors(x, y) > visible) {
        most = mean;
        worst = Pixel{x, y};
      }
    }
  return worst;
}

}  // namespace umbra
