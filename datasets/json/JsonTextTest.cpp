#include "datasets/json/JsonText.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

std::string nested(std::size_t levels) {
  return std::string(levels, '[') + std::string(levels, ']');
}

std::string refusalOf(const std::string& text) {
  try {
    workspaceFromText(text, "s.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    return error.what();
  }
  return "accepted";
}

TEST(JsonText, ReadsToALimitOfLevels) {
  EXPECT_NO_THROW(jsonFromText(nested(64), "deep.json"));
  for (const std::size_t levels : {65, 100000}) {
    try {
      jsonFromText(nested(levels), "deep.json");
      ADD_FAILURE() << levels << " levels were read";
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "deep.json: is nested more than 64 levels deep");
    }
  }
}

TEST(JsonText, QuotesTheBeginningOfALongValue) {
  EXPECT_EQ(quoted(Json("short")), "\"short\"");
  EXPECT_EQ(quoted(Json(std::string(1000, 'x'))), '"' + std::string(79, 'x') + "…");
  // Two bytes each, of which 80 bytes would cut the last in half.
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "ä";
  EXPECT_EQ(quoted(Json(umlauts)).size(), 1 + 2 * 39 + std::string("…").size());
  EXPECT_LT(quoted(Json(std::vector<int>(1000, 1))).size(), 90u);
}

// Whatever of a file a message quotes, it stays a line that can be read.
TEST(JsonText, KeepsMessagesShort) {
  const std::string longText(100000, 'x');
  for (const std::string& text :
       {R"({"format": "umbrascope-session/1", ")" + longText + R"(": 1})",
        R"({"format": "umbrascope-session/1", "technique": ")" + longText + R"("})",
        R"({"format": "umbrascope-session/1", "frame": ")" + longText + R"("})",
        R"({"format": ")" + longText + R"("})",
        R"({"format": "umbrascope-session/1", "parameters": {")" + longText + R"(": {}}})",
        R"({"format": "umbrascope-session/1", "parameters": {"vsm": {")" + longText + R"(": 1}}})",
        R"({"format": "umbrascope-session/1", "frame": {"view": ")" + longText + R"("}})"}) {
    const std::string refusal = refusalOf(text);
    EXPECT_NE(refusal, "accepted");
    EXPECT_LT(refusal.size(), 400u) << refusal.substr(0, 200);
  }
}

}  // namespace
}  // namespace umbra
