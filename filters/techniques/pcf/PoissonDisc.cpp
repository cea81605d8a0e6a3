#include "filters/techniques/pcf/PoissonDisc.h"

#include <cmath>
#include <numbers>

namespace umbra::pcf {
namespace {

// Scales a coordinate of a disc of radius 1024² to a window of 2·reach + 1 texels, rounded to whole
// texels from the middle one.
int texelsOf(int rotated, int reach) {
  return (rotated * (2 * reach + 1) + (1 << 20)) >> 21;
}

template <std::size_t N>
std::string tableText(const char* name, const std::array<Offset, N>& table) {
  const std::string type = "ivec2[" + std::to_string(N) + "]";
  std::string text = "const " + type + " " + name + " = " + type + "(";
  for (std::size_t i = 0; i < N; ++i)
    text += (i ? ", ivec2(" : "ivec2(") + std::to_string(table[i].x) + ", " +
            std::to_string(table[i].y) + ")";
  return text + ");\n";
}

}  // namespace

const std::array<Offset, rotationCount>& rotations() {
  static const auto table = [] {
    std::array<Offset, rotationCount> turns{};
    for (int i = 0; i < rotationCount; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / rotationCount;
      turns[i] = {int(std::lround(1024.0 * std::cos(angle))),
                  int(std::lround(1024.0 * std::sin(angle)))};
    }
    return turns;
  }();
  return table;
}

Offset tapOffset(int tap, int x, int y, int reachX, int reachY) {
  const Offset point = discPoints[tap];
  const Offset turn = rotations()[rotationOf(std::uint32_t(x), std::uint32_t(y))];
  return {texelsOf(turn.x * point.x - turn.y * point.y, reachX),
          texelsOf(turn.y * point.x + turn.x * point.y, reachY)};
}

std::string discTables() {
  return tableText("umbraDiscPoints", discPoints) + tableText("umbraDiscRotations", rotations());
}

}  // namespace umbra::pcf
