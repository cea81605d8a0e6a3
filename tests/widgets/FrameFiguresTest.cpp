// What the status line says of a frame's map.
#include "ui/picture/FrameFigures.h"

#include <gtest/gtest.h>

#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {
namespace {

QString textOf(const char* id, const FrameSettings& settings) {
  return mapText(settings, *allTechniques().make(id));
}

// Two channels of four bytes. The program has the depth beside them, and for the blur two copies.
TEST(MapText, TellsTheMethodsTexturesFromTheProgramsOwn) {
  FrameSettings settings;
  EXPECT_EQ(textOf("vsm", settings), "map 1024² · float · 2 channels · 8 MiB stored, 28 used");
  settings.kernel.shape = KernelShape::None;
  EXPECT_EQ(textOf("vsm", settings), "map 1024² · float · 2 channels · 8 MiB stored, 12 used");
  EXPECT_EQ(textOf("pcf", settings), "map 1024² · float · 1 channel · 4 MiB stored, 8 used");
}

TEST(MapText, CountsCascadesAndPartsOfAMebibyte) {
  FrameSettings settings;
  settings.kernel.shape = KernelShape::None;
  settings.map.size = 256;
  settings.map.format = StorageFormat::Unorm8;
  settings.map.cascades.count = 3;
  // 3 · 256² texels are 0.1875 MiB for each byte: 2 and 2 + 4.
  EXPECT_EQ(textOf("vsm", settings), "map 256² · unorm8 · 2 channels · 0.4 MiB stored, 1.1 used");
}

}  // namespace
}  // namespace umbra
