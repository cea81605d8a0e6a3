// Commands that draw, on EGL without a display.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "datasets/maps/DepthFile.h"
#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

const Arguments small{"--size", "160x120", "--map-size", "256"};

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(SceneProbe, TellsWhatTheGpuSawAndWhatTheRegionSays) {
  const Json object = run(with({"probe", "--json", "--scene", "three-planes", "--pixel", "worst",
                                "--technique", "hard,pcf,vsm,power-cdf"},
                               small))
                          .json();
  EXPECT_EQ(object["source"]["name"], "three-planes");
  EXPECT_EQ(object["source"]["width"], 256);
  EXPECT_EQ(object["region"]["texels"], 64);  // 7×7 taps read bilinearly
  for (const char* field : {"pixel", "uv"}) EXPECT_EQ(object[field].size(), 2u) << field;
  EXPECT_EQ(object["world"].size(), 3u);
  ASSERT_EQ(object["techniques"].size(), 4u);
  for (const Json& row : object["techniques"]) {
    ASSERT_TRUE(row.contains("gpu")) << row;
    EXPECT_GE(row["gpu"], 0.0);
    EXPECT_LE(row["gpu"], 1.0);
    EXPECT_NEAR(row["visibility"].get<double>() - object["reference"].get<double>(), row["error"],
                1e-12);
  }
  // Lauritzen 2008, fig. 3.4: B hides C from the light, but VSM lights C. A spot counts as bleeding
  // from a mean error of 0.05 on, and the pixel is the spot's worst.
  EXPECT_GT(object["techniques"][2]["error"], 0.05);
}

// The region that the command line takes apart is the one that the shaded frame read.
TEST(SceneProbe, EveryReadIsTakenApartAsTheGpuDidIt) {
  for (const char* filter : {"point", "bilinear", "trilinear", "anisotropic", "sat"}) {
    const Json object = run(with({"probe", "--json", "--scene", "two-planes", "--pixel", "worst",
                                  "--filter", filter, "--anisotropy", "4", "--technique", "vsm,pcf",
                                  "--cascades", "3", "--msaa", "4"},
                                 small))
                            .json();
    EXPECT_EQ(object["filter"], filter);
    ASSERT_EQ(object["techniques"].size(), 2u);
    EXPECT_GE(object["cascade"], 0);
    EXPECT_LT(object["cascade"], 3);
    const bool footprint = std::set<std::string>{"trilinear", "anisotropic", "sat"}.count(filter);
    ASSERT_EQ(object.contains("footprint"), footprint) << filter;
    if (footprint) {
      EXPECT_GE(object["footprint"]["probes"], 1);
      EXPECT_LE(object["footprint"]["probes"], std::string(filter) == "anisotropic" ? 4 : 1);
    }
    // Weights of a tap are right to some 2⁻²², in a sum over the region's taps. A tap in front of
    // the receiver for one side and behind it for the other would weigh its whole weight.
    const double taps = object["region"]["texels"];
    for (const Json& row : object["techniques"]) {
      if (row["name"] != "pcf") continue;
      EXPECT_NEAR(row["gpu"].get<double>(), row["visibility"].get<double>(),
                  taps * std::ldexp(1.0, -22))
          << filter;
    }
  }
}

TEST(SceneProbe, ThePixelOfAnEarlierProbeGivesTheSameProbe) {
  const Arguments probe{"probe", "--json", "--scene", "two-planes", "--technique", "vsm"};
  const Json first = run(with(with(probe, {"--pixel", "worst"}), small)).json();
  const std::string pixel = first["pixel"][0].dump() + "," + first["pixel"][1].dump();
  EXPECT_EQ(run(with(with(probe, {"--pixel", pixel}), small)).json(), first);
}

TEST(SceneProbe, TheWorstPixelOfSeveralIsThatOfVsm) {
  const auto worst = [](const std::string& techniques) {
    return run(with({"probe", "--json", "--scene", "three-planes", "--pixel", "worst",
                     "--technique", techniques},
                    small))
        .json()["pixel"];
  };
  const Json ofVsm = worst("vsm"), ofHard = worst("hard");
  EXPECT_NE(ofHard, ofVsm);  // otherwise the rest proves nothing
  EXPECT_EQ(worst("all"), ofVsm);
  EXPECT_EQ(worst("hard,vsm"), ofVsm);
  EXPECT_EQ(worst("hard,esm"), worst("esm"));
}

TEST(SceneProbe, APixelWithoutASurfaceIsAnError) {
  const Arguments probe{"probe", "--json", "--scene", "tree-bench"};
  const Outcome sky = run(with(with(probe, {"--pixel", "2,2"}), small));
  EXPECT_EQ(sky.status, 2);
  EXPECT_NE(sky.err.find("no surface"), std::string::npos) << sky.err;
  const Outcome outside = run(with(with(probe, {"--pixel", "160,5"}), small));
  EXPECT_EQ(outside.status, 2);
  EXPECT_NE(outside.err.find("160x120"), std::string::npos) << outside.err;
}

