// Pictures as they were when they were right. Drawn by Mesa's llvmpipe at 256²; remake one with
// `umbrascope render` and the arguments below after looking at it.
//
// Compared as floats in [0,1]: another processor's rounding may move an edge by a sample, which
// changes single pixels much, and shading a little. So at most 1 % of the pixels may differ by more
// than 0.1, and all of them by 0.01 on average.
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <cmath>

#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

struct Baseline {
  std::string name;
  Arguments arguments;
};

class Picture : public testing::TestWithParam<Baseline> {};

TEST_P(Picture, LooksAsItDid) {
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  Arguments arguments{"render", "--size", "256x256", "-o", file};
  arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  const Outcome outcome = run(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string baseline = UMBRASCOPE_BASELINES "/" + GetParam().name + ".png";
  const QImage wanted =
      QImage(QString::fromStdString(baseline)).convertToFormat(QImage::Format_RGB888);
  const QImage drawn = QImage(QString::fromStdString(file)).convertToFormat(QImage::Format_RGB888);
  ASSERT_FALSE(wanted.isNull()) << baseline;
  ASSERT_EQ(wanted.size(), drawn.size());
  double sum = 0.0;
  int different = 0;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      double largest = 0.0;
      for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(wanted.constScanLine(y)[3 * x + c] -
                                             drawn.constScanLine(y)[3 * x + c]) /
                                        255.0);
      sum += largest;
      different += largest > 0.1;
    }
  EXPECT_LE(sum / (256 * 256), 0.01);
  EXPECT_LE(different, 256 * 256 / 100);
}

INSTANTIATE_TEST_SUITE_P(
    Baselines, Picture,
    testing::Values(Baseline{"tree-bench-vsm", {"--scene", "tree-bench", "--technique", "vsm"}},
                    Baseline{"tree-bench-pcf", {"--scene", "tree-bench", "--technique", "pcf"}},
                    Baseline{"three-planes-vsm-error",
                             {"--scene", "three-planes", "--technique", "vsm", "--view", "error"}},
                    Baseline{"three-planes-power-cdf",
                             {"--scene", "three-planes", "--technique", "power-cdf", "--view",
                              "visibility"}},
                    Baseline{"two-planes-esm", {"--scene", "two-planes", "--technique", "esm"}}),
    [](const auto& picture) {
      std::string name = picture.param.name;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

}  // namespace
}  // namespace umbra::cli
