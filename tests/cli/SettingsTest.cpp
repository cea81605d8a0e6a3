// The command line lists the table of settings, and takes its ranges.
#include <gtest/gtest.h>

#include <fstream>

#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/SchemaCheck.h"
#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

TEST(Settings, ListsEveryRowOfTheTables) {
  const Json list = run({"settings", "--json"}).json()["settings"];
  Session session;
  const std::vector<umbra::Setting> settings = settingsOf(session);
  ASSERT_EQ(list.size(), settings.size());
  for (std::size_t i = 0; i < settings.size(); ++i) {
    EXPECT_EQ(list[i]["name"], settings[i].info.name);
    for (const char* field :
         {"key", "symbol", "unit", "range", "default", "choices", "doc", "stage"})
      EXPECT_TRUE(list[i].contains(field)) << list[i]["name"] << " " << field;
  }
  const auto radius = std::find_if(list.begin(), list.end(), [](const Json& setting) {
    return setting["name"] == "kernel.radius";
  });
  ASSERT_NE(radius, list.end());
  EXPECT_EQ((*radius)["option"], "--radius");
  EXPECT_EQ((*radius)["key"], "frame.kernel.radius");
  EXPECT_EQ((*radius)["range"], Json::array({0.0, 64.0}));
  EXPECT_EQ((*radius)["default"], 3);
  EXPECT_EQ((*radius)["unit"], "texels");
  EXPECT_EQ((*radius)["stage"], "prefilter");
  const Outcome table = run({"settings"});
  for (const umbra::Setting& setting : settings)
    EXPECT_NE(table.out.find("\n" + std::string(setting.info.name) + " "), std::string::npos);
}

TEST(Settings, HelpHasEveryOptionWithItsDefault) {
  const std::string help = run({"render", "--help"}).out;
  Session session;
  std::string words;  // of the help, in one line
  for (char c : help)
    if (c != '\n' && (c != ' ' || words.empty() || words.back() != ' '))
      words += c;
    else if (words.empty() || words.back() != ' ')
      words += ' ';
  for (const umbra::Setting& setting : settingsOf(session)) {
    const SettingInfo& info = setting.info;
    if (info.takes.empty()) continue;
    const std::size_t at = words.find(" " + std::string(info.option) + " ");
    ASSERT_NE(at, std::string::npos) << info.option;
    const std::string doc(info.doc);
    const std::size_t text = words.find(doc, at);
    ASSERT_NE(text, std::string::npos) << info.option;
    const std::string value =
        isOfScene(info) ? "the scene's" : defaultText(info, setting.defaultValue);
    const std::size_t end = words.find(" --", text);
    const std::string range = rangeText(info);
    const std::string facts = "(" + range + (range.empty() ? "" : "; ") + "default " + value + ")";
    EXPECT_LT(words.find(facts, text), end) << info.option;
  }
}

// The range and the sentence are the same as in a session's file.
TEST(Settings, OptionsTakeTheRangesOfTheTable) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  const auto probe = [&](std::string_view option, const std::string& value) {
    return run({"probe", "--json", "--depth", folder.file("m.exr"), "--texel", "8,9", "--receiver",
                "0.7", "--technique", "hard", std::string(option), value});
  };
  Session session;
  for (const umbra::Setting& setting : settingsOf(session)) {
    const SettingInfo& info = setting.info;
    const bool whole = info.kind == SettingKind::Whole;
    if (isOfScene(info) || (!whole && info.kind != SettingKind::Number)) continue;
    const auto text = [&](double value) {
      return whole ? toText(info, int(value)) : toText(info, value);
    };
    for (const double end : {info.low, info.high})
      EXPECT_EQ(probe(info.option, text(end)).status, 0) << info.option << " " << text(end);
    const std::string beyond = text(info.high + (whole ? 1.0 : 1e-3 * info.high));
    const Outcome refused = probe(info.option, beyond);
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err, "umbrascope: " + std::string(info.option) + ": '" + beyond +
                               "' is not right, it takes " + rightValues(info) + "\n");
  }
}

TEST(Settings, TheSchemaIsPrinted) {
  const Outcome outcome = run({"settings", "--schema"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const OrderedJson schema = OrderedJson::parse(outcome.out);
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(
      schema["properties"]["frame"]["properties"]["kernel"]["properties"]["radius"]["maximum"], 64);
  EXPECT_EQ(run({"settings", "--schema", "--json"}).status, 2);
}

}  // namespace
}  // namespace umbra::cli
