// The bytes of a map's textures, against a count of their layouts by hand.
#include <gtest/gtest.h>

#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/gpu/ChannelBaker.h"

namespace umbra {
namespace {

FrameSettings settingsOf(StorageFormat format, KernelShape shape) {
  FrameSettings settings;
  settings.map.size = 64;
  settings.map.format = format;
  settings.kernel = {shape, 3};
  return settings;
}

std::size_t texelBytesOf(const char* id, StorageFormat format, KernelShape shape) {
  return textureBytes(settingsOf(format, shape), *allTechniques().make(id)) / (64 * 64);
}

TEST(TextureBytes, CountDepthEncodedBetweenTheAxesAndReduced) {
  // Two channels: depth 4, encoded and reduced 2 · 2 each, between the axes 2 · 4.
  EXPECT_EQ(texelBytesOf("vsm", StorageFormat::Half, KernelShape::Box), 4u + 4u + 8u + 4u);
  EXPECT_EQ(texelBytesOf("vsm", StorageFormat::Float, KernelShape::Gaussian), 4u + 8u + 8u + 8u);
}

TEST(TextureBytes, CountNoPrefilterWhereThereIsNone) {
  EXPECT_EQ(texelBytesOf("vsm", StorageFormat::Float, KernelShape::None), 4u + 8u);
  EXPECT_EQ(texelBytesOf("pcf", StorageFormat::Float, KernelShape::Box), 4u + 4u);
}

// Three channels lie in a texture of four.
TEST(TextureBytes, CountWholeLayersOfFour) {
  ASSERT_EQ(allTechniques().make("power-cdf")->channels().size(), 3u);
  EXPECT_EQ(texelBytesOf("power-cdf", StorageFormat::Float, KernelShape::Box), 4u + 3u * 16u);
}

// Levels of 32, 16 … 1 texels a side beside the 64 of the map.
TEST(TextureBytes, CountMipLevelsSamplesAndCascades) {
  FrameSettings settings = settingsOf(StorageFormat::Half, KernelShape::None);
  const auto technique = allTechniques().make("vsm");
  settings.read.filter = ReadFilter::Trilinear;
  const std::size_t levels = 32 * 32 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1;
  EXPECT_EQ(textureBytes(settings, *technique), 64 * 64 * (4 + 4) + levels * 4);
  settings.map.samples = 4;
  EXPECT_EQ(textureBytes(settings, *technique), 64 * 64 * (4 * 4 + 4) + levels * 4);
  settings.map.cascades.count = 3;
  EXPECT_EQ(textureBytes(settings, *technique), 3 * (64 * 64 * (4 * 4 + 4) + levels * 4));
}

}  // namespace
}  // namespace umbra
