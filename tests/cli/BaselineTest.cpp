// Pictures from a time when they were right, drawn by Mesa's llvmpipe at 256². To remake one, look
// at the new picture first, then run `umbrascope render --size 256x256` with the options below.
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "tests/cli/PictureDifference.h"
#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

// Options with their values.
using Frame = std::map<std::string, std::string>;

struct Baseline {
  std::string name;
  Frame frame;
  std::string otherTechnique;  // a technique that draws another picture
  Frame nudged;                // options for light and camera, each number one float further
};

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
  // The difference between the baseline and what is drawn with these options instead.
  Difference differenceWith(const Frame& options) const {
    Frame frame = options;
    frame.insert(GetParam().frame.begin(),
                 GetParam().frame.end());  // does not replace options that are there
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

// Differences by rounding alone stay within the bound.
TEST_P(Picture, HangsOnNoLastBit) {
  const Difference difference = differenceWith(GetParam().nudged);
  EXPECT_TRUE(difference.within(1.0)) << difference;
}

// A comparison that takes one technique or radius for another would prove nothing.
TEST_P(Picture, IsToldFromOthers) {
  for (const auto& [option, value] : {std::pair<std::string, std::string>{"--radius", "2"},
                                      {"--radius", "4"},
                                      {"--technique", GetParam().otherTechnique}}) {
    const Difference difference = differenceWith({{option, value}});
    EXPECT_TRUE(difference.beyond(10.0)) << option << " " << value << ": " << difference;
  }
}

// These are the scenes' own lights and cameras, except the light of the planes.
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
