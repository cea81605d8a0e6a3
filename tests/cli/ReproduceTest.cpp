// The papers' figures: measured anew, with computed verdicts, on a page that stands alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

class Reproduce : public testing::Test {
 protected:
  Outcome reproduce(const Arguments& names, const Setting& setting = {}) const {
    Arguments arguments{"reproduce", "-o", out};
    arguments.insert(arguments.end(), names.begin(), names.end());
    return run(arguments, setting);
  }
  std::string written(const char* name) const {
    return contentOf(std::filesystem::path(out) / name);
  }

  TemporaryFolder folder;
  const std::string out = folder.file("out");
};

TEST_F(Reproduce, WritesTheReportAndItsPictures) {
  const Outcome outcome = reproduce({"kim-light-bleeding", "annen-memory"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const Json report = Json::parse(written("report.json"));
  EXPECT_EQ(report["format"], "umbrascope-report/1");
  ASSERT_EQ(report["figures"].size(), 2u);
  EXPECT_EQ(report["figures"][0]["name"], "kim-light-bleeding");
  EXPECT_EQ(report["figures"][1]["name"], "annen-memory");
  for (const Json& figure : report["figures"]) {
    EXPECT_FALSE(figure["claims"].empty());
    for (const Json& claim : figure["claims"]) {
      EXPECT_FALSE(claim["text"].get<std::string>().empty());
      EXPECT_TRUE(claim["measured"].is_number()) << claim.dump();
      EXPECT_TRUE(claim["stated"].is_number());
      const Json verdict = claim["verdict"];
      EXPECT_TRUE(verdict == "holds" || verdict == "partly" || verdict == "fails") << verdict;
    }
    for (const Json& cell : figure["cells"]) {
      if (!cell.contains("picture")) continue;
      EXPECT_TRUE(written(cell["picture"].get<std::string>().c_str()).starts_with("\x89PNG"));
    }
  }
  const Json& memory = report["figures"][1]["claims"][0];
  EXPECT_EQ(memory["measured"], 4.0) << "32 channels of a byte over two of four bytes";
  EXPECT_EQ(memory["verdict"], "holds");
}

// What is claimed is divided here once more, of figures that `compare` gives.
TEST_F(Reproduce, MeasuresWhatCompareMeasures) {
  const Outcome outcome = reproduce({"kim-light-bleeding", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto umbraBleeding = [](const Arguments& more) {
    Arguments arguments{"compare", "--json",     "--scene", "three-planes", "--size",
                        "480x270", "--map-size", "512",     "--technique",  "vsm"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments).json()["techniques"][0]["umbraBleeding"].get<double>();
  };
  const Json claim = outcome.json()["figures"][0]["claims"][1];
  EXPECT_EQ(claim["relation"], "<");
  EXPECT_NEAR(claim["measured"],
              umbraBleeding({"--set", "vsm.bleed-reduction=0.18"}) / umbraBleeding({}), 1e-9);
}

TEST_F(Reproduce, ThePageNeedsNothingBesideItself) {
  ASSERT_EQ(reproduce({"kim-light-bleeding"}).status, 0);
  const std::string page = written("report.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page.find("src=\"data:image/png;base64,"), std::string::npos);
  for (const char* outside : {"http:", "https:", "<link", "<script", "url(", "@import"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  for (std::size_t at = page.find("src=\""); at != std::string::npos;
       at = page.find("src=\"", at + 1))
    EXPECT_EQ(page.compare(at + 5, 5, "data:"), 0);
  for (std::size_t at = page.find("href=\""); at != std::string::npos;
       at = page.find("href=\"", at + 1))
    EXPECT_EQ(page[at + 6], '#');
  EXPECT_NE(page.find("umbrascope reproduce kim-light-bleeding"), std::string::npos);
}

TEST_F(Reproduce, ListsFiguresAndWhatIsLeftOut) {
  const Json list = run({"reproduce", "--list", "--json"}).json();
  const auto has = [&](const char* key, const char* name) {
    return std::any_of(list[key].begin(), list[key].end(),
                       [&](const Json& figure) { return figure["name"] == name; });
  };
  EXPECT_TRUE(has("figures", "lauritzen-4.5"));
  EXPECT_TRUE(has("leftOut", "lauritzen-2.1"));
  for (const Json& figure : list["leftOut"])
    EXPECT_FALSE(figure["reason"].get<std::string>().empty()) << figure["name"];
  const Outcome text = run({"reproduce", "--list"});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("gumbau-table-1"), std::string::npos);
  EXPECT_NE(text.out.find("LEFT OUT"), std::string::npos);
}

TEST_F(Reproduce, TakesSomebodysOwnFigure) {
  const std::string file = folder.file("mine.json");
  std::ofstream(file) << R"({"format": "umbrascope-figure/1", "name": "mine", "paper": "Me",
    "number": "1", "title": "Bound", "states": "PCF <is> exact",
    "base": {"source": {"scene": "two-planes"}, "size": [64, 36], "frame": {"mapSize": 64}},
    "cells": [{"name": "pcf", "set": {"technique": "pcf"}}], "measures": ["compare", "picture"],
    "claims": [{"text": "Wrongly stated", "cell": "pcf", "measure": "rmse", "relation": ">",
                "stated": 0.5}]})";
  const Outcome outcome = reproduce({file, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json claim = outcome.json()["figures"][0]["claims"][0];
  EXPECT_EQ(claim["measured"], 0.0);
  EXPECT_EQ(claim["verdict"], "fails");
  EXPECT_NE(written("report.html").find("PCF &lt;is&gt; exact"), std::string::npos);
  EXPECT_NE(written("report.html").find("umbrascope reproduce " + file), std::string::npos);
  EXPECT_TRUE(written("mine-pcf.png").starts_with("\x89PNG"));
}

TEST_F(Reproduce, RefusesWhatItCannotDo) {
  const auto refused = [&](const Arguments& arguments, int status, const char* why) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  };
  refused({"reproduce", "lauritzen-4.55", "-o", out}, 2, "did you mean 'lauritzen-4.5'?");
  refused({"reproduce", "lauritzen-2.1", "-o", out}, 2, "is left out");
  refused({"reproduce"}, 2, "give -o DIR");
  refused({"reproduce", folder.file("none.json"), "-o", out}, 3, "none.json");
  EXPECT_TRUE(folder.names().empty());
}

TEST_F(Reproduce, AnInterruptLeavesNothingBehind) {
  const Outcome outcome = reproduce({"kim-satvsm"}, {.interrupt = true});
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace umbra::cli
