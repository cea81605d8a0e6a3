// The cost of frames. Nothing here depends on how fast the machine is.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

// A small picture and map, so that a round takes milliseconds.
Outcome bench(const Arguments& options, const Setting& setting = {}) {
  Arguments arguments{"bench", "--size", "64x48", "--map-size", "32"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run(arguments, setting);
}

void expectQuartiles(const Json& cost) {
  ASSERT_EQ(cost["ms"].size(), 3u) << cost;
  EXPECT_GT(cost["ms"][0], 0.0);
  EXPECT_LE(cost["ms"][0], cost["ms"][1]);
  EXPECT_LE(cost["ms"][1], cost["ms"][2]);
}

double medianOf(const Json& moved, const std::string& motion) {
  return moved[motion]["ms"][1].get<double>();
}

TEST(Bench, MeasuresCasesAndBaselinesInBothMotions) {
  const Json json = bench({"--technique", "vsm,csm", "--rounds", "2", "--format", "half", "--set",
                           "csm.terms=16", "--json"})
                        .json();
  EXPECT_EQ(json["format"], "umbrascope-bench/1");
  EXPECT_EQ(json["rounds"], 2);
  EXPECT_EQ(json["scene"], "tree-bench");
  EXPECT_FALSE(json["renderer"].get<std::string>().empty());
  ASSERT_EQ(json["cases"].size(), 2u);
  for (const char* name : {"noShadow", "vtkShadowMapPass"})
    for (const char* motion : {"camera", "light"}) expectQuartiles(json["baselines"][name][motion]);
  for (const Json& row : json["cases"]) {
    for (const char* motion : {"camera", "light"}) expectQuartiles(row[motion]);
    for (const char* pass : {"depth", "encode", "prefilter", "shade"})
      EXPECT_TRUE(row["passes"].contains(pass)) << pass;
  }
  const Json &vsm = json["cases"][0], &csm = json["cases"][1];
  EXPECT_EQ(vsm["name"], "vsm");
  EXPECT_EQ(vsm["settings"]["kernel.radius"], 3);
  EXPECT_EQ(csm["settings"]["csm.terms"], 16);
}

// Two and 32 channels of two bytes. The program has the depth beside them, and for the blur a copy
// of 32 bits and one of the format.
TEST(Bench, CountsBytesOfTheMethodApartFromThoseOfTheProgram) {
  const Json json = bench({"--technique", "vsm,csm,pcf", "--rounds", "1", "--format", "half",
                           "--set", "csm.terms=16", "--json"})
                        .json();
  EXPECT_EQ(json["cases"][0]["bytesStored"], 2 * 2);
  EXPECT_EQ(json["cases"][0]["bytesUsed"], 4 + 2 * (2 + 4 + 2));
  EXPECT_EQ(json["cases"][1]["bytesStored"], 32 * 2);
  EXPECT_EQ(json["cases"][1]["bytesUsed"], 4 + 32 * (2 + 4 + 2));
  EXPECT_EQ(json["cases"][2]["bytesStored"], 2);
  EXPECT_EQ(json["cases"][2]["bytesUsed"], 4 + 2);
}

TEST(Bench, RatiosAreQuotientsOfTheMediansThatItPrints) {
  const Json json = bench({"--technique", "vsm,esm", "--rounds", "3", "--json"}).json();
  ASSERT_EQ(json["ratios"].size(), 4u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& row = json["cases"][i];
    const std::string name = row["name"];
    const Json &camera = json["ratios"][2 * i], &light = json["ratios"][2 * i + 1];
    EXPECT_EQ(camera["name"], name + " camera / noShadow camera");
    EXPECT_EQ(light["name"], name + " light / vtkShadowMapPass light");
    const Json& baselines = json["baselines"];
    EXPECT_DOUBLE_EQ(camera["value"],
                     medianOf(row, "camera") / medianOf(baselines["noShadow"], "camera"));
    EXPECT_DOUBLE_EQ(light["value"],
                     medianOf(row, "light") / medianOf(baselines["vtkShadowMapPass"], "light"));
    EXPECT_TRUE(camera["goal"].is_null());
  }
}

// Which goals a small picture meets depends on the machine; what the program says of it does not.
TEST(Bench, ExitsWithOneWhereAGoalIsMissedAndNamesIt) {
  const Outcome outcome = bench({"--goal", "lvsm", "--goal", "csm", "--rounds", "2", "--json"});
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["scene"], "car");
  EXPECT_EQ(json["light"], "spot");
  ASSERT_EQ(json["ratios"].size(), 4u);
  std::size_t missed = 0;
  const std::string error = outcome.err.substr(outcome.err.find("--goals:") == std::string::npos
                                                   ? outcome.err.size()
                                                   : outcome.err.find("--goals:"));
  for (const Json& ratio : json["ratios"]) {
    EXPECT_EQ(ratio["holds"], ratio["value"] <= ratio["goal"]);
    missed += ratio["holds"] ? 0 : 1;
    const bool named = error.find(ratio["name"].get<std::string>()) != std::string::npos;
    EXPECT_EQ(named, !ratio["holds"].get<bool>()) << ratio << error;
  }
  EXPECT_EQ(outcome.status, missed > 0 ? 1 : 0) << outcome.err;
}

