// Lessons on the command line: their claims are measured, and exported lessons stand alone.
#include <gtest/gtest.h>

#include <fstream>

#include "datasets/lessons/LessonCatalogue.h"
#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

std::vector<std::string> lessonNames() {
  std::vector<std::string> names;
  for (const Lesson& lesson : lessonCatalogue()) names.push_back(lesson.name);
  return names;
}

class LessonClaims : public testing::TestWithParam<std::string> {};

// This loads, renders and probes every step.
TEST_P(LessonClaims, HoldWhenTheyAreComputed) {
  const Outcome outcome = run({"lesson", "check", GetParam(), "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const Json report = outcome.json();
  EXPECT_EQ(report["format"], "umbrascope-lesson-check/1");
  EXPECT_TRUE(report["holds"]);
  const std::size_t shapes = report["shapes"].size();
  EXPECT_EQ(shapes, 4u);
  ASSERT_EQ(report["lessons"].size(), 1u);
  EXPECT_EQ(report["lessons"][0]["name"], GetParam());
  const Lesson lesson = lessonNamed(GetParam());
  const Json& steps = report["lessons"][0]["steps"];
  ASSERT_EQ(steps.size(), lesson.steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    EXPECT_EQ(steps[i]["step"], i + 1);
    EXPECT_EQ(steps[i]["claims"].size(), shapes * (step.claims.size() + (step.question ? 1 : 0)));
    for (const Json& claim : steps[i]["claims"]) EXPECT_TRUE(claim["holds"]) << claim.dump();
  }
}

INSTANTIATE_TEST_SUITE_P(Every, LessonClaims, testing::ValuesIn(lessonNames()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

TEST(Lesson, ListAndShowNeedNoDisplayLibrary) {
  const Json list = run({"lesson", "list", "--json"}).json()["lessons"];
  ASSERT_EQ(list.size(), lessonNames().size());
  for (const Json& lesson : list) {
    EXPECT_FALSE(lesson["title"].get<std::string>().empty());
    const Outcome text =
        run({"lesson", "show", lesson["name"]}, {.environment = {{"LD_DEBUG", "files"}}});
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find(lesson["title"].get<std::string>()), std::string::npos);
    EXPECT_EQ(text.err.find("libQt"), std::string::npos);
    EXPECT_EQ(text.out.find("**"), std::string::npos) << "marks are taken out";
  }
}

std::size_t countOf(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

TEST(Lesson, ExportStandsAlone) {
  const TemporaryFolder folder;
  const std::string out = folder.file("new/folder");
  const Outcome outcome = run({"lesson", "export", "light-bleeding", "-o", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const Lesson lesson = lessonNamed("light-bleeding");
  const std::string page = contentOf(std::filesystem::path(out) / "light-bleeding.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_EQ(countOf(page, "<section>"), lesson.steps.size());
  EXPECT_EQ(countOf(page, "src=\"data:image/png;base64,iVBORw0KGgo"), lesson.steps.size());
  EXPECT_EQ(countOf(page, "<svg"), 2 * lesson.steps.size());
  EXPECT_EQ(countOf(page, "<?xml"), 0u);
  EXPECT_EQ(countOf(page, "<details>"), 2u);
  EXPECT_EQ(countOf(page, "<details>"), countOf(page, "</details>"));
  EXPECT_NE(page.find("v = ¼Δx² / (½Δx² + ΔxΔy + Δy²)"), std::string::npos);
  // Nothing is fetched from elsewhere.
  for (const char* attribute : {"src=\"http", "href=\"http", "url(http", "<script", "<link"})
    EXPECT_EQ(countOf(page, attribute), 0u) << attribute;
}

TEST(Lesson, ATeachersOwnFileIsCheckedAndItsErrorsNameTheKey) {
  const TemporaryFolder folder;
  const std::string file = folder.file("own.json");
  const auto write = [&](const char* technique, const char* value) {
    std::ofstream(file)
        << R"({"format": "umbrascope-lesson/1", "name": "own", "title": "Own", "summary": "S",
               "steps": [{"title": "T", "text": "Text", "at": {"world": [0, 0, 0.9]}, "session": {
                 "format": "umbrascope-session/1", "source": {"scene": "two-planes"},
                 "technique": ")"
        << technique << R"(", "size": [160, 90]},
               "claims": [{"text": "C", "quantity": "channels", "relation": "≈", "value": )"
        << value << R"(, "tolerance": 0}]}]})";
  };
  write("vsm", "2");
  EXPECT_EQ(run({"lesson", "check", file}).status, 0);
  write("vsm", "3");
  const Outcome wrong = run({"lesson", "check", file});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("lesson own: 1 of its claims do not hold"), std::string::npos);
  write("vms", "2");
  const Outcome bad = run({"lesson", "show", file});
  EXPECT_EQ(bad.status, 3);
  EXPECT_NE(bad.err.find(file + ": steps[1].session.technique"), std::string::npos) << bad.err;
  EXPECT_EQ(run({"lesson", "show", "nothing"}).status, 3);
  EXPECT_EQ(run({"lesson"}).status, 2);
}

}  // namespace
}  // namespace umbra::cli
