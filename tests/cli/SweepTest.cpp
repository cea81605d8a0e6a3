// Sweeps: every cell of a plan, kept as it is measured, the same table however it was made.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

class Sweep : public testing::Test {
 protected:
  Sweep() { writeMap(folder.file("m.exr"), smallMap()); }

  std::string write(const std::string& text) const {
    const std::string file = folder.file("plan.json");
    std::ofstream(file) << text;
    return file;
  }
  std::string mapPlan() const {
    return write(R"({"format": "umbrascope-sweep/1",
      "base": {"source": {"depth": "m.exr"}, "receiver": 0.7, "probe": [9, 5]},
      "axes": [{"setting": "technique", "values": ["vsm", "esm", "lvsm"]},
               {"setting": "kernel.radius", "values": [1, 2, 3]},
               {"setting": "vsm.min-variance", "log": [1e-6, 1e-4, 3],
                "when": {"technique": "vsm"}}],
      "measures": ["compare", "probe"]})");
  }
  Outcome sweep(const std::string& plan, const std::string& out, const Arguments& more = {}) const {
    Arguments arguments{"sweep", plan, "-o", folder.file(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  std::string table(const std::string& out, const char* name = "cells.jsonl") const {
    return contentOf(std::filesystem::path(folder.file(out)) / name);
  }
  std::vector<Json> rows(const std::string& out) const {
    std::istringstream lines(table(out));
    std::vector<Json> all;
    for (std::string line; std::getline(lines, line);) all.push_back(Json::parse(line));
    return all;
  }
  static std::vector<std::string> namesIn(const std::filesystem::path& path) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  TemporaryFolder folder;
};

// The figures are those of the commands for one setting.
TEST_F(Sweep, MeasuresWhatCompareAndProbeMeasure) {
  const Outcome outcome = sweep(mapPlan(), "out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(namesIn(folder.file("out")),
            (std::vector<std::string>{"cells.csv", "cells.jsonl", "sweep.json"}));
  const std::vector<Json> all = rows("out");
  ASSERT_EQ(all.size(), 15u);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i]["cell"], i);
  const Json& one = all[4];
  EXPECT_EQ(one["settings"], Json::parse(R"({"technique": "vsm", "kernel.radius": 2,
                                             "vsm.min-variance": 1e-5})"));
  const Arguments settings{
      "--depth", folder.file("m.exr"), "--receiver", "0.7",   "--technique",
      "vsm",     "--radius",           "2",          "--set", "vsm.min-variance=1e-5"};
  const auto command = [&](Arguments arguments) {
    arguments.insert(arguments.end(), settings.begin(), settings.end());
    return run(arguments).json();
  };
  const Json compared = command({"compare", "--json"});
  for (const char* figure : {"rmse", "mae", "bleeding", "darkening", "max", "min"})
    EXPECT_EQ(one["compare"][figure], compared["techniques"][0][figure]) << figure;
  EXPECT_EQ(one["compare"]["samples"], compared["samples"]);
  const Json probed = command({"probe", "--json", "--texel", "9,5"});
  EXPECT_EQ(one["probe"]["visibility"], probed["techniques"][0]["visibility"]);
  EXPECT_EQ(one["probe"]["reference"], probed["reference"]);
}

TEST_F(Sweep, TheTableHasAColumnForEachSettingAndFigure) {
  ASSERT_EQ(sweep(mapPlan(), "out").status, 0);
  std::istringstream lines(table("out", "cells.csv"));
  std::string heading, line;
  std::getline(lines, heading);
  EXPECT_TRUE(heading.starts_with("cell,technique,kernel.radius,vsm.min-variance,"));
  for (const char* column : {",rmse", ",probe.visibility", ",smallestReduction.amount"})
    EXPECT_NE(heading.find(column), std::string::npos) << heading;
  const auto columns = std::count(heading.begin(), heading.end(), ',');
  std::size_t count = 0;
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
    ++count;
  }
  EXPECT_EQ(count, 15u);
  EXPECT_TRUE(line.starts_with("14,lvsm,3,,") ||
              table("out", "cells.csv").find("14,lvsm,3,,") != std::string::npos);
}

