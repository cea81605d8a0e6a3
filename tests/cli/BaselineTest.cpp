// Pictures as they were when they were right. Drawn by Mesa's llvmpipe at 256²; remake one with
// `umbrascope render --size 256x256` and the options below after looking at it.
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

// Of two pictures, by the largest difference of a pixel's channels in [0,1]: its mean, and the
// share of pixels where it is above 0.1.
//
// Another processor rounds otherwise, which moves edges: as much as it does to move light and
// camera by one unit in the last place of a float. That changed these frames by 3e-6 at most, and
// no pixel by more than 0.1. A path of some thirty roundings, from vertex to channel and back,
// gives 1e-4; a pixel that an edge crosses changes by up to 1, and about 1e-3 of them could change
// by that 0.1. The planes are lit a little aslant for it: overhead, their sides lie along the
// light's rays, and a last bit decides whether 1 % of the picture faces the light.
constexpr double largestMean = 1e-4, largestShare = 1e-3;

// By option, each with its value.
using Frame = std::map<std::string, std::string>;

struct Baseline {
  std::string name;
  Frame frame;
  std::string otherTechnique;  // that draws another picture
  Frame nudged;                // light and camera, each number one float further
};

struct Difference {
  double mean = 0.0, share = 0.0;

  bool within(double times) const {
    return mean <= times * largestMean && share <= times * largestShare;
  }
  bool beyond(double times) const { return mean > times * largestMean; }
};

std::ostream& operator<<(std::ostream& stream, const Difference& difference) {
  return stream << "mean " << difference.mean << ", share " << difference.share;
}

Difference differenceOf(const QImage& a, const QImage& b) {
  Difference difference;
  const double pixels = double(a.width()) * a.height();
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      int largest = 0;
      for (int c = 0; c < 3; ++c)
        largest = std::max(largest,
                           std::abs(a.constScanLine(y)[3 * x + c] - b.constScanLine(y)[3 * x + c]));
      difference.mean += largest / 255.0 / pixels;
      difference.share += (largest > 0.1 * 255.0) / pixels;
    }
  return difference;
}

QImage readPicture(const std::string& file) {
  return QImage(QString::fromStdString(file)).convertToFormat(QImage::Format_RGB888);
}

QImage drawn(const Frame& frame) {
  const TemporaryFolder folder;
  Arguments arguments{"render", "--size", "256x256", "-o", folder.file("picture.png")};
  for (const auto& [option, value] : frame) {
    arguments.push_back(option);
    arguments.push_back(value);
  }
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return readPicture(folder.file("picture.png"));
}

class Picture : public testing::TestWithParam<Baseline> {
 protected:
  void SetUp() override {
    const std::string file = UMBRASCOPE_BASELINES "/" + GetParam().name + ".png";
    baseline_ = readPicture(file);
    ASSERT_EQ(baseline_.size(), QSize(256, 256)) << file;
  }
  // Of the baseline from what is drawn with these options instead.
  Difference differenceWith(const Frame& options) const {
    Frame frame = options;
    frame.insert(GetParam().frame.begin(), GetParam().frame.end());  // keeps what is there
    const QImage other = drawn(frame);
    if (other.size() != baseline_.size()) throw std::runtime_error("there is no picture");
    return differenceOf(baseline_, other);
  }

  QImage baseline_;
};

TEST_P(Picture, LooksAsItDid) {
  const Difference difference = differenceWith({});
  EXPECT_TRUE(difference.within(1.0)) << difference;
}

// What rounding alone may do stays within the bound.
TEST_P(Picture, HangsOnNoLastBit) {
  const Difference difference = differenceWith(GetParam().nudged);
  EXPECT_TRUE(difference.within(1.0)) << difference;
}

// A comparison that takes one technique or radius for another says nothing.
TEST_P(Picture, IsToldFromOthers) {
  for (const auto& [option, value] : {std::pair<std::string, std::string>{"--radius", "2"},
                                      {"--radius", "4"},
                                      {"--technique", GetParam().otherTechnique}}) {
    const Difference difference = differenceWith({{option, value}});
    EXPECT_TRUE(difference.beyond(10.0)) << option << " " << value << ": " << difference;
  }
}

// The scenes' own light and camera, but for the planes' light.
const Frame nudgedTree{{"--light", "directional:-2.6000002,7.6000005,-4.2000005:-0.1,0.5,0"},
                       {"--camera", "1.7000001,2.3000002,5.2000005:-0.2,1.15,-0.3:36"}};
const std::string aslant = "directional:0.7,9,0.5";
const Frame nudgedPlanes{{"--light", "directional:0.7000001,9.000001,0.5000001"},
                         {"--camera", "-1.5000001,2.5000002,8.400001:0,1.25,0:24.5"}};

Baseline ofTree(const std::string& name, const std::string& technique, const std::string& view,
                const std::string& other = "pcf") {
  return {name,
          {{"--scene", "tree-bench"}, {"--technique", technique}, {"--view", view}},
          other,
          nudgedTree};
}

Baseline ofPlanes(const std::string& name, const std::string& technique) {
  return {name,
          {{"--scene", "three-planes"},
           {"--technique", technique},
           {"--view", "error"},
           {"--light", aslant}},
          "pcf",
          nudgedPlanes};
}

INSTANTIATE_TEST_SUITE_P(Baselines, Picture,
                         testing::Values(ofTree("tree-bench-vsm", "vsm", "shaded"),
                                         ofTree("tree-bench-vsm-visibility", "vsm", "visibility"),
                                         ofTree("tree-bench-pcf-visibility", "pcf", "visibility",
                                                "hard"),
                                         ofTree("tree-bench-esm-error", "esm", "error"),
                                         ofPlanes("three-planes-vsm-error", "vsm"),
                                         ofPlanes("three-planes-power-cdf-error", "power-cdf")),
                         [](const auto& picture) {
                           std::string name = picture.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace umbra::cli
