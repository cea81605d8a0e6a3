#include "analysis/errors/WorstPixel.h"

#include <algorithm>
#include <cmath>

namespace umbra {
namespace {

constexpr int reach = 6;  // pixels on either side of a spot's middle
constexpr int spotSide = 2 * reach + 1;
constexpr double plainBleeding = 0.05;   // mean error of a spot that anybody sees at once
constexpr double umbraReference = 0.02;  // mean reference of a spot that is fully in shadow
constexpr double smoothBend = 5e-4;      // mean second difference of z_r over a spot on one surface

// Sums from the top-left corner, so that the mean over any spot costs four look-ups.
class SpotMeans {
 public:
  template <class Value>
  SpotMeans(int width, int height, Value value) : sums_(width + 1, height + 1) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        sums_(x + 1, y + 1) = value(x, y) + sums_(x, y + 1) + sums_(x + 1, y) - sums_(x, y);
  }
  double about(int x, int y) const {
    const int left = x - reach, top = y - reach;
    return (sums_(left + spotSide, top + spotSide) - sums_(left, top + spotSide) -
            sums_(left + spotSide, top) + sums_(left, top)) /
           (spotSide * spotSide);
  }

 private:
  Image<double> sums_;
};

// How far z_r is from linear between a pixel's neighbours, along either axis: near 0 inside a flat
// or gently curved surface, large at edges, and 1 where there is no light or shadow, or beside
// that.
double bend(const SurfaceImage& surfaces, int x, int y) {
  if (!surfaces.receivesShadow(x, y)) return 1.0;
  bool edge = false;
  const auto at = [&](int px, int py) {
    const int column = std::clamp(px, 0, surfaces.width() - 1);
    const int row = std::clamp(py, 0, surfaces.height() - 1);
    const std::optional<SurfacePoint> surface = surfaces.at(column, row);
    edge = edge || !surface || !surface->facesLight;
    return surfaces.receiver(column, row);
  };
  const float z = at(x, y);
  const float across = at(x - 1, y) + at(x + 1, y) - 2.0F * z;
  const float along = at(x, y - 1) + at(x, y + 1) - 2.0F * z;
  return edge ? 1.0 : std::min(1.0, double(std::max(std::abs(across), std::abs(along))));
}

// The pixel with the largest error in the spot about `middle`.
PicturePixel worstOfSpot(const SurfaceImage& surfaces, const Image<float>& reference,
                         PicturePixel middle) {
  PicturePixel worst = middle;
  const auto error = [&](int x, int y) { return surfaces.visibility(x, y) - reference(x, y); };
  for (int y = middle.y - reach; y <= middle.y + reach; ++y)
    for (int x = middle.x - reach; x <= middle.x + reach; ++x)
      if (error(x, y) > error(worst.x, worst.y)) worst = {x, y};
  return worst;
}

}  // namespace

std::optional<PicturePixel> worstBleeding(const SurfaceImage& surfaces,
                                          const Image<float>& reference) {
  const int width = surfaces.width(), height = surfaces.height();
  const SpotMeans errors(width, height, [&](int x, int y) {
    return double(surfaces.visibility(x, y)) - double(reference(x, y));
  });
  const SpotMeans references(width, height, [&](int x, int y) { return double(reference(x, y)); });
  const SpotMeans bends(width, height, [&](int x, int y) { return bend(surfaces, x, y); });
  std::optional<PicturePixel> inUmbra, anywhere;
  double mostInUmbra = plainBleeding, most = plainBleeding;
  // Spots near the border are left out, so that the surroundings of the spot can be seen.
  const int air = std::max(reach, std::min(width, height) / 12);
  for (int y = air; y < height - air; ++y)
    for (int x = air; x < width - air; ++x) {
      const double error = errors.about(x, y);
      if (error <= std::min(most, mostInUmbra) || bends.about(x, y) > smoothBend) continue;
      if (error > most) {
        most = error;
        anywhere = PicturePixel{x, y};
      }
      if (error > mostInUmbra && references.about(x, y) < umbraReference) {
        mostInUmbra = error;
        inUmbra = PicturePixel{x, y};
      }
    }
  if (!inUmbra && !anywhere) return std::nullopt;
  return worstOfSpot(surfaces, reference, inUmbra ? *inUmbra : *anywhere);
}

}  // namespace umbra