TEST_F(Sweep, PartsMakeTheSameTable) {
  const std::string plan = mapPlan();
  ASSERT_EQ(sweep(plan, "whole").status, 0);
  for (const char* part : {"8-14", "0-3", "4-7"})
    ASSERT_EQ(sweep(plan, "parts", {"--cells", part}).status, 0);
  EXPECT_EQ(namesIn(folder.file("parts")),
            (std::vector<std::string>{"cells-0-3.jsonl", "cells-4-7.jsonl", "cells-8-14.jsonl"}));
  ASSERT_EQ(sweep(plan, "parts").status, 0);
  EXPECT_EQ(table("parts"), table("whole"));
  EXPECT_EQ(table("parts", "cells.csv"), table("whole", "cells.csv"));
}

// A process that is killed leaves the cells that it has kept, the last line perhaps cut.
TEST_F(Sweep, GoesOnWhereAnEndedRunWas) {
  const std::string plan = mapPlan();
  ASSERT_EQ(sweep(plan, "whole").status, 0);
  const Json header{{"plan", Json::parse(table("whole", "sweep.json"))["plan"]},
                    {"version", Json::parse(table("whole", "sweep.json"))["version"]}};
  const std::string all = table("whole");
  for (const std::size_t kept : {std::size_t(0), all.size() / 3, all.size() - 1}) {
    const std::filesystem::path out = folder.file("ended" + std::to_string(kept));
    std::filesystem::create_directories(out);
    std::ofstream(out / "kept-0-14.jsonl") << header.dump() << "\n" << all.substr(0, kept);
    ASSERT_EQ(sweep(plan, out.filename().string()).status, 0);
    EXPECT_EQ(contentOf(out / "cells.jsonl"), all);
    EXPECT_EQ(namesIn(out), namesIn(folder.file("whole")));
  }
}

TEST_F(Sweep, AnInterruptedRunKeepsItsCells) {
  const std::string plan = mapPlan();
  const Outcome stopped = run({"sweep", plan, "-o", folder.file("out")}, {{}, "", true});
  EXPECT_EQ(stopped.status, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("of 15 cells are kept"), std::string::npos) << stopped.err;
  ASSERT_EQ(sweep(plan, "out").status, 0);
  EXPECT_EQ(rows("out").size(), 15u);
}

TEST_F(Sweep, DoesNotMixTablesOfTwoPlans) {
  const std::string plan = mapPlan();
  ASSERT_EQ(sweep(plan, "out").status, 0);
  const std::string before = table("out");
  ASSERT_EQ(sweep(plan, "out").status, 0);  // nothing is missing
  EXPECT_EQ(table("out"), before);
  writeMap(folder.file("m.exr"), smallMap(24, 18));
  const Outcome other = sweep(plan, "out");
  EXPECT_EQ(other.status, 4);
  EXPECT_NE(other.err.find("files that have changed"), std::string::npos) << other.err;
  EXPECT_EQ(table("out"), before);
}

TEST_F(Sweep, MeasuresScenesAndSaysWhatCannotStandTogether) {
  const std::string plan = write(R"({"format": "umbrascope-sweep/1",
    "base": {"source": {"scene": "two-planes"}, "size": [160, 100], "probe": [80, 60],
             "frame": {"mapSize": 128}},
    "axes": [{"setting": "technique", "values": ["vsm", "hard", "power-cdf"]},
             {"setting": "read.filter", "values": ["bilinear", "sat"]}],
    "measures": ["compare", "decomposition", "cost", "picture"]})");
  ASSERT_EQ(sweep(plan, "out").status, 0);
  const std::vector<Json> all = rows("out");
  ASSERT_EQ(all.size(), 6u);
  const Json compared =
      run({"compare", "--json", "--scene", "two-planes", "--size", "160x100", "--map-size", "128",
           "--technique", "vsm", "--filter", "sat", "--decompose"})
          .json();
  EXPECT_EQ(all[1]["compare"]["rmse"], compared["techniques"][0]["rmse"]);
  EXPECT_EQ(all[1]["compare"]["decomposition"], compared["techniques"][0]["decomposition"]);
  EXPECT_EQ(all[1]["cost"]["bytesStored"], compared["techniques"][0]["cost"]["bytesStored"]);
  EXPECT_GT(all[1]["cost"]["shadeMs"], 0.0);
  // Minima and maxima have no summed areas.
  EXPECT_FALSE(all[5].contains("compare"));
  EXPECT_NE(all[5]["reason"].get<std::string>().find("power-cdf"), std::string::npos) << all[5];
  for (const Json& row : all)
    if (row.contains("picture")) {
      const std::string picture = row["picture"];
      EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / picture)) << picture;
    }
}

