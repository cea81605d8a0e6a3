// Depths in PNG and TIFF pictures.
#include <gtest/gtest.h>

#include <cstdint>

#include "datasets/maps/DepthFile.h"
#include "datasets/maps/DepthFileSamples.h"
#include "datasets/maps/Raster.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class PictureRasters : public testing::Test {
 protected:
  std::string refusal(const fs::path& file) const {
    try {
      readDepthFile(file);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      EXPECT_TRUE(std::string_view(error.what()).starts_with(file.string())) << error.what();
      return error.what();
    }
    return "no error";
  }

  const TemporaryFolder folder_;
  const fs::path png_ = folder_ / "m.png", tiff_ = folder_ / "m.TIF";
};

TEST_F(PictureRasters, ReadGreyPngAsFractions) {
  writePng(png_, 3, 2, 16, {0, 0, 0x80, 0, 0xff, 0xff, 0, 1, 0x12, 0x34, 0xff, 0xfe});
  const DepthMap wide = readDepthFile(png_);
  EXPECT_EQ(wide.width(), 3);
  EXPECT_EQ(wide(0, 0), 0.0);
  EXPECT_EQ(wide(1, 0), 0x8000 / 65535.0);
  EXPECT_EQ(wide(2, 0), 1.0);
  EXPECT_EQ(wide(1, 1), 0x1234 / 65535.0);
  writePng(png_, 2, 1, 8, {0x80, 0xff});
  EXPECT_EQ(readDepthFile(png_)(0, 0), 128 / 255.0);
  writePng(png_, 4, 1, 2, {0b00'01'10'11});
  EXPECT_EQ(readDepthFile(png_)(1, 0), 1 / 3.0);
}

TEST_F(PictureRasters, ReadInterlacedPngAsThePlainOne) {
  std::vector<unsigned char> rows;
  for (int i = 0; i < 13 * 11 * 2; ++i) rows.push_back(static_cast<unsigned char>(37 * i + i / 9));
  writePng(png_, 13, 11, 16, rows);
  const DepthMap plain = readDepthFile(png_);
  writePng(png_, 13, 11, 16, rows, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_ADAM7);
  const DepthMap interlaced = readDepthFile(png_);
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 13; ++x) ASSERT_EQ(interlaced(x, y), plain(x, y)) << x << "," << y;
}

TEST_F(PictureRasters, RefusePngThatIsNoDepthMap) {
  writePng(png_, 1, 1, 8, {1, 2, 3}, PNG_COLOR_TYPE_RGB);
  EXPECT_NE(refusal(png_).find("colour picture"), std::string::npos);
  writePng(png_, 1, 1, 16, {1, 2, 3, 4}, PNG_COLOR_TYPE_GRAY_ALPHA);
  EXPECT_NE(refusal(png_).find("transparency"), std::string::npos);
  writePng(png_, 3, 2, 16, std::vector<unsigned char>(12, 7));
  const std::string whole = bytesOf(png_);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeBytes(png_, whole.substr(0, length));
    EXPECT_NE(refusal(png_).find("as PNG"), std::string::npos) << length;
  }
}

// A bound is a value that the file can hold: 0.4 is 26214 of 65535, 0.6 is 39321.
TEST_F(PictureRasters, TakeABoundAsTheFileHoldsIt) {
  writePng(png_, 2, 1, 16, {26214 >> 8, 26214 & 255, 39321 >> 8, 39321 & 255});
  const DepthMap map = readDepthFile(png_, "", 0.400001, 0.6);
  EXPECT_EQ(map(0, 0), 0.0);
  EXPECT_EQ(map(1, 0), 1.0);
  EXPECT_EQ(shortest(26214 / 65535.0, RasterNumber::Fraction16), "0.4");
  EXPECT_EQ(shortest(1 / 65535.0, RasterNumber::Fraction16), "2e-05");
  EXPECT_EQ(shortest(128 / 255.0, RasterNumber::Fraction8), "0.5");
}

