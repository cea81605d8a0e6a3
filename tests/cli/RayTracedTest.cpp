// --reference raytraced: the reference that no shadow map limits.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

Arguments comparePcf(const std::string& size, const Arguments& more = {}) {
  Arguments arguments{"compare", "--json", "--scene", "tree-bench", "--technique",
                      "pcf,vsm", "--size", "160x120", "--map-size", size};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(RayTraced, PercentageCloserFilteringComesToItAsTheMapGrows) {
  double last = 1.0;
  for (const char* size : {"128", "512", "2048"}) {
    const Json report = run(comparePcf(size, {"--reference", "raytraced"})).json();
    EXPECT_EQ(report["reference"], "raytraced");
    const double error = report["techniques"][0]["mae"];
    // The error is the map's alone, at the edges of the regions: it is proportional to a texel.
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, last) << size;
    last = error;
    EXPECT_EQ(report["samples"], run(comparePcf(size)).json()["samples"]);
  }
}

TEST(RayTraced, ProbeTellsTheFiltersErrorFromTheMaps) {
  const Arguments arguments{"probe", "--json", "--scene", "three-planes", "--pixel",
                            "worst", "--size", "160x120", "--technique",  "vsm,pcf"};
  const Json plain = run(arguments).json();
  EXPECT_EQ(plain["errorAgainst"], "pcf");
  Arguments traced = arguments;
  traced.insert(traced.end(), {"--reference", "raytraced"});
  const Json against = run(traced).json();
  EXPECT_EQ(against["errorAgainst"], "raytraced");
  EXPECT_EQ(against["raytraced"], plain["raytraced"]);
  EXPECT_EQ(against["reference"], plain["reference"]);
  for (int i = 0; i < 2; ++i) {
    const Json& row = against["techniques"][i];
    EXPECT_EQ(row["visibility"], plain["techniques"][i]["visibility"]);
    EXPECT_DOUBLE_EQ(row["error"],
                     row["visibility"].get<double>() - against["raytraced"].get<double>());
  }
}

TEST(RayTraced, RefusesWhatHasNoRays) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.exr");
  writeMap(map, smallMap());
  const Outcome depth =
      run({"compare", "--json", "--depth", map, "--receiver", "0.5", "--reference", "raytraced"});
  EXPECT_EQ(depth.status, 2);
  EXPECT_NE(depth.err.find("--reference"), std::string::npos) << depth.err;
  const Outcome parts = run(comparePcf("128", {"--reference", "raytraced", "--decompose"}));
  EXPECT_EQ(parts.status, 2);
  EXPECT_NE(parts.err.find("--decompose"), std::string::npos) << parts.err;
  const Outcome word = run(comparePcf("128", {"--reference", "rays"}));
  EXPECT_EQ(word.status, 2);
  EXPECT_NE(word.err.find("raytraced"), std::string::npos) << word.err;
}

}  // namespace
}  // namespace umbra::cli
