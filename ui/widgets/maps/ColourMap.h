// From a number to a colour, for maps and legends.
#pragma once

#include <QColor>
#include <array>

namespace umbra {

enum class ColourMap {
  Viridis,    // depths and channels; perceptually even, Smith & van der Walt 2015
  Grey,       // black to white: visibility
  Diverging,  // blue, white in the middle, red: signed error
};

// 256 opaque colours from low to high.
const std::array<QRgb, 256>& colourTable(ColourMap map);

// `t` in [0,1], clamped; the nearest of the table.
QRgb colourAt(ColourMap map, double t);

}  // namespace umbra
