#include "datasets/maps/DepthFile.h"
#include "datasets/maps/DepthFileSamples.h"
#include "datasets/maps/ExrFile.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "filters/core/settings/StorageFormat.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class DepthFiles : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_ / name; }

  // The message of the BadInput that reading must throw.
  std::string refusal(const fs::path& file, const std::string& channel = "", double near = 0.0,
                      double far = 1.0) const {
    try {
      readDepthFile(file, channel, near, far);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      const std::string message = error.what();
      EXPECT_EQ(message.find(file.string()), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(std::min(message.size(), file.string().size()));
    }
    return "no error";
  }

 private:
  const TemporaryFolder folder_;
};

Image<float> noise(int width, int height) {
  Image<float> image(width, height);
  std::mt19937 random(7);
  for (float& value : image.values()) value = float(random() >> 8) * 0x1p-24f;
  return image;
}

Imf::Header headerFor(const Imath::Box2i& window, Imf::PixelType type) {
  Imf::Header header(window, window);
  header.channels().insert("Z", Imf::Channel(type));
  return header;
}

Imf::FrameBuffer frameOf(Image<float>& image, const Imath::Box2i& window) {
  Imf::FrameBuffer frame;
  frame.insert("Z", Imf::Slice::Make(Imf::FLOAT, image.values().data(), window));
  return frame;
}

TEST_F(DepthFiles, GivesBackWhatWasWritten) {
  const Image<float> image = noise(13, 7);
  writeExr(path("m.exr"), {{"Z", image}}, {{"program", "a test"}});
  const DepthMap map = readDepthFile(path("m.exr"));
  ASSERT_EQ(map.width(), 13);
  ASSERT_EQ(map.height(), 7);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 13; ++x) EXPECT_EQ(map(x, y), double(image(x, y)));
  const Imf::InputFile exr(path("m.exr").c_str());
  EXPECT_EQ(exr.header().compression(), Imf::ZIP_COMPRESSION);
  const auto* program = exr.header().findTypedAttribute<Imf::StringAttribute>("program");
  ASSERT_TRUE(program);
  EXPECT_EQ(program->value(), "a test");
}

TEST_F(DepthFiles, RoundsToHalfOnceWhenAskedTo) {
  const Image<float> image = noise(9, 9);
  writeExr(path("m.exr"), {{"Z", image}}, {}, ExrPixel::Half);
  const DepthMap map = readDepthFile(path("m.exr"));
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      EXPECT_EQ(map(x, y), stored(image(x, y), StorageFormat::Half)) << x << "," << y;
}

TEST_F(DepthFiles, NormalisesInDoubleAlsoWhenNearIsTheLargerValue) {
  Image<float> image(2, 1);
  image(0, 0) = 2.3f;
  image(1, 0) = 9.0f;
  writeExr(path("m.exr"), {{"Z", image}}, {});
  const DepthMap map = readDepthFile(path("m.exr"), "", 1.0, 11.0);
  EXPECT_EQ(map(0, 0), (double(2.3f) - 1.0) / 10.0);
  EXPECT_EQ(map(1, 0), 0.8);
  EXPECT_EQ(readDepthFile(path("m.exr"), "", 11.0, 1.0)(1, 0), 0.2);
}

TEST_F(DepthFiles, TakesZElseTheOnlyChannelElseListsThem) {
  const Image<float> a(4, 4, 1, 0.25f), b(4, 4, 1, 0.75f);
  writeExr(path("one.exr"), {{"depth", a}}, {});
  EXPECT_EQ(readDepthFile(path("one.exr"))(0, 0), 0.25);
  writeExr(path("z.exr"), {{"A", a}, {"Z", b}}, {});
  EXPECT_EQ(readDepthFile(path("z.exr"))(0, 0), 0.75);
  EXPECT_EQ(readDepthFile(path("z.exr"), "A")(0, 0), 0.25);
  writeExr(path("two.exr"), {{"R", a}, {"G", b}}, {});
  EXPECT_EQ(refusal(path("two.exr")),
            ": there is no channel 'Z'; there are G (0.75 to 0.75), R (0.25 to 0.25): name one as "
            "FILE.exr:CHANNEL");
  EXPECT_EQ(refusal(path("two.exr"), "B"),
            ": there is no channel 'B'; there are G (0.75 to 0.75), R (0.25 to 0.25)");
}

TEST_F(DepthFiles, NamesTheTexelOfAValueThatIsNoDepth) {
  const float wrong[] = {std::numeric_limits<float>::quiet_NaN(),
                         std::numeric_limits<float>::infinity(),
                         -std::numeric_limits<float>::infinity(), 1.5f, -0.25f};
  const std::string shown[] = {"nan", "inf", "-inf", "1.5", "-0.25"};
  const std::string advice =
      "--depth-miss clamp would take the nearest bound, --depth-miss VALUE names the value of "
      "texels that saw nothing";
  for (int i = 0; i < 5; ++i) {
    Image<float> image(6, 5, 1, 0.5f);
    image(4, 2) = wrong[i];
    writeExr(path("m.exr"), {{"Z", image}}, {});
    EXPECT_EQ(refusal(path("m.exr")),
              ": texel 4,2 is " + shown[i] + "; depths are finite numbers from 0 to 1; " + advice);
  }
}

