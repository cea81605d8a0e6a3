#include "ui/errors/ErrorPicture.h"

#include <cmath>

#include "ui/widgets/maps/ColourMap.h"

namespace umbra {
namespace {

constexpr QRgb sky = qRgb(0xe4, 0xe7, 0xeb), unlit = qRgb(0xc9, 0xce, 0xd4);
constexpr double shadowed = 0.84;  // of the colour, in full shadow

QRgb dimmed(QRgb colour, double reference) {
  const double share = shadowed + (1.0 - shadowed) * reference;
  const auto part = [share](int channel) { return int(std::lround(share * channel)); };
  return qRgb(part(qRed(colour)), part(qGreen(colour)), part(qBlue(colour)));
}

}  // namespace

QImage errorPicture(const ErrorDecomposition& errors, std::optional<ErrorPart> part, double range,
                    const SurfaceImage& surfaces, const Image<float>& reference) {
  QImage picture(surfaces.width(), surfaces.height(), QImage::Format_RGB32);
  for (int y = 0; y < picture.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
    for (int x = 0; x < picture.width(); ++x) {
      const PicturePixel taken = errors.takenPixel(x, y);
      if (!errors.receives(taken.x, taken.y)) {
        line[x] = surfaces.shows(taken.x, taken.y) ? unlit : sky;
        continue;
      }
      const double error = errorAt(errors, taken.x, taken.y, part);
      line[x] = dimmed(colourAt(ColourMap::Diverging, 0.5 + 0.5 * error / range),
                       double(reference(taken.x, taken.y)));
    }
  }
  return picture;
}

}  // namespace umbra
