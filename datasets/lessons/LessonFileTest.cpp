// Lessons as files: which are read, and which are refused with file and key.
#include "datasets/lessons/LessonFile.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "datasets/lessons/LessonCatalogue.h"
#include "datasets/lessons/LessonNumbers.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

Json session() {
  return {{"format", "umbrascope-session/1"},
          {"source", {{"scene", "two-planes"}}},
          {"technique", "vsm"},
          {"size", {320, 180}}};
}

Json sample() {
  const Json question{{"text", "How bright?"},
                      {"quantity", "visibility"},
                      {"tolerance", 0.1},
                      {"explanation", {"First line", "second line"}}};
  const Json claim{{"text", "Less than at first"},
                   {"quantity", "rmse"},
                   {"relation", "<"},
                   {"than", {{"quantity", "rmse"}, {"technique", "pcf"}, {"step", 1}}}};
  const Json at{{"world", {1.5, 0, -2}}};
  const Json first{{"title", "One"}, {"text", "Text"}, {"at", at}, {"session", session()}};
  const Json second{{"title", "Two"},
                    {"text", {"a", "", "    f = {{variance}}"}},
                    {"look", "there"},
                    {"at", at},
                    {"session", session()},
                    {"question", question},
                    {"claims", Json::array({claim})}};
  return {{"format", "umbrascope-lesson/1"}, {"name", "sample"},  {"title", "Sample"},
          {"summary", "What it is about"},   {"after", "Nobody"}, {"steps", {first, second}}};
}

