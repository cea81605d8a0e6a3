// The stages of a frame in their order. Each stage needs what the stages before it have made.
#pragma once

#include <string_view>

namespace umbra {

enum class Stage {
  Depth,      // the shadow maps' depths
  Encode,     // the technique's channels
  Prefilter,  // those averaged by the kernel
  Read,       // what a read needs of them: mip levels, sums
  Shade,      // visibility and colour of every pixel
  Nothing,    // only how the picture shows what was shaded
};

std::string_view nameOf(Stage stage);

}  // namespace umbra
