// `probe --depth` against an evaluation written here, which is independent of the program's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <tuple>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

// The texels of a box of radius r, edges repeated.
struct Taps {
  std::vector<double> depths;
  double mean = 0.0, secondMoment = 0.0, variance = 0.0;

  Taps(const Image<float>& map, int x, int y, int r) {
    for (int j = -r; j <= r; ++j)
      for (int i = -r; i <= r; ++i)
        depths.push_back(
            map(std::clamp(x + i, 0, map.width() - 1), std::clamp(y + j, 0, map.height() - 1)));
    for (double z : depths) mean += z / double(depths.size());
    for (double z : depths) secondMoment += z * z / double(depths.size());
    for (double z : depths) variance += (z - mean) * (z - mean) / double(depths.size());
  }
  double min() const { return *std::min_element(depths.begin(), depths.end()); }
  double max() const { return *std::max_element(depths.begin(), depths.end()); }
  double beta() const { return (mean - min()) / (max() - mean); }
};

double pcf(const Taps& taps, double z) {
  return double(std::count_if(taps.depths.begin(), taps.depths.end(),
                              [z](double depth) { return depth >= z; })) /
         double(taps.depths.size());
}

double vsm(const Taps& taps, double z) {
  if (z <= taps.mean) return 1.0;
  const double variance = std::max(taps.variance, 1e-6);
  return variance / (variance + (z - taps.mean) * (z - taps.mean));
}

double powerCdf(const Taps& taps, double z) {
  if (taps.min() == taps.max()) return taps.min() >= z ? 1.0 : 0.0;
  if (z <= taps.mean) return 1.0;
  if (z >= taps.max()) return 0.0;
  const double beta = taps.beta(), t = (z - taps.min()) / (taps.max() - taps.min());
  return (1.0 - std::pow(t, beta)) / (1.0 - std::pow(beta / (beta + 1.0), beta));
}

double valueOf(const std::string& technique, const Taps& taps, double z) {
  return technique == "pcf" ? pcf(taps, z) : technique == "vsm" ? vsm(taps, z) : powerCdf(taps, z);
}

class ProbeDepth : public testing::Test {
 protected:
  ProbeDepth() { writeMap(file, map); }

  Json probe(int x, int y, double receiver, const Arguments& more = {}) const {
    Arguments arguments{"probe",      "--json",
                        "--depth",    file,
                        "--texel",    std::to_string(x) + "," + std::to_string(y),
                        "--receiver", Json(receiver).dump()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).json();
  }

  TemporaryFolder folder;
  const std::string file = folder.file("m.exr");
  const Image<float> map = smallMap();
};

