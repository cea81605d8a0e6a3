// Sessions that compare techniques, drawn without a display.
#include <gtest/gtest.h>

#include <QImage>
#include <fstream>

#include "datasets/maps/DepthFile.h"
#include "filters/core/support/Error.h"
#include "tests/cli/PictureDifference.h"
#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

constexpr int width = 160, height = 120;

// Saves a session in a file and renders it with these options.
QImage drawn(const std::string& compare, const Arguments& options = {}) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("s.json"))
      << R"({"format": "umbrascope-session/1", "source": {"scene": "three-planes"},
             "frame": {"mapSize": 256}, "size": [160, 120], "technique": "vsm", "compare": )"
      << compare << "}";
  Arguments arguments{"render", "--session", folder.file("s.json"), "-o", folder.file("p.png")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return readPicture(folder.file("p.png"));
}

TEST(ComparedPicture, AWipeIsOnePictureOfTwo) {
  const char* const session = R"({"mode": "wipe", "techniques": ["vsm", "hard"], "wipe": 0.5})";
  const QImage both = drawn(session);
  const QImage vsm = drawn(session, {"--technique", "vsm"});
  const QImage hard = drawn(session, {"--technique", "hard"});
  const QRect left(0, 0, width / 2, height), right(width / 2, 0, width / 2, height);
  ASSERT_EQ(both.size(), QSize(width, height));
  ASSERT_EQ(vsm.size(), both.size());
  EXPECT_EQ(both.copy(left), vsm.copy(left));
  EXPECT_EQ(both.copy(right), hard.copy(right));
  EXPECT_NE(vsm.copy(left), hard.copy(left));
  EXPECT_NE(vsm.copy(right), hard.copy(right));
}

TEST(ComparedPicture, ASideIsDrawnWithItsOwnSettings) {
  const char* const alone = R"({"mode": "single"})";
  const QImage narrow = drawn(alone);
  const QImage wide = drawn(alone, {"--radius", "9", "--map-size", "128"});
  const QRect left(0, 0, width / 2, height), right(width / 2, 0, width / 2, height);
  ASSERT_EQ(narrow.size(), QSize(width, height));
  EXPECT_NE(narrow.copy(right), wide.copy(right));
  // The result does not depend on which pane is active.
  for (const char* active : {"", R"(, "active": true)"}) {
    const QImage both = drawn(R"({"mode": "wipe", "panes": [{"technique": "vsm"},
        {"technique": "vsm", "kernel": {"radius": 9}, "mapSize": 128)" +
                              std::string(active) + "}]}");
    ASSERT_EQ(both.size(), narrow.size());
    EXPECT_EQ(both.copy(left), narrow.copy(left)) << active;
    EXPECT_EQ(both.copy(right), wide.copy(right)) << active;
  }
}

TEST(ComparedPicture, PanesAreDrawnOnOneSheet) {
  const QImage sheet = drawn(R"({"mode": "grid", "techniques": ["vsm", "hard", "msm"]})");
  // Three pictures come nearest to a screen's shape two in a row.
  EXPECT_GE(sheet.width(), 2 * width);
  EXPECT_LT(sheet.width(), 3 * width);
  EXPECT_GE(sheet.height(), 2 * height);
  EXPECT_LT(sheet.height(), 3 * height);
  EXPECT_EQ(drawn(R"({"mode": "single"})").size(), QSize(width, height));
}

// Two panes of one technique with another radius, and a third that a wipe does not show.
const char* const wideAndNarrow = R"({"format": "umbrascope-session/1",
    "source": {"scene": "three-planes"}, "frame": {"mapSize": 64}, "size": [32, 24],
    "technique": "vsm", "compare": {"mode": "wipe", "panes": [{"technique": "vsm"},
      {"technique": "vsm", "active": true, "kernel": {"radius": 9},
       "parameters": {"bleed-reduction": 0.3}}, {"technique": "msm"}]}})";
// What the second pane shows, without panes.
const Arguments wideAlone{
    "--scene",     "three-planes", "--map-size", "64", "--size", "32x24",
    "--technique", "vsm",          "--radius",   "9",  "--set",  "vsm.bleed-reduction=0.3"};

Outcome ran(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome;
}

