// The picture on every technique's page equals the output of the command below it.
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <set>
#include <sstream>

#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/core/technique/TechniquePage.h"
#include "tests/cli/PictureDifference.h"
#include "tests/cli/Process.h"

namespace umbra::cli {
namespace {

constexpr const char* program = "umbrascope ";

// The arguments of the command that the page gives for its picture: an indented line.
Arguments commandOf(std::string_view page) {
  std::istringstream lines{std::string(page)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(std::string("    ") + program)) continue;
    std::istringstream words(line.substr(4 + std::string(program).size()));
    return {std::istream_iterator<std::string>(words), {}};
  }
  return {};
}

// Families share a page.
std::vector<std::string> pages() {
  std::set<std::string> pages;
  const TechniqueCatalogue catalogue = allTechniques();
  for (const Technique* technique : catalogue.all()) pages.emplace(technique->page());
  return {pages.begin(), pages.end()};
}

class PagePicture : public testing::TestWithParam<std::string> {};

TEST_P(PagePicture, IsDrawnByItsCommand) {
  const std::vector<std::string> names = pictureNames(GetParam());
  ASSERT_EQ(names.size(), 1u);
  const std::span<const unsigned char> bytes = pagePicture(names.front());
  const QImage shown = QImage::fromData(bytes.data(), int(bytes.size()), "PNG")
                           .convertToFormat(QImage::Format_RGB888);
  ASSERT_FALSE(shown.isNull()) << names.front();

  Arguments arguments = commandOf(GetParam());
  ASSERT_GT(arguments.size(), 2u) << "the page has no command for its picture";
  ASSERT_EQ(arguments.back(), names.front()) << "the command writes another file";
  const TemporaryFolder folder;
  arguments.back() = folder.file("picture.png");
  const Outcome outcome = run(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const QImage drawn = readPicture(arguments.back());
  ASSERT_EQ(drawn.size(), shown.size());
  const Difference difference = differenceOf(drawn, shown);
  EXPECT_TRUE(difference.within(1.0)) << difference;
}

std::string nameOfPage(const testing::TestParamInfo<std::string>& page) {
  std::string name = pictureNames(page.param).empty() ? "none" : pictureNames(page.param).front();
  return name.substr(0, name.find('.'));
}

INSTANTIATE_TEST_SUITE_P(Pages, PagePicture, testing::ValuesIn(pages()), nameOfPage);

TEST(TechniquesCommand, PrintsAPageWithItsParameters) {
  const Outcome outcome = run({"techniques", "lvsm"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("| `lvsm.placement` |"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("uniform\\|manual\\|lloyd"), std::string::npos);
  EXPECT_LT(outcome.out.find("**Parameters**"), outcome.out.find("Source:"));
}

TEST(TechniquesCommand, RefusesAnUnknownPage) {
  EXPECT_EQ(run({"techniques", ""}).status, 2);
  const Outcome outcome = run({"techniques", "vsn"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("vsn"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace umbra::cli