TEST_F(PictureRasters, ReadEveryKindOfTiff) {
  const std::vector<float> floats{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f};
  const std::vector<double> doubles{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const std::vector<std::uint16_t> words{0, 1, 2, 3, 65535, 0x1234}, halves(6, 0x3800);
  const std::vector<unsigned char> octets{0, 1, 2, 3, 255, 5};
  for (const int tile : {0, 16})
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
      TiffSample sample;
      sample.tile = tile;
      sample.compression = compression;
      writeTiff(tiff_, sample, floats.data());
      EXPECT_EQ(readDepthFile(tiff_)(2, 1), double(0.6f));
      EXPECT_EQ(readDepthFile(tiff_)(1, 0), double(0.2f));
      if (compression != COMPRESSION_NONE) {
        sample.predictor = 3;
        writeTiff(tiff_, sample, floats.data());
        EXPECT_EQ(readDepthFile(tiff_)(2, 1), double(0.6f));
        sample.predictor = 1;
      }
      sample.bits = 64;
      writeTiff(tiff_, sample, doubles.data());
      EXPECT_EQ(readDepthFile(tiff_)(0, 1), 0.4);
      sample.bits = 16;
      writeTiff(tiff_, sample, halves.data());
      EXPECT_EQ(readDepthFile(tiff_)(2, 0), 0.5);
      sample.kind = SAMPLEFORMAT_UINT;
      writeTiff(tiff_, sample, words.data());
      EXPECT_EQ(readDepthFile(tiff_)(1, 1), 1.0);
      EXPECT_EQ(readDepthFile(tiff_)(2, 1), 0x1234 / 65535.0);
      sample.bits = 8;
      writeTiff(tiff_, sample, octets.data());
      EXPECT_EQ(readDepthFile(tiff_)(2, 1), 5 / 255.0);
    }
}

TEST_F(PictureRasters, ReadTiffTilesThatReachBeyondTheMap) {
  TiffSample sample;
  sample.width = 37;
  sample.height = 21;
  sample.tile = 16;
  std::vector<float> values(37 * 21);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) / 777.0f;
  writeTiff(tiff_, sample, values.data());
  const DepthMap map = readDepthFile(tiff_);
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 37; ++x)
      ASSERT_EQ(map(x, y), double(values[std::size_t(y) * 37 + std::size_t(x)])) << x << "," << y;
}

TEST_F(PictureRasters, SayThatOnePictureOfSeveralIsRead) {
  const std::vector<float> values{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f};
  TiffSample sample;
  writeTiff(tiff_, sample, values.data());
  EXPECT_TRUE(readDepth(tiff_, {}).notes.empty());
  sample.pictures = 2;
  writeTiff(tiff_, sample, values.data());
  const DepthFile file = readDepth(tiff_, {});
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("several pictures"), std::string::npos);
}

TEST_F(PictureRasters, RefuseTiffThatIsNoDepthMap) {
  const std::vector<float> values(24, 0.5f);
  const auto refused = [&](const TiffSample& sample) {
    writeTiff(tiff_, sample, values.data());
    return refusal(tiff_);
  };
  TiffSample colours, white, turned, whole;
  colours.samples = 3;
  colours.photometric = PHOTOMETRIC_RGB;
  EXPECT_NE(refused(colours).find("colour picture"), std::string::npos);
  white.photometric = PHOTOMETRIC_MINISWHITE;
  EXPECT_NE(refused(white).find("from white"), std::string::npos);
  turned.orientation = ORIENTATION_BOTLEFT;
  EXPECT_NE(refused(turned).find("upper left"), std::string::npos);
  whole.kind = SAMPLEFORMAT_INT;
  EXPECT_NE(refused(whole).find("32 bits that are not read"), std::string::npos);
  writeBytes(tiff_, "letter");
  EXPECT_NE(refusal(tiff_).find("as TIFF"), std::string::npos);
  EXPECT_NE(refusal(folder_ / "absent.tif").find("absent.tif"), std::string::npos);
}

}  // namespace
}  // namespace umbra
