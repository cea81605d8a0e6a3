// How values of files from anywhere become linear depths: projections are undone, bounds count as
// the file holds them, texels that saw nothing are told apart, and texels keep the file's count.
#include <gtest/gtest.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "datasets/maps/DepthFile.h"
#include "datasets/maps/DepthFileSamples.h"
#include "datasets/maps/ExrFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr double inf = std::numeric_limits<double>::infinity();

class DepthImports : public testing::Test {
 protected:
  fs::path put(const std::vector<float>& values, int width) const {
    Image<float> image(width, int(values.size()) / width);
    std::copy(values.begin(), values.end(), image.values().begin());
    writeExr(folder_ / "m.exr", {{"Z", image}}, {});
    return folder_ / "m.exr";
  }
  fs::path write(const std::string& name, const std::string& bytes) const {
    writeBytes(folder_ / name, bytes);
    return folder_ / name;
  }
  std::string refusal(const fs::path& file, const DepthImport& import) const {
    try {
      readDepth(file, import);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      return error.what();
    }
    return "no error";
  }

  const TemporaryFolder folder_;
};

DepthImport projected(const std::string& text) {
  DepthImport import;
  import.projection = projectionFrom(text, "test");
  return import;
}

DepthImport missing(const std::string& text, double atZero = 0.0, double atOne = 1.0) {
  DepthImport import;
  import.atZero = atZero;
  import.atOne = atOne;
  import.miss = depthMissFrom(text, "test");
  return import;
}

// The window depths of distances 1, 2, 4, 6 behind a near plane at ½ and a far plane at 8 are
// 0.53333, 0.8, 0.93333, 0.97778, by the definition of a perspective projection.
TEST(DepthProjectionTest, HasTheWindowDepthsOfAPerspective) {
  const DepthProjection perspective = projectionFrom("perspective:0.5,8", "test");
  const std::pair<double, double> known[] = {{1.0, 0.53333}, {2.0, 0.8}, {4.0, 0.93333},
                                             {6.0, 0.97778}, {0.5, 0.0}, {8.0, 1.0}};
  for (const auto& [distance, window] : known) {
    EXPECT_NEAR(perspective.window(distance), window, 5e-6);
    // A reversed one is its mirror image.
    EXPECT_NEAR(projectionFrom("reversed:0.5,8", "test").window(distance), 1.0 - window, 5e-6);
  }
}

TEST(DepthProjectionTest, IsUndoneByItsInverse) {
  for (const char* text : {"perspective:0.5,8", "reversed:0.5,8", "infinite:0.5",
                           "reversed-infinite:0.5", "reversed-infinite:0.5:8"}) {
    const DepthProjection projection = projectionFrom(text, "test");
    EXPECT_EQ(toText(projection), text);
    for (double distance : {0.5, 0.75, 1.0, 2.0, 7.9})
      EXPECT_NEAR(projection.distance(projection.window(distance)), distance, 1e-12) << text;
  }
  EXPECT_EQ(projectionFrom("infinite:0.5", "test").distance(1.0), inf);
  EXPECT_EQ(projectionFrom("reversed-infinite:0.5", "test").distance(0.0), inf);
}

TEST(DepthProjectionTest, RefusesWhatIsNoProjection) {
  for (const char* text : {"", "oblique", "linear:1,2", "perspective", "perspective:8", "infinite",
                           "perspective:8,0.5", "perspective:0,8", "perspective:a,8",
                           "infinite:0.5,8", "infinite:8:0.5", "perspective:1,2:euclid",
                           "perspective:1,2:euclid,180", "linear:euclid,60"})
    EXPECT_THROW(projectionFrom(text, "test"), Error) << text;
}

TEST_F(DepthImports, UndoesEveryProjectionToTheSameLinearDepths) {
  const std::vector<double> distances{0.5, 1.0, 2.0, 4.0, 6.0, 8.0};
  for (const char* text : {"perspective:0.5,8", "reversed:0.5,8", "infinite:0.5:8",
                           "reversed-infinite:0.5:8", "infinite:0.5", "reversed-infinite:0.5"}) {
    const DepthImport import = projected(text);
    std::vector<float> values;
    for (double distance : distances) values.push_back(float(import.projection.window(distance)));
    const DepthFile file = readDepth(put(values, 3), import);
    // Floats near 1 have steps of 6e-8, which a perspective stretches by 8²/(0.5·7.5).
    for (std::size_t i = 0; i < distances.size(); ++i)
      EXPECT_NEAR(file.map(int(i % 3), int(i / 3)), (distances[i] - 0.5) / 7.5, 2e-6) << text;
    EXPECT_NEAR(file.scale.far(), 8.0, 1e-5) << text;
    // The three measures of one depth.
    const int x = 1, y = 1;
    const double linear = (6.0 - 0.5) / 7.5, window = import.projection.window(6.0);
    EXPECT_NEAR(linearOf(*givenDepthFrom("6w"), file.scale, x, y), linear, 1e-6) << text;
    EXPECT_NEAR(file.scale.linearOfFile(window, x, y), linear, 1e-6) << text;
    EXPECT_NEAR(file.scale.fileOf(linear, x, y), window, 1e-6) << text;
  }
}

