#include "ui/widgets/maps/ColourMap.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "filters/gpu/ViewColours.h"

namespace umbra {
namespace {

// Evenly spaced samples of the viridis map; between them it is straight to within two levels.
constexpr QRgb viridis[] = {0xff440154, 0xff481567, 0xff482677, 0xff453781, 0xff404788,
                            0xff39568c, 0xff33638d, 0xff2d708e, 0xff287d8e, 0xff238a8d,
                            0xff1f968b, 0xff20a387, 0xff29af7f, 0xff3cbb75, 0xff55c667,
                            0xff73d055, 0xff95d840, 0xffb8de29, 0xffdce319, 0xfffde725};
constexpr QRgb grey[] = {0xff000000, 0xffffffff};

QRgb rgbOf(const ViewColour& colour) {
  return QColor::fromRgbF(double(colour[0]), double(colour[1]), double(colour[2])).rgb();
}
// The error view's own colours.
const QRgb diverging[] = {rgbOf(darkeningColour), rgbOf(noErrorColour), rgbOf(bleedingColour)};

std::array<QRgb, 256> tableOf(std::span<const QRgb> stops) {
  std::array<QRgb, 256> table{};
  for (int i = 0; i < 256; ++i) {
    const double place = i / 255.0 * double(stops.size() - 1);
    const std::size_t left = std::min(std::size_t(place), stops.size() - 2);
    const double part = place - double(left);
    const QRgb a = stops[left], b = stops[left + 1];
    const auto mixed = [part](int from, int to) {
      return int(std::lround(from + part * (to - from)));
    };
    table[std::size_t(i)] =
        qRgb(mixed(qRed(a), qRed(b)), mixed(qGreen(a), qGreen(b)), mixed(qBlue(a), qBlue(b)));
  }
  return table;
}

}  // namespace

const std::array<QRgb, 256>& colourTable(ColourMap map) {
  static const std::array<QRgb, 256> tables[] = {tableOf(viridis), tableOf(grey),
                                                 tableOf(diverging)};
  return tables[std::size_t(map)];
}

QRgb colourAt(ColourMap map, double t) {
  return colourTable(map)[std::size_t(std::lround(std::clamp(t, 0.0, 1.0) * 255.0))];
}

}  // namespace umbra
