// Sessions that compare techniques, drawn without a display.
#include <gtest/gtest.h>

#include <QImage>
#include <fstream>

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

TEST(ComparedPicture, PanesAreDrawnBesideEachOther) {
  const QImage sheet = drawn(R"({"mode": "grid", "techniques": ["vsm", "hard", "msm"]})");
  EXPECT_GE(sheet.width(), 3 * width);
  EXPECT_LT(sheet.width(), 4 * width);
  EXPECT_GE(sheet.height(), height);
  EXPECT_EQ(drawn(R"({"mode": "single"})").size(), QSize(width, height));
}

TEST(ComparedPicture, OfPanesLayersAreTheActiveOnesWhichIsSaid) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("s.json"))
      << R"({"format": "umbrascope-session/1", "source": {"scene": "three-planes"},
             "frame": {"mapSize": 64}, "size": [32, 24], "technique": "vsm",
             "compare": {"mode": "wipe", "panes": [{"technique": "vsm"},
               {"technique": "vsm", "active": true, "kernel": {"radius": 9}},
               {"technique": "msm"}]}})";
  const auto said = [&](const Arguments& more) {
    Arguments arguments{"render", "--session", folder.file("s.json"), "-o"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  const std::string layers = said({folder.file("p.exr")});
  EXPECT_NE(layers.find("Variance (VSM) · radius 9, the active one of the 2 that"),
            std::string::npos)
      << layers;
  EXPECT_EQ(layers.find("an EXR has"), layers.rfind("an EXR has"));
  for (const Arguments& more :
       {Arguments{folder.file("p.png")}, Arguments{folder.file("p.exr"), "--technique", "vsm"}})
    EXPECT_EQ(said(more).find("an EXR has"), std::string::npos);
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
