// `splits` and `compare` on a depth map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

class Maps : public testing::Test {
 protected:
  Maps() { writeMap(file, map); }

  const Image<float> map = smallMap();
  TemporaryFolder folder;
  const std::string file = folder.file("m.exr");
};

using Splits = Maps;
using Compare = Maps;

TEST_F(Splits, LloydNeverRaisesTheCost) {
  const Json object = run({"splits", "--json", "--depth", file, "--layers", "4"}).json();
  EXPECT_EQ(object["format"], "umbrascope-splits/1");
  EXPECT_EQ(object["layers"], 4);
  const std::vector<double> splits = object["splits"], cost = object["cost"];
  EXPECT_EQ(splits.size(), 3u);
  EXPECT_TRUE(std::is_sorted(splits.begin(), splits.end()));
  EXPECT_EQ(cost.size(), object["iterations"].get<std::size_t>());
  EXPECT_TRUE(object["teleports"].is_number_unsigned());
  EXPECT_LT(cost.back(), cost.front());
}

TEST_F(Splits, UniformSplitsCostWhatTheirSamplesSay) {
  const Json object = run({"splits", "--json", "--depth", file, "--layers", "4", "--placement",
                           "uniform", "--bins", "7"})
                          .json();
  EXPECT_EQ(object["splits"], (Json{0.25, 0.5, 0.75}));
  EXPECT_EQ(object["iterations"], 0);
  double sum = 0.0, weights = 0.0;
  for (int y = 0; y + 1 < map.height(); ++y)
    for (int x = 0; x + 1 < map.width(); ++x) {
      const double z[] = {map(x, y), map(x + 1, y), map(x, y + 1), map(x + 1, y + 1)};
      const double mean = (z[0] + z[1] + z[2] + z[3]) / 4;
      double variance = 0.0;
      for (double depth : z) variance += (depth - mean) * (depth - mean) / 4;
      const double value = mean + std::sqrt(variance);
      double nearest = 1.0;
      for (double split : {0.25, 0.5, 0.75}) nearest = std::min(nearest, std::abs(value - split));
      sum += variance * nearest * nearest;
      weights += variance;
    }
  ASSERT_EQ(object["cost"].size(), 1u);
  EXPECT_NEAR(object["cost"][0], sum / weights, 1e-12);
  ASSERT_EQ(object["histogram"]["edges"].size(), 8u);
  double share = 0.0;
  for (double weight : object["histogram"]["weights"]) share += weight;
  EXPECT_NEAR(share, 1.0, 1e-12);
}

TEST_F(Splits, RefusesWhatLvsmCannot) {
  EXPECT_EQ(run({"splits", "--json", "--depth", file, "--layers", "0"}).status, 2);
  EXPECT_EQ(run({"splits", "--json", "--depth", file, "--placement", "random"}).status, 2);
  EXPECT_EQ(run({"splits", "--json", "--depth", file, "--iterations", "0"}).status, 2);
}

TEST_F(Compare, MetricsAreThoseOfEveryTexel) {
  const double receiver = 0.7;
  const Json object = run({"compare", "--json", "--depth", file, "--receiver", "0.7", "--technique",
                           "vsm,pcf", "--radius", "2"})
                          .json();
  double squares = 0, bleeding = 0, darkening = 0, max = -1, min = 1, umbra = 0;
  int inUmbra = 0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      double mean = 0, square = 0, lit = 0;
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
          const double z =
              map(std::clamp(x + i, 0, map.width() - 1), std::clamp(y + j, 0, map.height() - 1));
          mean += z / 25;
          square += z * z / 25;
          lit += z >= receiver;
        }
      const double variance = std::max(square - mean * mean, 1e-6);
      const double d = receiver - mean;
      const double v = d <= 0 ? 1.0 : variance / (variance + d * d);
      const double error = v - lit / 25;
      squares += error * error;
      bleeding += std::max(error, 0.0);
      darkening += std::max(-error, 0.0);
      max = std::max(max, error);
      min = std::min(min, error);
      if (lit == 0) {
        umbra += error;
        ++inUmbra;
      }
    }
  const double n = map.width() * map.height();
  const Json vsm = object["techniques"][0];
  EXPECT_EQ(object["samples"], n);
  EXPECT_NEAR(vsm["rmse"], std::sqrt(squares / n), 1e-9);
  EXPECT_NEAR(vsm["mae"], (bleeding + darkening) / n, 1e-9);
  EXPECT_NEAR(vsm["bleeding"], bleeding / n, 1e-9);
  EXPECT_NEAR(vsm["darkening"], darkening / n, 1e-9);
  EXPECT_NEAR(vsm["max"], max, 1e-9);
  EXPECT_NEAR(vsm["min"], min, 1e-9);
  EXPECT_NEAR(vsm["umbraBleeding"], umbra / inUmbra, 1e-9);
  EXPECT_NEAR(object["techniques"][1]["rmse"], 0.0, 1e-12);
}

}  // namespace
}  // namespace umbra::cli
