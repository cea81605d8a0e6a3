#include "datasets/session/file/SessionSchema.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "datasets/json/JsonText.h"
#include "datasets/lessons/LessonCatalogue.h"
#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/SchemaCheck.h"
#include "datasets/session/file/SessionFileCheck.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

std::string faultOf(const Workspace& workspace) {
  return schemaFault(sessionSchema(), toJson(workspace), "session");
}

TEST(SessionSchema, TakesWhatIsWritten) {
  EXPECT_EQ(faultOf(Workspace{}), "");
  EXPECT_EQ(faultOf(unusualWorkspace()), "");
  Workspace depth;
  depth.shared.source = {SourceKind::DepthFile, "m.exr", "Z", -1.5, 40.0, {}};
  depth.shared.probes = {{"a", {}, Pixel{0, 16383}, {}}};
  EXPECT_EQ(faultOf(depth), "");
  depth.shared.source = {SourceKind::MeshFile, "fan.ply", "", 0.0, 1.0, {}};
  depth.shared.probes.clear();
  EXPECT_EQ(faultOf(depth), "");
}

TEST(SessionSchema, TakesTheLessonsSessions) {
  std::size_t count = 0;
  for (const Lesson& lesson : lessonCatalogue())
    for (const LessonStep& step : lesson.steps) {
      EXPECT_EQ(faultOf(step.workspace), "") << lesson.name;
      ++count;
    }
  EXPECT_GT(count, 20u);
}

TEST(SessionSchema, TakesTheExamplesWhichAreRead) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(UMBRASCOPE_EXAMPLES)) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = textOf(entry.path());
    EXPECT_EQ(schemaFault(sessionSchema(), jsonFromText(text, "example"), "example"), "")
        << entry.path();
    EXPECT_NO_THROW(readWorkspace(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0u);
}

// Its ranges are those that reading checks.
TEST(SessionSchema, RefusesWhatReadingRefuses) {
  for (const char* members :
       {R"("frame": {"kernel": {"radius": 65}})", R"("frame": {"kernel": {"radius": 1.5}})",
        R"("frame": {"kernel": {"radios": 2}})", R"("frame": {"kernel": {"sigma": 0.009}})",
        R"("frame": {"msaa": 3})", R"("frame": {"format": "hafl"})",
        R"("frame": {"bias": {"receiverPlane": "on"}})", R"("frame": {"view": "pretty"})",
        R"("frame": {"cascades": {"frozen": {"viewAngle": 121}}})",
        R"("light": {"colour": [1, -1, 1]})", R"("light": {"position": [1, 2]})",
        R"("camera": {"viewAngle": 121})", R"("size": [15, 200])", R"("technique": "vsn")",
        R"("parameters": {"vsm": {"bleed-reduction": 1.5}})", R"("receiver": 1.5)",
        R"("source": {"scene": "a", "mesh": "b"})", R"("compare": {"mode": "half"})",
        R"("compare": {"panes": [{"technique": "vsm"}, {"technique": "vsm", "view": "error"}]})"}) {
    const std::string text = sessionWith(members);
    EXPECT_NE(schemaFault(sessionSchema(), jsonFromText(text, "s"), "s"), "") << text;
    EXPECT_NE(sessionErrorOf(text), "no error") << text;
  }
  for (const char* members : {R"("frame": {"kernel": {"sigma": 0}})", R"("frame": {"msaa": 8})",
                              R"("light": {"kind": "spot"})"}) {
    const std::string text = sessionWith(members);
    EXPECT_EQ(schemaFault(sessionSchema(), jsonFromText(text, "s"), "s"), "") << text;
    EXPECT_EQ(sessionErrorOf(text), "no error") << text;
  }
}

// A session's file takes what the table says, and no more.
TEST(SessionSchema, KeysTakeTheRangesOfTheTable) {
  Session session;
  for (const Setting& setting : settingsOf(session)) {
    const SettingInfo& info = setting.info;
    if (info.kind != SettingKind::Whole && info.kind != SettingKind::Number) continue;
    const auto with = [&](double value) {
      std::string text =
          info.kind == SettingKind::Whole ? std::to_string(int(value)) : Json(value).dump();
      std::vector<std::string> parts = split(info.key, '.');
      for (; parts.size() > 1; parts.pop_back()) text = "{\"" + parts.back() + "\": " + text + "}";
      return sessionWith("\"" + parts.front() + "\": " + text);
    };
    for (const double end : {info.low, info.high})
      EXPECT_EQ(sessionErrorOf(with(end)), "no error") << with(end);
    const double step = info.kind == SettingKind::Whole ? 1.0 : 1e-3 * info.high;
    EXPECT_EQ(sessionErrorOf(with(info.high + step)),
              "s.json: " + std::string(info.key) + ": " +
                  (info.kind == SettingKind::Whole ? std::to_string(int(info.high + step))
                                                   : Json(info.high + step).dump()) +
                  " is not right, it takes " + rightValues(info));
  }
}

}  // namespace
}  // namespace umbra