TEST(ComparedLayers, EveryPaneIsAPartWithItsOwnSettings) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("s.json")) << wideAndNarrow;
  ran({"render", "-o", folder.file("panes.exr")}, {"--session", folder.file("s.json")});
  ran({"render", "-o", folder.file("wide.exr")}, wideAlone);
  const DepthMap wide = readDepthFile(folder.file("wide.exr"), "vsm.visibility");
  EXPECT_EQ(readDepthFile(folder.file("panes.exr"), "vsm-2.visibility"), wide);
  EXPECT_NE(readDepthFile(folder.file("panes.exr"), "vsm-1.visibility"), wide);
  EXPECT_EQ(readDepthFile(folder.file("panes.exr"), "vsm-2.reference"),
            readDepthFile(folder.file("wide.exr"), "reference"));
  EXPECT_THROW(readDepthFile(folder.file("panes.exr"), "msm.visibility"), Error);
  // Techniques on the command line take the panes' place.
  ran({"render", "-o", folder.file("named.exr"), "--technique", "msm"},
      {"--session", folder.file("s.json")});
  EXPECT_NO_THROW(readDepthFile(folder.file("named.exr"), "msm.visibility"));
}

TEST(ComparedFigures, EveryPaneIsARowWithItsOwnSettings) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("s.json")) << wideAndNarrow;
  const Arguments session{"--session", folder.file("s.json")};
  Json rows = ran({"compare", "--json"}, session).json()["techniques"];
  Json alone = ran({"compare", "--json"}, wideAlone).json()["techniques"][0];
  for (const char* time : {"bakeMs", "shadeMs"})  // no two runs take the same
    for (Json* row : {&rows[1], &alone}) (*row)["cost"].erase(time);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["pane"], 1);
  EXPECT_EQ(rows[0]["settings"], (Json{{"kernel.radius", 3}, {"vsm.bleed-reduction", 0.0}}));
  alone["pane"] = 2;
  alone["settings"] = {{"kernel.radius", 9}, {"vsm.bleed-reduction", 0.3}};
  EXPECT_EQ(rows[1], alone);
  EXPECT_NE(rows[0]["rmse"], alone["rmse"]);
  const std::string table = ran({"compare"}, session).out;
  EXPECT_NE(table.find("vsm, pane 2: kernel.radius 9, vsm.bleed-reduction 0.3"), std::string::npos)
      << table;
  const Json named = ran({"compare", "--json", "--technique", "vsm,msm"}, session).json();
  ASSERT_EQ(named["techniques"].size(), 2u);
  EXPECT_FALSE(named["techniques"][0].contains("pane"));
  EXPECT_EQ(named["techniques"][0]["rmse"], alone["rmse"]);  // as the active pane has it
}

TEST(ComparedFigures, PanesOfADepthMapHaveTheirOwnSettings) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  std::ofstream(folder.file("s.json"))
      << R"({"format": "umbrascope-session/1", "source": {"depth": "m.exr"}, "technique": "vsm",
             "receiver": 0.7, "compare": {"mode": "grid", "panes": [{"technique": "vsm"},
               {"technique": "vsm", "kernel": {"radius": 1}}]}})";
  const Json rows =
      ran({"compare", "--json"}, {"--session", folder.file("s.json")}).json()["techniques"];
  ASSERT_EQ(rows.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json alone =
        ran({"compare", "--depth", folder.file("m.exr"), "--receiver", "0.7"},
            {"--technique", "vsm", "--format", "float", "--radius", i == 0 ? "3" : "1", "--json"})
            .json()["techniques"][0];
    EXPECT_EQ(rows[i]["rmse"], alone["rmse"]) << i;
    EXPECT_EQ(rows[i]["settings"], (Json{{"kernel.radius", i == 0 ? 3 : 1}}));
  }
}

// Each pane's probe is the one that the same settings give by themselves, on whatever it is taken.
TEST(ComparedProbe, EveryPaneIsProbedWithItsOwnSettings) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  const auto probed = [&](const std::string& source, const Arguments& place) {
    std::ofstream(folder.file("s.json"))
        << R"({"format": "umbrascope-session/1", "technique": "vsm", "size": [160, 120], )" + source
        << R"(, "frame": {"mapSize": 256, "format": "float"}, "compare": {"mode": "grid", "panes": [
               {"technique": "vsm"}, {"technique": "msm"},
               {"technique": "vsm", "kernel": {"radius": 5}, "active": true,
                "parameters": {"bleed-reduction": 0.3}}]}})";
    Arguments arguments{"probe", "--session", folder.file("s.json"), "--json"};
    arguments.insert(arguments.end(), place.begin(), place.end());
    const auto alone = [&](const Arguments& options) {
      Arguments all = arguments;
      all.insert(all.end(), options.begin(), options.end());
      return run(all).json();
    };
    const Json json = alone({});
    ASSERT_EQ(json["panes"].size(), 3u) << source;
    EXPECT_GT(json["techniques"].size(), 3u);
    const Arguments settings[] = {
        {"--technique", "vsm", "--radius", "3", "--set", "vsm.bleed-reduction=0"},
        {"--technique", "msm", "--radius", "3"},
        {"--technique", "vsm", "--radius", "5", "--set", "vsm.bleed-reduction=0.3"}};
    for (std::size_t i = 0; i < 3; ++i) {
      Json pane = json["panes"][i], same = alone(settings[i]);
      EXPECT_FALSE(same.contains("panes"));
      EXPECT_EQ(pane["pane"], i + 1);
      EXPECT_EQ(pane["settings"]["kernel.radius"], i == 2 ? 5 : 3);
      EXPECT_EQ(pane["settings"].contains("vsm.bleed-reduction"), i != 1);
      for (const char* key : {"pane", "settings"}) pane.erase(key);
      for (const char* key : {"format", "source"}) same.erase(key);
      EXPECT_EQ(pane, same) << source << i;
    }
  };
  probed(R"("source": {"depth": "m.exr"})", {"--texel", "8,9", "--receiver", "0.7"});
  probed(R"("source": {"scene": "three-planes"})", {"--pixel", "80,80"});
}

