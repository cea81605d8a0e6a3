#include "analysis/probe/ProbeSheet.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(ProbeSheet, ALineForEachProbeWithEveryDigit) {
  const SheetRow bench{
      "Bench", {1.5, -2, 0.1}, SheetFigures{0.75, 0.25, {{"vsm", 1.0 / 3, 0.5}}}, ""};
  const SheetRow texel{"a, \"b\"", {3, 7}, {}, "outside the depth map"};
  const std::vector<std::string> techniques{"vsm", "pcf"};
  EXPECT_EQ(sheetText(std::vector{bench, texel}, techniques, ','),
            "name,x,y,z,receiver,truth,vsm,vsm error,pcf,pcf error,note\n"
            "Bench,1.5,-2,0.1,0.75,0.25,0.3333333333333333,0.5,,,\n"
            "\"a, \"\"b\"\"\",3,7,,,,,,,,outside the depth map\n");
  EXPECT_EQ(sheetText(std::vector{texel}, {}, '\t'),
            "name\tx\ty\tz\treceiver\ttruth\tnote\n"
            "\"a, \"\"b\"\"\"\t3\t7\t\t\t\toutside the depth map\n");
}

}  // namespace
}  // namespace umbra
