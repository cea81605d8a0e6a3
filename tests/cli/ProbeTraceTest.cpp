// `probe --trace`: the steps of every technique, on the command line.
#include <gtest/gtest.h>

#include <set>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

class ProbeTrace : public testing::Test {
 protected:
  ProbeTrace() { writeMap(file, smallMap()); }

  Arguments probe(const Arguments& more) const {
    Arguments arguments{"probe", "--depth", file, "--texel", "8,9", "--receiver", "0.66"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  TemporaryFolder folder;
  const std::string file = folder.file("m.exr");
};

TEST_F(ProbeTrace, EndsInTheVisibilityAndAccountsForTheError) {
  const Json object = run(probe({"--json", "--trace", "--technique", "all"})).json();
  ASSERT_GE(object["techniques"].size(), 11u);
  for (const Json& row : object["techniques"]) {
    SCOPED_TRACE(row["name"]);
    const Json& trace = row["trace"];
    ASSERT_FALSE(trace["steps"].empty());
    for (const Json& step : trace["steps"])
      for (const char* key : {"symbol", "meaning", "formula", "value"})
        ASSERT_TRUE(step.contains(key)) << key;
    EXPECT_EQ(trace["steps"].back()["value"], row["visibility"]);
    double sum = 0.0;
    for (const Json& share : trace["shares"]) sum += share["amount"].get<double>();
    // Differences of numbers up to 1.
    EXPECT_NEAR(sum, row["error"].get<double>(), 1e-14);
    EXPECT_EQ(trace["cause"] == "none", trace["step"].is_null());
    EXPECT_FALSE(trace["sentence"].get<std::string>().empty());
  }
}

TEST_F(ProbeTrace, IsThereForTheAskingOnly) {
  const Json object = run(probe({"--json", "--technique", "vsm"})).json();
  EXPECT_FALSE(object["techniques"][0].contains("trace"));
}

TEST_F(ProbeTrace, IsReadByPeopleToo) {
  const Json object = run(probe({"--json", "--trace", "--technique", "vsm"})).json();
  const std::string sentence = object["techniques"][0]["trace"]["sentence"];
  const std::string text = run(probe({"--trace", "--technique", "vsm"})).out;
  EXPECT_NE(text.find(sentence), std::string::npos) << text;
  EXPECT_NE(text.find("p_max"), std::string::npos) << text;
  EXPECT_EQ(run(probe({"--technique", "vsm"})).out.find("p_max"), std::string::npos);
}

}  // namespace
}  // namespace umbra::cli