TEST_F(DepthImports, MeasuresTheDistanceToTheLightWhereAskedTo) {
  // A wall at distance 4 before a light that sees 90° of it: to its corners it is √3 times as far.
  const double window = projectionFrom("perspective:0.5,8", "test").window(4.0);
  const int side = 64;
  const DepthFile file = readDepth(put(std::vector<float>(side * side, float(window)), side),
                                   projected("perspective:0.5,8:euclid,90"));
  const double edge = 1.0 - 1.0 / side;  // of the middle of the outermost texel
  EXPECT_NEAR(file.scale.worldOf(file.map(0, 0)), 4.0 * std::hypot(1.0, edge, edge), 1e-5);
  EXPECT_NEAR(file.scale.worldOf(file.map(32, 32)), 4.0 * std::hypot(1.0, 1.0 / side, 1.0 / side),
              1e-5);
  EXPECT_NEAR(file.scale.fileOf(file.map(0, 0), 0, 0), window, 1e-6);
}

TEST_F(DepthImports, TakesABoundAsTheFileHoldsIt) {
  DepthImport import;
  import.atZero = 0.7;
  import.atOne = 5.0;
  const DepthFile file = readDepth(put({0.7f, 2.85f, 5.0f, 1.0f}, 2), import);
  EXPECT_EQ(file.map(0, 0), 0.0);
  EXPECT_EQ(file.map(0, 1), 1.0);
  EXPECT_NE(refusal(put({0.6999999f, 1.0f}, 2), import).find("texel 0,0"), std::string::npos);
  // Floats nearest to 0.7 and to 0.1 lie on either side of these numbers.
  for (const auto& [low, high] : {std::pair(0.1, 5.0), {0.0, 0.7}, {0.7, 5.1}, {0.1, 0.7}}) {
    const DepthMap ends =
        readDepth(put({float(low), float(high)}, 2), missing("error", low, high)).map;
    EXPECT_EQ(ends(0, 0), 0.0) << low;
    EXPECT_EQ(ends(1, 0), 1.0) << high;
  }
  EXPECT_NE(refusal(put({1.0f}, 1), missing("error", 1.0, 1.0 + 1e-9)).find("both ends"),
            std::string::npos);
  // The value that saw nothing is the bound as the file holds it.
  DepthImport infinite = projected("infinite:0.5");
  infinite.atOne = 0.7;
  EXPECT_LT(readDepth(put({0.35f, 0.7f}, 2), infinite).scale.far(), 1.1);
  // Reversed: the larger value is the nearer one.
  std::swap(import.atZero, import.atOne);
  EXPECT_EQ(readDepth(put({0.7f, 5.0f}, 2), import).map(0, 0), 1.0);
}

TEST_F(DepthImports, ListsTheTexelsThatAreNoDepths) {
  std::vector<float> values(40, 0.5f);
  for (std::size_t i = 10; i < 22; ++i) values[i] = i % 2 ? float(inf) : 1e10f;
  const std::string message = refusal(put(values, 8), {});
  EXPECT_NE(message.find("12 texels from 0,1 to 7,2 hold no depth: texel 2,1 is 1e+10, 3,1 is inf"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find(", …;"), std::string::npos) << message;
  EXPECT_NE(message.find("--depth-miss clamp"), std::string::npos) << message;
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0);
}

TEST_F(DepthImports, DoesWithMissingDepthsWhatItIsTold) {
  const float nan = std::nanf("");
  const auto read = [&](const DepthImport& import) {
    return readDepth(put({float(inf), nan, 1e10f, -1.0f, 0.25f, 1.0f}, 6), import);
  };
  const DepthFile clamped = read(missing("clamp"));
  for (int x : {0, 1, 2, 5}) EXPECT_EQ(clamped.map(x, 0), 1.0) << x;
  EXPECT_EQ(clamped.map(3, 0), 0.0);
  EXPECT_EQ(clamped.map(4, 0), 0.25);
  EXPECT_EQ(clamped.notes,
            std::vector<std::string>{"4 texels held no depth and became the nearest bound"});
  // Infinity lies beyond the near bound where the map is reversed.
  EXPECT_EQ(readDepth(put({float(inf), 0.25f}, 2), missing("clamp", 1.0, 0.0)).map(0, 0), 0.0);
  // A value of the range stands in for all.
  const DepthFile stood = read(missing("0.75"));
  for (int x : {0, 1, 2, 3}) EXPECT_EQ(stood.map(x, 0), 0.75) << x;
  EXPECT_EQ(stood.map(4, 0), 0.25);
  // One that is no depth is a mark, and marks nothing else.
  for (const auto& [text, value] :
       {std::pair("1e10", 1e10f), {"inf", float(inf)}, {"nan", nan}, {"-1", -1.0f}, {"0", 0.0f}}) {
    const DepthFile marked = readDepth(put({value, 0.25f}, 2), missing(text));
    EXPECT_EQ(marked.map(0, 0), 1.0) << text;
    EXPECT_EQ(marked.map(1, 0), 0.25) << text;
    EXPECT_EQ(marked.notes.size(), 1u) << text;
    EXPECT_NE(refusal(put({value, 2.0f}, 2), missing(text)).find("texel 1,0 is 2"),
              std::string::npos)
        << text;
  }
  EXPECT_THROW(depthMissFrom("never", "test"), Error);
}

