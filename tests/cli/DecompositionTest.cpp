// compare --decompose: where the error of a frame comes from.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "datasets/maps/DepthFile.h"
#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

const char* const parts[] = {"bleeding",  "contactLeak", "overDarkening",
                             "reduction", "precision",   "small"};

Json decompose(const std::string& techniques, const Arguments& more = {}) {
  Arguments arguments{"compare",      "--json",      "--decompose", "--scene",
                      "three-planes", "--technique", techniques,    "--size",
                      "160x120",      "--map-size",  "256"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments).json()["techniques"];
}

TEST(Decomposition, PartsAddUpToTheMeanError) {
  for (const Json& row : decompose("vsm,esm,csm,power-cdf,pcf")) {
    const Json& found = row["decomposition"];
    double sum = 0.0;
    for (const char* part : parts) {
      ASSERT_TRUE(found.contains(part)) << part;
      sum += found[part].get<double>();
    }
    // The means are of 20 000 doubles of magnitude up to 1, added in two orders.
    EXPECT_NEAR(sum, found["error"], 1e-12) << row["name"];
    EXPECT_NEAR(found["error"], row["bleeding"].get<double>() - row["darkening"].get<double>(),
                1e-12)
        << row["name"];
    EXPECT_EQ(found["reduction"], 0.0);
    EXPECT_GE(found["bleeding"], 0.0);
    EXPECT_GE(found["contactLeak"], 0.0);
    EXPECT_LE(found["overDarkening"], 0.0);
  }
}

// Lauritzen 2008, fig. 3.4: the bleeding comes from A, far above B and C.
TEST(Decomposition, OccludersFarApartBleed) {
  const Json rows = decompose("vsm,pcf");
  const Json &vsm = rows[0]["decomposition"], &pcf = rows[1]["decomposition"];
  EXPECT_GT(vsm["bleeding"], 0.005);
  EXPECT_GT(vsm["bleeding"], 0.9 * vsm["error"].get<double>());
  EXPECT_EQ(pcf["bleeding"], 0.0);
  EXPECT_EQ(pcf["overDarkening"], 0.0);
}

TEST(Decomposition, ReductionAndPrecisionAreToldApart) {
  const Json reduced = decompose("vsm", {"--set", "vsm.bleed-reduction=0.3"})[0]["decomposition"];
  EXPECT_LT(reduced["reduction"], -0.005);
  EXPECT_GT(reduced["bleeding"], 0.005);  // otherwise there is nothing to reduce
  const auto precision = [](const char* format) {
    return std::abs(
        decompose("vsm", {"--format", format})[0]["decomposition"]["precision"].get<double>());
  };
  EXPECT_GT(precision("unorm8"), 10.0 * precision("float"));
}

TEST(Decomposition, OtherReadsAreTakenApartAsWell) {
  for (const Arguments& more : {Arguments{"--filter", "trilinear"}, Arguments{"--cascades", "3"}}) {
    const Json row = decompose("vsm", more)[0];
    const Json& found = row["decomposition"];
    EXPECT_NEAR(found["error"], row["bleeding"].get<double>() - row["darkening"].get<double>(),
                1e-12);
    // Floats store these depths well: a read that is not the frame's own would show here.
    EXPECT_LT(std::abs(found["precision"].get<double>()), 0.01 * found["bleeding"].get<double>())
        << more[0];
  }
}

TEST(Decomposition, MapsAreWrittenWhoseMeansAreTheNumbers) {
  const TemporaryFolder folder;
  const std::string out = folder.file("out");
  const Outcome outcome = run({"compare", "--scene", "three-planes", "--technique", "vsm,pcf",
                               "--set", "vsm.bleed-reduction=0.2", "--size", "160x120",
                               "--map-size", "256", "--decompose", "-o", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(out + "/decomposition-pcf.exr"));
  const std::string file = out + "/decomposition-vsm.exr";
  const Json row = Json::parse(contentOf(out + "/compare.json"))["techniques"][0];
  const DepthMap receives = readDepthFile(file, "receives");
  ASSERT_EQ(receives.width(), 160);
  ASSERT_EQ(receives.height(), 120);
  double pixels = 0.0;
  for (double one : receives.values()) {
    EXPECT_TRUE(one == 0.0 || one == 1.0);
    pixels += one;
  }
  for (const char* part : parts) {
    const DepthMap values = readDepthFile(file, part, -1.0, 1.0);  // from [−1, 1] to [0, 1]
    double sum = 0.0;
    for (std::size_t i = 0; i < values.values().size(); ++i) {
      const double value = 2.0 * values.values()[i] - 1.0;
      EXPECT_TRUE(receives.values()[i] == 1.0 || value == 0.0);
      sum += value;
    }
    // Each value of at most 1 was rounded to a float once, by half of 2^−24 at most.
    EXPECT_NEAR(sum / pixels, row["decomposition"][part].get<double>(), std::ldexp(1.0, -25))
        << part;
  }
  const std::string other = folder.file("other");
  const Outcome plain = run({"compare", "--scene", "three-planes", "--technique", "vsm", "--size",
                             "64x48", "--map-size", "64", "-o", other});
  ASSERT_EQ(plain.status, 0) << plain.err;
  EXPECT_TRUE(std::filesystem::exists(other + "/compare.json"));
  EXPECT_FALSE(std::filesystem::exists(other + "/decomposition-vsm.exr")) << "nobody asked for it";
}

TEST(Decomposition, IsOfScenesOnlyAndOnlyWhenAskedFor) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  const Outcome map = run({"compare", "--depth", folder.file("m.exr"), "--receiver", "0.5",
                           "--technique", "vsm", "--decompose"});
  EXPECT_EQ(map.status, 2);
  EXPECT_NE(map.err.find("--decompose"), std::string::npos) << map.err;
  const Json plain = run({"compare", "--json", "--scene", "two-planes", "--technique", "vsm",
                          "--size", "64x48", "--map-size", "64"})
                         .json();
  EXPECT_FALSE(plain["techniques"][0].contains("decomposition"));
  const Outcome text = run({"compare", "--scene", "two-planes", "--technique", "vsm", "--size",
                            "64x48", "--map-size", "64", "--decompose"});
  EXPECT_NE(text.out.find("CONTACT LEAK"), std::string::npos) << text.out;
}

}  // namespace
}  // namespace umbra::cli
