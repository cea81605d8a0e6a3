// Sessions that compare techniques, drawn without a display.
#include <gtest/gtest.h>

#include <QImage>
#include <fstream>

#include "tests/cli/PictureDifference.h"
#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

constexpr int width = 160, height = 120;

// A session in a file, rendered with these options.
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
  // Whichever of them is the active one.
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

}  // namespace
}  // namespace umbra::cli
