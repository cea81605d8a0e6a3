// Damaged depth files of every format: each is read, with depths in [0, 1], or refused with its
// name.
#include <gtest/gtest.h>

#include <random>

#include "datasets/maps/DepthFile.h"
#include "datasets/maps/DepthFileSamples.h"
#include "datasets/maps/ExrFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class DepthFileMutation : public testing::TestWithParam<const char*> {
 protected:
  // Sound files of the format, of a few hundred texels at most.
  std::vector<std::string> samples(const std::string& format) const {
    const std::vector<float> few{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f};
    const fs::path file = folder_ / ("sample" + format);
    if (format == ".pfm") return {"Pf\n3 2\n-1.0\n" + floatBytes(few)};
    if (format == ".npy") return {npy("<f4", "False", "(2, 3)", floatBytes(few))};
    if (format == ".exr") {
      Image<float> image(24, 24);
      std::mt19937 random(7);
      for (float& value : image.values()) value = float(random() >> 8) * 0x1p-24f;
      writeExr(file, {{"Z", image}}, {{"note", "text"}});
      return {bytesOf(file)};
    }
    if (format == ".png") {
      writePng(file, 3, 2, 16, {0, 0, 0x80, 0, 0xff, 0xff, 0, 1, 0x12, 0x34, 0xff, 0xfe});
      const std::string plain = bytesOf(file);
      writePng(file, 9, 9, 8, std::vector<unsigned char>(81, 99), PNG_COLOR_TYPE_GRAY,
               PNG_INTERLACE_ADAM7);
      return {plain, bytesOf(file)};
    }
    std::vector<std::string> all;
    for (const int tile : {0, 16})
      for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
        TiffSample sample;
        sample.tile = tile;
        sample.compression = compression;
        sample.predictor = compression == COMPRESSION_NONE ? 1 : 3;
        writeTiff(file, sample, few.data());
        all.push_back(bytesOf(file));
      }
    return all;
  }

  const TemporaryFolder folder_;
};

std::string damaged(std::string content, std::mt19937& random) {
  // Every other file is hit within its first bytes, where headers are.
  const std::size_t reach = random() % 2 ? content.size() : std::min(content.size(), 400ul);
  for (unsigned change = 0; change <= random() % 3; ++change) {
    const std::size_t at = random() % std::min(reach, content.size());
    if (random() % 8 == 0)
      content.resize(at + 1);
    else
      content[at] = random() % 2 ? char(random()) : "0123456789(),'- "[random() % 16];
  }
  return content;
}

// A PNG whose checksums are right, so that its damage is not refused for these alone.
std::string withChecksums(std::string png) {
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | (png[at + i] & 0xff);
    return value;
  };
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = number(at);
    if (length > png.size() - at - 12) break;
    std::uint32_t remainder = 0xffffffffu;
    for (std::size_t i = at + 4; i < at + 8 + length; ++i) {
      remainder ^= png[i] & 0xffu;
      for (int bit = 0; bit < 8; ++bit)
        remainder = remainder & 1 ? 0xedb88320u ^ remainder >> 1 : remainder >> 1;
    }
    for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = char(~remainder >> (24 - 8 * i));
    at += 12 + length;
  }
  return png;
}

TEST_P(DepthFileMutation, ReadsOrRefusesTenThousandFiles) {
  const std::vector<std::string> sound = samples(GetParam());
  const fs::path file = folder_ / (std::string("damaged") + GetParam());
  DepthImport import;
  import.miss = {DepthMiss::Kind::Clamp, 0.0};
  std::mt19937 random(11);
  int read = 0, refused = 0;
  for (std::size_t i = 0; i < 10'000; ++i) {
    const std::string content = damaged(sound[i % sound.size()], random);
    writeBytes(file, file.extension() == ".png" ? withChecksums(content) : content);
    try {
      const DepthMap map = readDepth(file, import).map;
      for (double depth : map.values()) ASSERT_TRUE(depth >= 0.0 && depth <= 1.0) << depth;
      ++read;
    } catch (const Error& error) {
      ASSERT_EQ(error.kind(), ErrorKind::BadInput);
      ASSERT_TRUE(std::string_view(error.what()).starts_with(file.string())) << error.what();
      ASSERT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 1000);
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, DepthFileMutation,
                         testing::Values(".pfm", ".npy", ".exr", ".png", ".tif"),
                         [](const auto& one) { return std::string(one.param).substr(1); });

}  // namespace
}  // namespace umbra