TEST_F(DepthImports, CountsTexelsAsTheFileDoes) {
  const Imath::Box2i window({10, -4}, {13, -1});
  Imf::Header header(window, window);
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  std::vector<float> values(16, 0.5f);
  values[5] = 2.0f;
  {
    Imf::OutputFile file((folder_ / "crop.exr").c_str(), header);
    Imf::FrameBuffer frame;
    frame.insert("Z", Imf::Slice::Make(Imf::FLOAT, values.data(), window));
    file.setFrameBuffer(frame);
    file.writePixels(4);
  }
  EXPECT_NE(refusal(folder_ / "crop.exr", {}).find("texel 11,-3 is 2"), std::string::npos);
  const DepthFile file = readDepth(folder_ / "crop.exr", missing("clamp"));
  EXPECT_EQ(file.originX, 10);
  EXPECT_EQ(file.originY, -4);
}

TEST_F(DepthImports, ReadsPortableFloatMapsFromTheBottomUp) {
  for (const bool bigEnd : {false, true}) {
    const std::string head = std::string("Pf\n3 2\n") + (bigEnd ? "1.0\n" : "-1.0\n");
    const DepthMap map = readDepthFile(
        write("m.pfm", head + floatBytes({0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}, bigEnd)));
    EXPECT_EQ(map.width(), 3);
    EXPECT_EQ(map(0, 0), double(0.4f));
    EXPECT_EQ(map(2, 1), double(0.3f));
    EXPECT_NE(refusal(write("cut.pfm", head + "12345"), {}).find("truncated"), std::string::npos);
  }
  EXPECT_NE(refusal(write("c.pfm", "PF\n1 1\n-1\n"), {}).find("colour"), std::string::npos);
  EXPECT_NE(refusal(write("c.pfm", "Pf\n0 1\n-1\n"), {}).find("width"), std::string::npos);
  EXPECT_NE(refusal(write("c.pfm", "Pf\n1 1\n0\n1234"), {}).find("scale"), std::string::npos);
  EXPECT_NE(refusal(write("c.pfm", "letter"), {}).find("'Pf'"), std::string::npos);
}

TEST_F(DepthImports, ReadsNumPyArrays) {
  const std::vector<float> rows{0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f};
  const DepthMap map =
      readDepthFile(write("m.npy", npy("<f4", "False", "(2, 3)", floatBytes(rows))));
  EXPECT_EQ(map.width(), 3);
  EXPECT_EQ(map(2, 1), double(0.6f));
  EXPECT_EQ(map(0, 1), double(0.4f));
  const DepthMap turned =
      readDepthFile(write("m.npy", npy(">f4", "True", "(2, 3)", floatBytes(rows, true))));
  EXPECT_EQ(turned(0, 1), double(0.2f));
  EXPECT_EQ(turned(2, 0), double(0.5f));
  const DepthMap bytes = readDepthFile(
      write("m.npy", npy("|u1", "False", "(1, 2)", std::string("\x00\xff", 2))), "", 0.0, 255.0);
  EXPECT_EQ(bytes(1, 0), 1.0);
  const std::pair<std::string, std::string> wrong[] = {
      {npy("<f4", "False", "(2, 3)", "1234"), "truncated"},
      {npy("<c8", "False", "(2, 3)", ""), "of the type"},
      {npy("<f4", "False", "(2, 3, 4)", ""), "shape"},
      {npy("<f4", "False", "(99999999999, 3)", ""), "shape"},
      {"\x93NUMPY", "is no NumPy array"},
      {"letter", "is no NumPy array"}};
  for (const auto& [content, reason] : wrong)
    EXPECT_NE(refusal(write("m.npy", content), {}).find(reason), std::string::npos) << reason;
}

}  // namespace
}  // namespace umbra