TEST(SceneCompare, PcfIsTheReferenceAndVsmOnlyBleeds) {
  const Json object =
      run(with({"compare", "--json", "--scene", "three-planes", "--technique", "pcf,vsm"}, small))
          .json();
  EXPECT_EQ(object["format"], "umbrascope-compare/1");
  EXPECT_EQ(object["reference"], "pcf");
  EXPECT_GT(object["samples"], 1000);
  const Json pcf = object["techniques"][0], vsm = object["techniques"][1];
  for (const char* field : {"rmse", "mae", "bleeding", "darkening", "max", "min", "umbraBleeding"})
    EXPECT_TRUE(vsm.contains(field)) << field;
  // Both are sums of 64 float weights, in different orders.
  EXPECT_LT(pcf["max"], 64 * std::ldexp(1.0, -23));
  EXPECT_GT(vsm["bleeding"], 0.001);
  EXPECT_GT(vsm["bleeding"], 100 * vsm["darkening"].get<double>());
}

TEST(SceneCompare, TheSmallestReductionLeavesNoLightInTheUmbra) {
  const auto compare = [](const Arguments& more) {
    return run(with(with({"compare", "--json", "--scene", "three-planes", "--technique", "vsm,pcf"},
                         more),
                    small))
        .json()["techniques"];
  };
  const Json plain = compare({});
  EXPECT_FALSE(plain[1].contains("smallestReduction"));
  const Json found = plain[0]["smallestReduction"];
  EXPECT_GT(plain[0]["umbraBleeding"], 0.01);
  EXPECT_GT(found["amount"], 0.05);
  EXPECT_TRUE(found["removesAll"]);
  const Json reduced = compare({"--set", "vsm.bleed-reduction=" + found["amount"].dump()});
  // The shader computes (p − a)/(1 − a) in 32 bits: a difference of two roundings of 2⁻²⁴,
  // stretched.
  const double rounding = std::ldexp(1.0, -22) / (1.0 - found["amount"].get<double>());
  EXPECT_NEAR(reduced[0]["umbraBleeding"], 0.0, rounding);
  EXPECT_NEAR(reduced[0]["darkening"], found["darkening"], rounding);
  EXPECT_NEAR(-reduced[0]["min"].get<double>(), found["maxDarkening"], rounding);
  // The bound without reduction is measured, whatever reduction is set.
  EXPECT_EQ(reduced[0]["smallestReduction"], found);
}

TEST(SceneCompare, WritesAFolder) {
  const TemporaryFolder folder;
  const Outcome outcome = run(with(
      {"compare", "--scene", "two-planes", "--technique", "vsm,hard", "-o", folder.file("out")},
      small));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"out", "out/compare.csv", "out/compare.json",
                                      "out/error-against-cost.csv", "out/error-against-cost.pdf",
                                      "out/error-against-cost.png", "out/error-against-cost.svg",
                                      "out/error-hard.png", "out/error-vsm.png"}));
  for (const char* name : {"compare.csv", "compare.json", "error-vsm.png"})
    EXPECT_NE(outcome.err.find(folder.file("out/") + name), std::string::npos) << outcome.err;
  EXPECT_TRUE(contentOf(folder.file("out/compare.csv")).starts_with("name,rmse,mae,"));
}

TEST(SceneEncode, StoresTheDepthMapThatTheProbeReads) {
  const TemporaryFolder folder;
  const std::string file = folder.file("c.exr");
  const Outcome outcome = run(with(
      {"encode", "--scene", "two-planes", "--technique", "vsm", "--kernel", "none", "-o", file},
      small));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const DepthMap z = readDepthFile(file), m1 = readDepthFile(file, "vsm.M1"),
                 m2 = readDepthFile(file, "vsm.M2");
  ASSERT_EQ(z.width(), 256);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      EXPECT_EQ(m1(x, y), z(x, y));
      EXPECT_NEAR(m2(x, y), z(x, y) * z(x, y), std::ldexp(1.0, -24));
    }
}

TEST(SceneEncode, NormalisedFormatsStoreEvenSteps) {
  const TemporaryFolder folder;
  const std::string file = folder.file("c.exr");
  const std::pair<const char*, double> formats[] = {{"unorm8", 255.0}, {"unorm16", 65535.0}};
  for (const auto& [format, steps] : formats) {
    const Outcome outcome = run(with(
        {"encode", "--scene", "two-planes", "--technique", "vsm", "--format", format, "-o", file},
        small));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const DepthMap m2 = readDepthFile(file, "vsm.M2");
    std::set<double> seen;
    for (double value : m2.values()) {
      // Read back as a float: a step times the rounded reciprocal of their number, rounded again.
      EXPECT_NEAR(value * steps, std::round(value * steps), steps * std::ldexp(1.0, -23));
      seen.insert(value);
    }
    EXPECT_GT(seen.size(), 2u)
        << format;  // the penumbra is filtered, so that there are more values than two planes have
  }
}