std::set<std::string> keysOf(const Json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST_F(ProbeDepth, PrintsTheFieldsThatScriptsRelyOn) {
  const Json object = probe(8, 9, 0.7, {"--technique", "vsm"});
  EXPECT_EQ(keysOf(object), (std::set<std::string>{"format", "source", "region", "receiver",
                                                   "receiverWorld", "receiverFile", "statistics",
                                                   "reference", "techniques", "histogram"}));
  EXPECT_EQ(object["format"], "umbrascope-probe/1");
  EXPECT_EQ(object["source"],
            (Json{{"name", "m.exr"}, {"width", 24}, {"height", 17}, {"origin", {0, 0}}}));
  EXPECT_EQ(object["region"],
            (Json{{"texel", {8, 9}}, {"kernel", "box"}, {"radius", 3}, {"texels", 49}}));
  EXPECT_EQ(object["receiver"], 0.7);
  EXPECT_EQ(keysOf(object["statistics"]),
            (std::set<std::string>{"mean", "secondMoment", "variance", "min", "max", "beta"}));
  ASSERT_EQ(object["techniques"].size(), 1u);
  const Json row = object["techniques"][0];
  EXPECT_EQ(keysOf(row), (std::set<std::string>{"name", "parameters", "visibility", "error",
                                                "smallestReduction"}));
  EXPECT_EQ(row["parameters"], (Json{{"min-variance", 1e-6}, {"bleed-reduction", 0.0}}));
}

TEST_F(ProbeDepth, TellsTheSmallestReductionAndWhatItCosts) {
  for (const auto& [x, y, receiver] :
       {std::tuple{8, 9, 0.66}, std::tuple{7, 3, 0.72}, std::tuple{12, 4, 0.69}}) {
    const Json rows = probe(x, y, receiver, {"--technique", "vsm,csm"})["techniques"];
    EXPECT_FALSE(rows[1].contains("smallestReduction"));
    const Json found = rows[0]["smallestReduction"];
    const Taps taps(map, x, y, 3);
    const double bound = vsm(taps, receiver), reference = pcf(taps, receiver);
    ASSERT_GT(bound, reference);
    const double amount = (bound - reference) / (1.0 - reference);
    EXPECT_NEAR(found["amount"], amount, 1e-9);
    EXPECT_TRUE(found["removesAll"]);
    double darkening = 0.0;
    for (double z : taps.depths) {
      const double reduced = std::max(0.0, (vsm(taps, z) - amount) / (1.0 - amount));
      darkening = std::max(darkening, pcf(taps, z) - reduced);
    }
    EXPECT_NEAR(found["darkening"], darkening, 1e-9);
    // The amount works whatever was set before.
    const Json after =
        probe(x, y, receiver,
              {"--technique", "vsm", "--set", "vsm.bleed-reduction=" + found["amount"].dump()});
    EXPECT_NEAR(after["techniques"][0]["error"], 0.0, 1e-9);
    EXPECT_EQ(after["techniques"][0]["smallestReduction"], found);
  }
}

TEST_F(ProbeDepth, AgreesWithAnIndependentEvaluation) {
  for (const auto& [x, y] : {std::pair{8, 3}, {8, 12}, {0, 0}, {23, 16}, {15, 8}})
    for (int radius : {0, 1, 3, 9})
      for (double receiver : {0.1, 0.3, 0.62, 0.75, 0.999}) {
        const Taps taps(map, x, y, radius);
        const Json object =
            probe(x, y, receiver,
                  {"--technique", "pcf,vsm,power-cdf", "--radius", std::to_string(radius)});
        EXPECT_NEAR(object["statistics"]["mean"], taps.mean, 1e-9);
        EXPECT_NEAR(object["statistics"]["secondMoment"], taps.secondMoment, 1e-9);
        EXPECT_NEAR(object["statistics"]["variance"], taps.variance, 1e-9);
        EXPECT_EQ(object["statistics"]["min"], taps.min());
        EXPECT_EQ(object["statistics"]["max"], taps.max());
        EXPECT_NEAR(object["reference"], pcf(taps, receiver), 1e-9);
        ASSERT_EQ(object["techniques"].size(), 3u);
        for (const Json& row : object["techniques"]) {
          const double expected = valueOf(row["name"], taps, receiver);
          EXPECT_NEAR(row["visibility"], expected, 1e-9) << row << " at " << x << "," << y;
          EXPECT_NEAR(row["error"], expected - pcf(taps, receiver), 1e-9) << row;
        }
      }
}

TEST_F(ProbeDepth, CurvesFollowTheSameFormulas) {
  const Json curves =
      probe(8, 9, 0.7, {"--technique", "pcf,vsm,power-cdf", "--samples", "33"})["curves"];
  const Taps taps(map, 8, 9, 3);
  EXPECT_EQ(keysOf(curves),
            (std::set<std::string>{"depth", "reference", "pcf", "vsm", "power-cdf"}));
  for (const auto& [name, values] : curves.items()) EXPECT_EQ(values.size(), 33u) << name;
  for (int i = 0; i < 33; ++i) {
    const double z = i / 32.0;
    EXPECT_EQ(curves["depth"][i], z);
    EXPECT_NEAR(curves["reference"][i], pcf(taps, z), 1e-9);
    for (const char* name : {"pcf", "vsm", "power-cdf"})
      EXPECT_NEAR(curves[name][i], valueOf(name, taps, z), 1e-9) << name << " at " << z;
  }
}

TEST_F(ProbeDepth, HistogramCoversTheRegionsDepths) {
  const Json histogram = probe(8, 9, 0.7, {"--bins", "5"})["histogram"];
  const Taps taps(map, 8, 9, 3);
  ASSERT_EQ(histogram["edges"].size(), 6u);
  ASSERT_EQ(histogram["weights"].size(), 5u);
  EXPECT_EQ(histogram["edges"][0], taps.min());
  EXPECT_EQ(histogram["edges"][5], taps.max());
  for (int bin = 0; bin < 5; ++bin) {
    const double low = histogram["edges"][bin], high = histogram["edges"][bin + 1];
    const auto inside = std::count_if(taps.depths.begin(), taps.depths.end(), [&](double z) {
      return z >= low && (z < high || (bin == 4 && z == high));
    });
    EXPECT_NEAR(histogram["weights"][bin], double(inside) / 49.0, 1e-12) << bin;
  }
}

TEST_F(ProbeDepth, GaussianWeighsByDistance) {
  const Json object = probe(8, 9, 0.7, {"--kernel", "gaussian", "--radius", "2", "--sigma", "0.8"});
  double mean = 0.0, sum = 0.0;
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) {
      const double weight = std::exp(-(i * i + j * j) / (2 * 0.8 * 0.8));
      mean += weight * map(8 + i, 9 + j);
      sum += weight;
    }
  EXPECT_NEAR(object["statistics"]["mean"], mean / sum, 1e-9);
  EXPECT_EQ(object["region"]["texels"], 25);
}

TEST_F(ProbeDepth, AnInfiniteBetaIsNull) {
  EXPECT_TRUE(probe(1, 1, 0.7, {"--radius", "1"})["statistics"]["beta"].is_null());
}