TEST_F(DepthFiles, RefusesAnEmptyRange) {
  writeExr(path("m.exr"), {{"Z", noise(3, 3)}}, {});
  EXPECT_NE(refusal(path("m.exr"), "", 2.0, 2.0).find("near and far must differ"),
            std::string::npos);
  EXPECT_NE(refusal(path("m.exr"), "", 0.0, std::nan("")).find("near and far must differ"),
            std::string::npos);
}

TEST_F(DepthFiles, ReadsTiledFilesAndAnyDataWindow) {
  const Imath::Box2i window({-3, 40}, {16, 51});
  Image<float> image = noise(20, 12);
  {
    Imf::Header header = headerFor(window, Imf::FLOAT);
    header.setTileDescription(Imf::TileDescription(8, 8, Imf::MIPMAP_LEVELS));
    Imf::TiledOutputFile file(path("tiled.exr").c_str(), header);
    file.setFrameBuffer(frameOf(image, window));
    file.writeTiles(0, file.numXTiles(0) - 1, 0, file.numYTiles(0) - 1, 0);
    // The smaller levels are of no interest but belong to a whole file.
    for (int level = 1; level < file.numLevels(); ++level)
      file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
  }
  const DepthMap map = readDepthFile(path("tiled.exr"));
  ASSERT_EQ(map.width(), 20);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x) EXPECT_EQ(map(x, y), double(image(x, y)));
}

TEST_F(DepthFiles, FindsAChannelInOneOfSeveralParts) {
  const Imath::Box2i window({0, 0}, {3, 3});
  Image<float> first(4, 4, 1, 0.25f), second(4, 4, 1, 0.5f);
  std::vector<Imf::Header> headers(2, headerFor(window, Imf::FLOAT));
  headers[0].setName("near");
  headers[1].setName("far");
  for (Imf::Header& header : headers) header.setType(Imf::SCANLINEIMAGE);
  {
    Imf::MultiPartOutputFile file(path("parts.exr").c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(frameOf(i == 0 ? first : second, window));
      part.writePixels(4);
    }
  }
  EXPECT_EQ(readDepthFile(path("parts.exr"), "far.Z")(1, 1), 0.5);
  EXPECT_EQ(readDepthFile(path("parts.exr"))(1, 1), 0.25);
  EXPECT_EQ(refusal(path("parts.exr"), "W"),
            ": there is no channel 'W'; there are near.Z (0.25 to 0.25), far.Z (0.5 to 0.5)");
}

TEST_F(DepthFiles, ReadsEveryPartThatWasWritten) {
  const Image<float> near = noise(6, 5), far = noise(6, 5);
  writeExr(path("parts.exr"), {{"near", {{"Z", near}}, {{"note", "first"}}},
                               {"far", {{"Z", far}, {"A", near}}, {{"note", "second"}}}});
  EXPECT_EQ(readDepthFile(path("parts.exr"), "near.Z")(4, 3), near(4, 3));
  EXPECT_EQ(readDepthFile(path("parts.exr"), "far.Z")(4, 3), far(4, 3));
  EXPECT_EQ(readDepthFile(path("parts.exr"), "A")(5, 4), near(5, 4));
  EXPECT_THROW(writeExr(path("same.exr"), {{"a", {{"Z", near}}, {}}, {"a", {{"Z", far}}, {}}}),
               Error);
  EXPECT_FALSE(fs::exists(path("same.exr")));
}

TEST_F(DepthFiles, RefusesDeepFilesAndReadsWholeNumbers) {
  const Imath::Box2i window({0, 0}, {1, 1});
  {
    Imf::Header header = headerFor(window, Imf::FLOAT);
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    Imf::DeepScanLineOutputFile file(path("deep.exr").c_str(), header);
    std::vector<unsigned> counts(4, 1);
    std::vector<float> depths(4, 0.5f);
    std::vector<float*> pointers;
    for (float& depth : depths) pointers.push_back(&depth);
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                            sizeof(unsigned), 2 * sizeof(unsigned)));
    frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()),
                                     sizeof(float*), 2 * sizeof(float*), sizeof(float)));
    file.setFrameBuffer(frame);
    file.writePixels(2);
  }
  EXPECT_EQ(refusal(path("deep.exr")), ": is a deep file; a depth map has one value per pixel");
  {
    Imf::OutputFile file(path("uint.exr").c_str(), headerFor(window, Imf::UINT));
    std::vector<unsigned> values{0, 1u << 31, 3u << 30, 4294967295u};
    Imf::FrameBuffer frame;
    frame.insert("Z", Imf::Slice::Make(Imf::UINT, values.data(), window));
    file.setFrameBuffer(frame);
    file.writePixels(2);
  }
  // Whole numbers keep all their bits: a float would round the last one.
  const DepthMap whole = readDepthFile(path("uint.exr"), "", 0.0, 4294967295.0);
  EXPECT_EQ(whole(1, 0), 2147483648.0 / 4294967295.0);
  EXPECT_EQ(whole(1, 1), 1.0);
}