std::string refusalOf(const Json& json) {
  try {
    lessonFromText(json.dump(), "sample.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    return error.what();
  }
  return "accepted";
}

TEST(LessonFile, ReadsEveryKey) {
  const Lesson lesson = lessonFromText(sample().dump(), "sample.json");
  EXPECT_EQ(lesson.name, "sample");
  EXPECT_EQ(lesson.after, "Nobody");
  ASSERT_EQ(lesson.steps.size(), 2u);
  EXPECT_FALSE(lesson.steps[0].question);
  const LessonStep& step = lesson.steps[1];
  EXPECT_EQ(step.text, "a\n\n    f = {{variance}}");
  EXPECT_EQ(step.at, Eigen::Vector3d(1.5, 0, -2));
  EXPECT_EQ(probeNamed(step.session.probes, step.session.keptProbe)->point, step.at);
  ASSERT_TRUE(step.question);
  EXPECT_EQ(step.question->asked, (LessonQuantity{Quantity::Visibility, "vsm", 1}));
  EXPECT_EQ(step.question->explanation, "First line\nsecond line");
  ASSERT_EQ(step.claims.size(), 1u);
  EXPECT_EQ(step.claims[0].right, (LessonQuantity{Quantity::Rmse, "pcf", 0}));
}

TEST(LessonNumbers, AreFilledInAsFarAsTheyAreKnown) {
  const Lesson lesson = lessonFromText(sample().dump(), "sample.json");
  const auto shown = [&](std::string_view text) {
    return filled(text, lesson.steps[1], 1, [](const LessonQuantity& quantity) {
      if (quantity.technique == "msm") return std::optional<double>();
      return std::optional(quantity.quantity == Quantity::Mean ? 0.25 : -1.25e-6);
    });
  };
  EXPECT_EQ(shown("no number"), "no number");
  EXPECT_EQ(shown("{{mean}} and {{ error vsm }}."), "0.25 and −1.25·10⁻⁶.");
  EXPECT_EQ(shown("{{mean - mean}}{{mean - variance}}"), "00.25");
  EXPECT_EQ(shown("e^{c·{{error msm}}}"), "e^{c·…}");
  EXPECT_EQ(quantitiesIn("{{mean}} {{error msm}}", "vsm", 1, ""),
            (std::vector<LessonQuantity>{{Quantity::Mean, "vsm", 1}, {Quantity::Error, "msm", 1}}));
}

// A hand-out's file is called by the name: one that is a path would lie elsewhere.
TEST(LessonFile, TakesNamesThatAreNoPaths) {
  for (const std::string name : {"../../escaped", "/tmp/x", "a/b", "..", "a.b", "ä", "a b"}) {
    Json json = sample();
    json["name"] = name;
    const std::string refusal = refusalOf(json);
    EXPECT_TRUE(refusal.starts_with("sample.json.name: '" + name + "' is not right")) << refusal;
  }
  Json json = sample();
  json["name"] = std::string(61, 'x');
  EXPECT_NE(refusalOf(json), "accepted");
  json["name"] = "09_Power-CDF";
  EXPECT_EQ(refusalOf(json), "accepted");
}

TEST(LessonFile, NamesFileAndKeyOfWhatIsWrong) {
  const auto with = [](const char* pointer, const Json& value) {
    Json json = sample();
    json[Json::json_pointer(pointer)] = value;
    return refusalOf(json);
  };
  const auto without = [](const char* parent, const char* key) {
    Json json = sample();
    json[Json::json_pointer(parent)].erase(key);
    return refusalOf(json);
  };
  const std::pair<std::string, const char*> cases[] = {
      {with("/format", "other"), "sample.json: is no lesson"},
      {with("/steps", Json::array()), "sample.json: needs at least one of 'steps'"},
      {with("/steps", 3), "sample.json: steps"},
      {with("/titel", "x"), "sample.json: titel"},
      {with("/steps/1/texts", "x"), "sample.json: steps[2].texts"},
      {with("/steps/1/text", Json::array({1})), "sample.json: steps[2].text"},
      {with("/steps/1/session/technique", "vms"), "sample.json: steps[2].session.technique"},
      {with("/steps/1/session/probe", Json{160, 90}),
       "sample.json: steps[2].session.probe: a pixel"},
      {with("/steps/1/at", Json{{"pixel", {1, 2}}}), "sample.json: steps[2].at.pixel"},
      {with("/steps/1/look", "{{varianse}}"), "sample.json: steps[2]: there is no quantity"},
      {with("/steps/1/look", "{{error vms}}"), "sample.json: steps[2]"},
      {with("/steps/1/look", "{{rmse}}"), "sample.json: steps[2]: 'rmse' is of the whole frame"},
      {with("/steps/1/look", "{{mean"), "sample.json: steps[2]: '{{' has no"},
      {with("/steps/1/question/text", "{{visibility}}?"), "sample.json: steps[2].question.text"},
      {with("/steps/1/session/source", Json{{"depth", "m.exr"}}),
       "sample.json: steps[2].session.source"},
      {without("/steps/1", "at"), "sample.json: steps[2]: needs an 'at'"},
      {without("/steps/1", "session"), "sample.json: steps[2]: needs a 'session'"},
      {with("/steps/1/question/quantity", "light"), "sample.json: steps[2].question.quantity"},
      {with("/steps/1/question/quantity", "rmse"), "sample.json: steps[2].question.quantity"},
      {with("/steps/1/question/low", 1), "sample.json: steps[2].question.high"},
      {without("/steps/1/question", "tolerance"), "sample.json: steps[2].question: needs"},
      {with("/steps/1/claims/0/relation", "="), "sample.json: steps[2].claims[1].relation"},
      {with("/steps/1/claims/0/relation", "≈"), "sample.json: steps[2].claims[1]: a 'tolerance'"},
      {with("/steps/1/claims/0/value", 1), "sample.json: steps[2].claims[1]: needs exactly one"},
      {with("/steps/1/claims/0/than/step", 3), "sample.json: steps[2].claims[1].than.step"}};
  for (const auto& [refusal, beginning] : cases)
    EXPECT_TRUE(refusal.starts_with(beginning)) << refusal << "\nshould begin with " << beginning;
  EXPECT_THROW(lessonFromText("{\"format\": ", "broken.json"), Error);
}

TEST(LessonFile, MeshesAreRelativeToTheFile) {
  const TemporaryFolder folder;
  const auto file = folder / "own.json";
  Json json = sample();
  json["steps"][0]["session"]["source"] = {{"mesh", "models/fan.ply"}};
  std::ofstream(file) << json.dump();
  EXPECT_TRUE(looksLikeLesson(file));
  EXPECT_EQ(lessonNamed(file.string()).steps[0].session.source.name,
            (folder / "models/fan.ply").string());
  std::ofstream(file) << session().dump();
  EXPECT_FALSE(looksLikeLesson(file));
}

TEST(LessonCatalogue, HasNineteenLessonsThatAskAndClaim) {
  std::set<std::string> names;
  for (const Lesson& lesson : lessonCatalogue()) {
    names.insert(lesson.name);
    EXPECT_GE(lesson.steps.size(), 3u) << lesson.name;
    EXPECT_LE(lesson.steps.size(), 6u) << lesson.name;
    EXPECT_FALSE(lesson.after.empty()) << lesson.name;
    bool asks = false;
    for (const LessonStep& step : lesson.steps) {
      asks = asks || step.question;
      EXPECT_FALSE(step.claims.empty()) << lesson.name << ": " << step.title;
    }
    EXPECT_TRUE(asks) << lesson.name;
  }
  EXPECT_EQ(names.size(), 19u);
}

TEST(LessonCatalogue, SuggestsTheNearestName) {
  try {
    lessonNamed("light-bleding");
    FAIL() << "there is no such lesson";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'light-bleeding'"), std::string::npos);
  }
}

TEST(Lesson, AClaimHoldsWithinItsTolerance) {
  LessonClaim claim;
  claim.relation = Relation::Near;
  claim.tolerance = 0.25;
  EXPECT_TRUE(holds(claim, 1.0, 1.25));
  EXPECT_FALSE(holds(claim, 1.0, 1.5));
  claim.relation = Relation::Less;
  EXPECT_TRUE(holds(claim, 1.0, 1.5));
  EXPECT_FALSE(holds(claim, 1.0, 1.0));
  claim.relation = Relation::Greater;
  EXPECT_FALSE(holds(claim, 1.0, 1.0));
}

}  // namespace
}  // namespace umbra