TEST(ComparedProbe, SavedProbesHaveTheirPanes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("s.json");
  const auto write = [&](const std::string& more) {
    std::ofstream(file) << R"({"format": "umbrascope-session/1", "technique": "vsm",
        "size": [160, 120], "source": {"scene": "three-planes"}, "frame": {"mapSize": 128}, )" +
                               more + "}";
  };
  write(R"("probe": [80, 80])");
  const Json world = run({"probe", "--session", file, "--json"}).json()["world"];
  const std::string probes = R"("probes": [{"name": "here", "point": )" + world.dump() + "}], ";
  write(probes + R"("compare": {"mode": "wipe", "panes": [{"technique": "vsm"},
                      {"technique": "vsm", "kernel": {"radius": 9}}]})");
  const Json all = run({"probe", "--session", file, "--named", "all", "--json"}).json();
  ASSERT_EQ(all["probes"].size(), 1u);
  ASSERT_EQ(all["probes"][0]["panes"].size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& pane = all["probes"][0]["panes"][i];
    const Json alone = run({"probe", "--session", file, "--named", "here", "--technique", "vsm",
                            "--radius", i == 0 ? "3" : "9", "--json"})
                           .json();
    EXPECT_EQ(pane["techniques"], alone["techniques"]) << i;
    EXPECT_EQ(pane["reference"], alone["reference"]) << i;
  }
  const std::string text = run({"probe", "--session", file, "--named", "here"}).out;
  EXPECT_NE(text.find("vsm, pane 2: kernel.radius 9"), std::string::npos) << text;
}

// A pane that cannot be drawn stands in nobody's way: it says why it has no probe.
TEST(ComparedProbe, APaneThatCannotBeDrawnSaysWhy) {
  const TemporaryFolder folder;
  for (const char* other : {R"("power-cdf", "filter": "sat")", R"("vsm", "format": "double")"}) {
    std::ofstream(folder.file("s.json"))
        << R"({"format": "umbrascope-session/1", "technique": "vsm", "size": [160, 120],
               "source": {"scene": "three-planes"}, "frame": {"mapSize": 128}, "probe": [80, 80],
               "compare": {"mode": "wipe", "panes": [{"technique": "vsm", "active": true},
                 {"technique": )"
        << other << "}]}}";
    const Json json = run({"probe", "--session", folder.file("s.json"), "--json"}).json();
    ASSERT_EQ(json["panes"].size(), 2u) << other;
    EXPECT_TRUE(json["panes"][0].contains("techniques")) << other;
    EXPECT_TRUE(json["panes"][1].contains("reason")) << other;
    EXPECT_FALSE(json["panes"][1].contains("techniques")) << other;
  }
}

// A pane's parameters belong to its technique. As in the window, another technique in the pane
// leaves the parameters of the first one as the other panes share them.
TEST(ComparedProbe, AnotherTechniqueLeavesWhatThePanesShareOfTheFirst) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  const auto vsm = [&](const std::string& active, const std::string& techniques) {
    std::ofstream(folder.file("s.json"))
        << R"({"format": "umbrascope-session/1", "source": {"depth": "m.exr"}, "technique": "vsm",
               "parameters": {"vsm": {"bleed-reduction": 0.1}},
               "compare": {"mode": "grid", "panes": [{"technique": "vsm"}, {"technique": "vsm", )"
        << active << R"("parameters": {"bleed-reduction": 0.3}}]}})";
    const Json json = run({"probe", "--session", folder.file("s.json"), "--texel", "8,9",
                           "--receiver", "0.7", "--technique", techniques, "--json"})
                          .json();
    return json["techniques"].back();
  };
  const std::string active = R"("active": true, )";
  const Json shared = vsm("", "vsm");
  EXPECT_NE(vsm(active, "vsm"), shared);
  EXPECT_EQ(vsm(active, "lvsm,vsm"), shared);
}

}  // namespace
}  // namespace umbra::cli
