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

// The same parts as against percentage-closer filtering, and the map's own error beside them.
TEST(RayTraced, TheErrorIsTakenApartWithTheMapsOwn) {
  const Json plain = run(comparePcf("128", {"--decompose"})).json();
  const Json report = run(comparePcf("128", {"--decompose", "--reference", "raytraced"})).json();
  ASSERT_EQ(report["samples"], plain["samples"]);
  const double map = report["techniques"][0]["decomposition"]["map"];
  EXPECT_NE(map, 0.0);
  for (int i = 0; i < 2; ++i) {
    const Json &row = report["techniques"][i], &found = row["decomposition"];
    EXPECT_EQ(found["map"], map) << "it is the map's, whatever the technique";
    double sum = 0.0;
    for (const auto& [name, value] : found.items()) {
      if (name == "error") continue;
      sum += value.get<double>();
      if (name == "map") continue;
      EXPECT_EQ(value, plain["techniques"][i]["decomposition"][name]) << name;
    }
    // Means of 20 000 doubles of magnitude up to 1, added in two orders.
    EXPECT_NEAR(sum, found["error"], 1e-12);
    EXPECT_NEAR(found["error"], row["bleeding"].get<double>() - row["darkening"].get<double>(),
                1e-12);
    EXPECT_FALSE(plain["techniques"][i]["decomposition"].contains("map"));
  }
  const Outcome text =
      run({"compare", "--scene", "tree-bench", "--technique", "vsm", "--size", "64x48",
           "--map-size", "64", "--decompose", "--reference", "raytraced"});
  EXPECT_NE(text.out.find("MAP"), std::string::npos) << text.out;
}

// Exact percentage-closer filtering has no error against itself, and the map's against rays.
TEST(RayTraced, SurfacesAreComparedWithIt) {
  const Json plain = run(comparePcf("128", {"--surfaces", "vtp"})).json();
  const Json report =
      run(comparePcf("128", {"--surfaces", "vtp", "--reference", "raytraced"})).json();
  const Json &pcf = plain["techniques"][0]["surfaces"],
             &traced = report["techniques"][0]["surfaces"];
  EXPECT_EQ(pcf["meanBleeding"], 0.0);
  EXPECT_GT(traced["meanBleeding"], 0.0);
  EXPECT_EQ(pcf["area"], traced["area"]);
  EXPECT_NE(pcf["shadowedArea"], traced["shadowedArea"]);
  // Both see the same shadows, but for edges within a texel.
  EXPECT_NEAR(pcf["shadowedArea"].get<double>(), traced["shadowedArea"].get<double>(),
              0.2 * pcf["shadowedArea"].get<double>());
}

TEST(RayTraced, RefusesWhatHasNoRays) {
  const TemporaryFolder folder;
  const std::string map = folder.file("map.exr");
  writeMap(map, smallMap());
  const Outcome depth =
      run({"compare", "--json", "--depth", map, "--receiver", "0.5", "--reference", "raytraced"});
  EXPECT_EQ(depth.status, 2);
  EXPECT_NE(depth.err.find("--reference"), std::string::npos) << depth.err;
  const Outcome word = run(comparePcf("128", {"--reference", "rays"}));
  EXPECT_EQ(word.status, 2);
  EXPECT_NE(word.err.find("raytraced"), std::string::npos) << word.err;
}

}  // namespace
}  // namespace umbra::cli