// What was measured with other values than the cell's says so; a light that looks nowhere ends one
// cell, not all.
TEST_F(Sweep, SaysWhatWasMeasuredOtherwise) {
  const std::string limited = write(R"({"format": "umbrascope-sweep/1",
    "base": {"source": {"depth": "m.exr"}, "receiver": 0.7, "technique": "esm"},
    "axes": [{"setting": "map.format", "values": ["float", "half"]},
             {"setting": "esm.exponent", "values": [10, 80]}]})");
  const Outcome outcome = sweep(limited, "limited");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("esm: "), std::string::npos) << outcome.err;
  const std::vector<Json> all = rows("limited");
  EXPECT_FALSE(all[1].contains("notices"));
  EXPECT_TRUE(all[3].contains("notices"));
  EXPECT_LT(all[3]["parameters"]["exponent"], 80.0);

  const std::string blind = write(R"({"format": "umbrascope-sweep/1",
    "base": {"source": {"scene": "two-planes"}, "size": [64, 48], "frame": {"mapSize": 64},
             "light": {"kind": "spot", "position": [0, 9, 0], "target": [0, 0, 0]}},
    "axes": [{"setting": "light.position", "values": ["0,0,0", "0,9,0"]}]})");
  ASSERT_EQ(sweep(blind, "blind").status, 0);
  EXPECT_NE(rows("blind")[0]["reason"].get<std::string>().find("light"), std::string::npos);
  EXPECT_TRUE(rows("blind")[1].contains("compare"));
}

// A folder may hold what somebody else wrote there.
TEST_F(Sweep, RefusesFilesThatAreNoCells) {
  const std::string plan = mapPlan();
  const std::filesystem::path out = folder.file("out");
  std::filesystem::create_directories(out);
  for (const auto& [name, content] :
       {std::pair("sweep.json", "[]"), std::pair("sweep.json", R"({"plan": 3})"),
        std::pair("cells-0-1.jsonl", "[1]\n")}) {
    std::ofstream(out / name) << content;
    const Outcome outcome = sweep(plan, "out");
    EXPECT_EQ(outcome.status, 4) << content;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
    std::filesystem::remove(out / name);
  }
}

TEST_F(Sweep, MeasuresTheExamples) {
  for (const auto& example : std::filesystem::directory_iterator(UMBRASCOPE_SWEEPS)) {
    const std::string name = example.path().stem().string();
    ASSERT_EQ(sweep(example.path().string(), name, {"--cells", "0-1"}).status, 0) << name;
    EXPECT_EQ(namesIn(folder.file(name)), std::vector<std::string>{"cells-0-1.jsonl"});
  }
}

TEST_F(Sweep, RefusesWrongCommandLines) {
  const std::string plan = mapPlan();
  EXPECT_EQ(run({"sweep", plan}).status, 2);
  EXPECT_EQ(run({"sweep", "-o", folder.file("x")}).status, 2);
  EXPECT_EQ(sweep(plan, "out", {"--cells", "3-99"}).status, 2);
  EXPECT_EQ(sweep(plan, "out", {"--cells", "3"}).status, 2);
  EXPECT_EQ(sweep(plan, "out", {"--batch", "3"}).status, 2);
  EXPECT_EQ(sweep(folder.file("absent.json"), "out").status, 3);
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

TEST_F(Sweep, WritesAWorkflowOfAllCells) {
  const std::string plan = mapPlan();
  const Outcome outcome = run({"sweep", plan, "--snakemake", folder.file("flow"), "--batch", "4"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string text = contentOf(std::filesystem::path(folder.file("flow")) / "Snakefile");
  for (const char* part : {"\"0-3\"", "\"4-7\"", "\"8-11\"", "\"12-14\""})
    EXPECT_NE(text.find(part), std::string::npos) << text;
  EXPECT_NE(text.find(plan), std::string::npos);
}

}  // namespace
}  // namespace umbra::cli