TEST(SceneFormats, AllLeavesOutWhatCannotBeStoredAndSaysWhy) {
  for (const Arguments& command :
       {Arguments{"compare", "--json"}, Arguments{"probe", "--json", "--pixel", "worst"}}) {
    const Outcome outcome = run(with(
        with(command, {"--scene", "three-planes", "--technique", "all", "--format", "unorm16"}),
        small));
    const Json object = outcome.json();
    std::set<std::string> names;
    for (const Json& row : object["techniques"]) names.insert(row["name"]);
    for (const char* id : {"hard", "pcf", "vsm", "lvsm", "msm"}) EXPECT_TRUE(names.count(id)) << id;
    for (const char* id : {"esm", "evsm2", "evsm4"}) {
      EXPECT_FALSE(names.count(id)) << id;
      EXPECT_NE(outcome.err.find(std::string("left out: ") + id + " stores"), std::string::npos)
          << outcome.err;
    }
  }
}

TEST(SceneReads, AllLeavesOutWhatATableOfSumsCannotServeAndSaysWhy) {
  const Outcome outcome = run(with(
      {"compare", "--json", "--scene", "three-planes", "--technique", "all", "--filter", "sat"},
      small));
  std::set<std::string> names;
  const Json object = outcome.json();
  for (const Json& row : object["techniques"]) names.insert(row["name"]);
  for (const char* id : {"hard", "pcf", "vsm", "esm", "msm"}) EXPECT_TRUE(names.count(id)) << id;
  for (const char* id : {"power-cdf", "layered-power-cdf"}) {
    EXPECT_FALSE(names.count(id)) << id;
    EXPECT_NE(outcome.err.find(std::string("which ") + id + " needs"), std::string::npos)
        << outcome.err;
  }
}

// Where a driver has fewer samples a texel than were asked for, the log says so once.
TEST(SceneReads, FewerSamplesThanAskedForAreSaid) {
  const TemporaryFolder folder;
  const Outcome outcome = run(with({"render", "--scene", "two-planes", "--msaa", "8", "--technique",
                                    "hard,vsm", "-o", folder.file("p.png")},
                                   small));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t said = outcome.err.find("--msaa: ");
  if (said == std::string::npos) return;  // the driver has eight
  EXPECT_NE(outcome.err.find("the driver does not offer 8", said), std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("--msaa: ", said + 1), std::string::npos) << outcome.err;
}

TEST(SceneRender, LayersHoldTheErrorOfEachTechnique) {
  const TemporaryFolder folder;
  const std::string file = folder.file("l.exr");
  const Outcome outcome =
      run(with({"render", "--scene", "three-planes", "--technique", "pcf,vsm", "-o", file}, small));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  // Values of [-far, far] come back in [0, 1]; u is far outside the map where the ground is.
  const auto layer = [&](const std::string& name, double far = 2.0) {
    return readDepthFile(file, name, -far, far);
  };
  const DepthMap visibility = layer("vsm.visibility"), reference = layer("reference"),
                 error = layer("vsm.error"), u = layer("u", 1e6);
  ASSERT_EQ(error.width(), 160);
  ASSERT_EQ(error.height(), 120);
  int shaded = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      if (error(x, y) == 0.5) continue;  // no error, or no shadow received
      ++shaded;
      EXPECT_NEAR(error(x, y) - 0.5, visibility(x, y) - reference(x, y), 1e-7);
      EXPECT_GE(u(x, y), 0.5);
    }
  EXPECT_GT(shaded, 100);
}

// Every technique of the picture comes back, not one.
TEST(SceneRender, LayersAreASessionOfAllThatWasDrawn) {
  const TemporaryFolder folder;
  const std::string layers = folder.file("l.exr"), picture = folder.file("p.png"),
                    other = folder.file("q.png");
  const Arguments view{"--scene",    "two-planes", "--size",      "96x64",
                       "--map-size", "64",         "--technique", "pcf,vsm,esm"};
  const auto render = [](Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  };
  render(view, {"-o", layers});
  render(view, {"-o", picture});
  render({"--session", layers}, {"-o", other});
  EXPECT_EQ(contentOf(other), contentOf(picture));
}

TEST(Tour, WritesPicturePlotsAndFigures) {
  const TemporaryFolder folder;
  const Outcome outcome = run(with({"tour", "-o", folder.file("out")}, small));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::set<std::string> expected{"out", "out/picture.png", "out/probe.json"};
  for (const char* plot : {"curves", "histogram", "cdf"})
    for (const char* extension : {".png", ".svg", ".pdf", ".csv"})
      expected.insert(std::string("out/") + plot + extension);
  const std::vector<std::string> names = folder.names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), expected);
  for (const std::string& name : expected) {
    if (name == "out") continue;
    EXPECT_NE(outcome.err.find(folder.file(name)), std::string::npos) << name << "\n"
                                                                      << outcome.err;
    EXPECT_GT(std::filesystem::file_size(folder.file(name)), 200u) << name;
  }
  EXPECT_TRUE(Json::parse(contentOf(folder.file("out/probe.json")), nullptr, false).is_object());
  EXPECT_NE(contentOf(folder.file("out/curves.svg")).find("<text"), std::string::npos);
}

}  // namespace
}  // namespace umbra::cli