TEST(Bench, KeepsTheGoalsOfNamedTechniques) {
  const Outcome outcome =
      bench({"--goals", "--technique", "evsm4,vsm", "--goal", "evsm4", "--rounds", "1", "--json"});
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["ratios"].size(), 1u);
  EXPECT_EQ(json["ratios"][0]["name"], "evsm4 light / vsm light");
  EXPECT_EQ(json["cases"].size(), 2u);
}

// On llvmpipe both clocks can be asked for; figures differ, their shape does not.
TEST(Bench, TakesTheClockThatIsAskedFor) {
  for (const char* clock : {"processor", "gpu"}) {
    const Json json = bench({"--rounds", "1", "--clock", clock, "--json"}).json();
    EXPECT_EQ(json["clock"], clock);
    expectQuartiles(json["cases"][0]["light"]);
    expectQuartiles(json["baselines"]["noShadow"]["camera"]);
  }
}

TEST(Bench, WritesAFolderWithARowForEachCaseAndBaseline) {
  const TemporaryFolder folder;
  const Outcome outcome = bench({"--rounds", "1", "-o", folder.file("out")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string csv = contentOf(folder.file("out/bench.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  const std::string heading = csv.substr(0, csv.find('\n'));
  for (std::size_t line = 0; line != std::string::npos; line = csv.find('\n', line + 1)) {
    const std::string row = csv.substr(line, csv.find('\n', line + 1) - line);
    if (row.size() <= 1) continue;
    EXPECT_EQ(std::count(row.begin(), row.end(), ','),
              std::count(heading.begin(), heading.end(), ','));
  }
  EXPECT_TRUE(Json::parse(contentOf(folder.file("out/bench.json"))).contains("cases"));
}

TEST(Bench, PrintsATableForPeople) {
  const Outcome outcome = bench({"--rounds", "1"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* word : {"noShadow", "vtkShadowMapPass", "BYTES STORED", "prefilter",
                           "vsm light / vtkShadowMapPass light"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << outcome.out;
}

TEST(Bench, RefusesWhatItCannotMeasure) {
  const std::pair<Arguments, const char*> wrong[] = {
      {{"--rounds", "0"}, "--rounds"},
      {{"--rounds", "many"}, "--rounds"},
      {{"--clock", "sun"}, "--clock"},
      {{"--goal", "moonshine"}, "--goal"},
      {{"--goals", "--technique", "hard"}, "--technique"},
      {{"--depth", "m.exr"}, "--depth"},
      {{"--format", "double"}, "--format"},
      {{"--speed", "9"}, "--speed"},
      {{"--json", "-o", "x"}, "--json"}};
  for (const auto& [arguments, option] : wrong) {
    const Outcome outcome = bench(arguments);
    EXPECT_EQ(outcome.status, 2) << option << outcome.err;
    EXPECT_NE(outcome.err.find(option), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  }
}

TEST(Bench, IsCancelledBetweenFramesAndLeavesNothing) {
  const TemporaryFolder folder;
  const Outcome outcome =
      bench({"--rounds", "1000", "-o", folder.file("out")}, {.interrupt = true});
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(Bench, CompareHasWhatATechniqueCosts) {
  const Json json =
      run({"compare", "--size", "64x48", "--map-size", "32", "--technique", "vsm,pcf", "--json"})
          .json();
  for (const Json& row : json["techniques"]) {
    EXPECT_GT(row["cost"]["bakeMs"], 0.0);
    EXPECT_GT(row["cost"]["shadeMs"], 0.0);
  }
  EXPECT_EQ(json["techniques"][0]["cost"]["bytesStored"], 8);
  EXPECT_EQ(json["techniques"][0]["cost"]["bytesUsed"], 28);
  EXPECT_EQ(json["techniques"][1]["cost"]["bytesStored"], 4);
}

}  // namespace
}  // namespace umbra::cli