TEST_F(ProbeDepth, ParametersAndFormatsReachTheTechnique) {
  const Json plain = probe(8, 9, 0.7, {"--technique", "vsm"});
  const Json reduced =
      probe(8, 9, 0.7, {"--technique", "vsm", "--set", "vsm.bleed-reduction=0.25"});
  const double p = plain["techniques"][0]["visibility"];
  EXPECT_NEAR(reduced["techniques"][0]["visibility"], std::max(0.0, (p - 0.25) / 0.75), 1e-12);
  const Json half = probe(8, 9, 0.7, {"--technique", "vsm", "--format", "half"});
  EXPECT_NE(half["techniques"][0]["visibility"], p);
  // Half rounds by up to 2^-11, once per texel and once after the mean, each moment. The slope of
  // the bound is at most 1/(4σ²) over the variance and 3√3/(8σ) over the mean; doubled for what
  // is not linear.
  const Taps taps(map, 8, 9, 3);
  const double meanError = 2 * std::ldexp(taps.mean, -11);
  const double varianceError = 2 * std::ldexp(taps.secondMoment, -11) + 2 * taps.mean * meanError;
  const double bound =
      varianceError / (4 * taps.variance) + 0.65 * meanError / std::sqrt(taps.variance);
  EXPECT_NEAR(half["techniques"][0]["visibility"], p, 2 * bound);
}

TEST_F(ProbeDepth, DepthRangeAndChannelChooseTheValues) {
  Image<float> metres = map;
  for (float& z : metres.values()) z = 2.0f + 8.0f * z;
  writeMap(folder.file("metres.exr"), metres, "distance");
  const Json object = run({"probe", "--json", "--depth", folder.file("metres.exr") + ":distance",
                           "--depth-range", "2,10", "--texel", "8,9", "--receiver", "0.7"})
                          .json();
  // One rounding of 2 + 8z to float, seen after division by 8.
  EXPECT_NEAR(object["statistics"]["mean"], probe(8, 9, 0.7)["statistics"]["mean"], 6e-8);
}

TEST_F(ProbeDepth, WithoutATechniqueAllAreProbed) {
  const Json object = probe(8, 9, 0.7), catalogue = run({"techniques", "--json"}).json();
  std::set<std::string> probed, listed;
  for (const Json& row : object["techniques"]) probed.insert(row["name"]);
  for (const Json& row : catalogue["techniques"]) listed.insert(row["name"]);
  EXPECT_EQ(probed, listed);
  EXPECT_GE(listed.size(), 7u);
}

TEST_F(ProbeDepth, TextForPeopleHasTheSameFigures) {
  const Outcome outcome = run({"probe", "--depth", file, "--texel", "8,9", "--receiver", "0.7"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("box 7×7"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("power-cdf"), std::string::npos) << outcome.out;
}

// The lvsm row's layers, placement and number of splits.
std::string layeringIn(const Json& object) {
  const Json& parameters = object["techniques"][0]["parameters"];
  return std::to_string(parameters["layers"].get<int>()) + " " +
         parameters["placement"].get<std::string>() + " " +
         std::to_string(parameters["splits"].size());
}

TEST_F(ProbeDepth, TheLaterOfTwoSettingsHolds) {
  const auto layering = [this](const Arguments& settings) {
    Arguments arguments{"--technique", "lvsm"};
    for (const std::string& setting : settings)
      arguments.insert(arguments.end(), {"--set", "lvsm." + setting});
    return layeringIn(probe(8, 9, 0.7, arguments));
  };
  EXPECT_EQ(layering({"splits=0.2:0.5", "placement=lloyd"}), "3 lloyd 0");
  EXPECT_EQ(layering({"placement=lloyd", "splits=0.2:0.5"}), "3 manual 2");
  // the default, 4, still removes the splits
  EXPECT_EQ(layering({"splits=0.2:0.5", "layers=4"}), "4 manual 0");
  EXPECT_EQ(layering({"layers=4", "splits=0.2:0.5"}), "3 manual 2");
  EXPECT_EQ(layering({"splits=0.2:0.5", "layers=7", "placement=uniform"}), "7 uniform 0");
}

TEST_F(ProbeDepth, ASettingOverridesTheSessions) {
  std::ofstream(folder.file("s.json"))
      << R"({"format": "umbrascope-session/1", "parameters": {"lvsm": {"splits": [0.2, 0.5]}}})";
  const Arguments session{"--technique", "lvsm", "--session", folder.file("s.json")};
  const auto layering = [&](const Arguments& more) {
    Arguments arguments = session;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return layeringIn(probe(8, 9, 0.7, arguments));
  };
  EXPECT_EQ(layering({}), "3 manual 2");
  EXPECT_EQ(layering({"--set", "lvsm.layers=7"}), "7 manual 0");
  EXPECT_EQ(layering({"--set", "lvsm.overlap=0.02"}), "3 manual 2");
}

TEST_F(ProbeDepth, AllAnywhereInTheListIsAll) {
  const std::size_t every = probe(8, 9, 0.7, {"--technique", "all"})["techniques"].size();
  EXPECT_GT(every, 8u);
  EXPECT_EQ(probe(8, 9, 0.7, {"--technique", "all,vsm"})["techniques"].size(), every);
  EXPECT_EQ(probe(8, 9, 0.7, {"--technique", "vsm,all"})["techniques"].size(), every);
}

}  // namespace
}  // namespace umbra::cli