TEST_F(DepthFiles, RefusesWhatIsNoWholeFile) {
  EXPECT_EQ(refusal(path("absent.exr")), ": there is no such file");
  writeBytes(path("text.exr"), "not a picture");
  EXPECT_NE(refusal(path("text.exr")).find("cannot be read as OpenEXR"), std::string::npos);
  writeExr(path("m.exr"), {{"Z", noise(64, 64)}}, {});
  const std::string whole = bytesOf(path("m.exr"));
  for (std::size_t kept :
       {std::size_t(0), std::size_t(20), whole.size() / 3, whole.size() / 2, whole.size() - 1}) {
    writeBytes(path("cut.exr"), whole.substr(0, kept));
    EXPECT_NE(refusal(path("cut.exr")), "no error") << kept << " bytes of " << whole.size();
  }
}

// The library checks only the stated size; a smaller size must still fit the file.
TEST_F(DepthFiles, RefusesASizeThatTheFileCannotHold) {
  writeExr(path("m.exr"), {{"Z", noise(4, 4)}}, {});
  std::string bytes = bytesOf(path("m.exr"));
  for (const std::string name : {"dataWindow", "displayWindow"}) {
    // Name, 0, "box2i", 0, 4 bytes of length, then xMin, yMin, xMax, yMax.
    const std::size_t box = bytes.find(name) + name.size() + 1 + 6 + 4;
    for (std::size_t limit : {box + 8, box + 12}) {
      ASSERT_EQ(bytes[limit], 3);
      bytes[limit] = char(0xff);
      bytes[limit + 1] = 0x0f;  // 4095
    }
  }
  // The table of line offsets belongs to the header, so it is complete, but nothing follows it.
  bytes.resize(bytes.size() + 4096 / 16 * 8);
  writeBytes(path("wide.exr"), bytes);
  EXPECT_NE(refusal(path("wide.exr")).find("promises 4096 × 4096 pixels"), std::string::npos)
      << refusal(path("wide.exr"));
  // Beyond the largest side the library refuses by itself.
  const std::size_t width = bytes.find("dataWindow") + 10 + 1 + 6 + 4 + 8;
  bytes[width + 1] = 0x7f;
  writeBytes(path("wide.exr"), bytes);
  EXPECT_NE(refusal(path("wide.exr")), "no error");
}

// OpenEXR would allocate 2 GiB before it finds that they are not there.
TEST_F(DepthFiles, RefusesAnAttributeThatTheFileCannotHold) {
  const std::string header(
      "v/1\x01\x02\0\0\0name\0string\0\xff\xff\xff\x7f"
      "x",
      24 + 1);
  std::ofstream(path("promise.exr"), std::ios::binary) << header;
  EXPECT_EQ(refusal(path("promise.exr")),
            ": the attribute 'name' promises 2147483647 bytes, the file has 1 after it");
}

TEST_F(DepthFiles, LeavesWhatStoodThereWhenItCannotWrite) {
  writeExr(path("m.exr"), {{"Z", noise(4, 4)}}, {});
  const std::string before = bytesOf(path("m.exr"));
  EXPECT_THROW(writeExr(path("m.exr"), {{"A", noise(4, 4)}, {"B", noise(5, 4)}}, {}), Error);
  EXPECT_EQ(bytesOf(path("m.exr")), before);
  try {
    writeExr(path("m.exr") / "below-a-file.exr", {{"Z", noise(4, 4)}}, {});
    FAIL() << "wrote below a file";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadOutput);
  }
}

TEST(DepthArgument, SplitsAtTheColonBehindTheExtension) {
  using Pair = std::pair<fs::path, std::string>;
  EXPECT_EQ(splitDepthArgument("m.exr"), Pair("m.exr", ""));
  EXPECT_EQ(splitDepthArgument("m.exr:Z"), Pair("m.exr", "Z"));
  EXPECT_EQ(splitDepthArgument("a:b/m.EXR:near.Z"), Pair("a:b/m.EXR", "near.Z"));
  EXPECT_EQ(splitDepthArgument("a:b.exr"), Pair("a:b.exr", ""));
  EXPECT_EQ(splitDepthArgument("m.exr:"), Pair("m.exr", ""));
}

}  // namespace
}  // namespace umbra
