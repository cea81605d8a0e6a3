#include "filters/core/support/Text.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

using Parts = std::vector<std::string>;

TEST(ShortNumber, HasFourDigitsAndNoIdleZeros) {
  EXPECT_EQ(shortNumber(0.22637), "0.2264");
  EXPECT_EQ(shortNumber(1e-6), "1e-06");
  EXPECT_EQ(shortNumber(12.0), "12");
  EXPECT_EQ(shortNumber(-0.5), "-0.5");
  EXPECT_EQ(shortNumber(0.0), "0");
}

TEST(Joined, PutsTheSeparatorBetween) {
  EXPECT_EQ(joined(Parts{}), "");
  EXPECT_EQ(joined(Parts{"a"}), "a");
  EXPECT_EQ(joined(Parts{"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(joined(Parts{"a", "b"}, ":"), "a:b");
}

TEST(Split, TakesPartsBetweenSeparators) {
  EXPECT_EQ(split("", ':'), Parts{});
  EXPECT_EQ(split("a", ':'), Parts{"a"});
  EXPECT_EQ(split("a:b:c", ':'), (Parts{"a", "b", "c"}));
  EXPECT_EQ(split("a::c", ':'), (Parts{"a", "", "c"}));
  EXPECT_EQ(split(":a", ':'), (Parts{"", "a"}));
  EXPECT_EQ(split("a:", ':'), (Parts{"a", ""}));
  EXPECT_EQ(split(":", ':'), (Parts{"", ""}));
}

TEST(NearestWord, FindsWhatWasMeant) {
  const Parts names{"vsm", "evsm2", "evsm4", "power-cdf", "layered-power-cdf"};
  EXPECT_EQ(nearestWord("vms", names), "vsm");
  EXPECT_EQ(nearestWord("powercdf", names), "power-cdf");
  EXPECT_EQ(nearestWord("evsm4", names), "evsm4");
  EXPECT_EQ(nearestWord("something", names), "");
  EXPECT_EQ(nearestWord("layered", names), "layered-power-cdf");
  EXPECT_EQ(nearestWord("--dep", Parts{"--help", "--depth-range", "--depth"}), "--depth");
  EXPECT_EQ(nearestWord("vsm", Parts{}), "");
}

TEST(Clipped, QuotesEightyBytesAtMost) {
  EXPECT_EQ(clipped("vsm"), "vsm");
  EXPECT_EQ(clipped(std::string(80, 'a')), std::string(80, 'a'));
  EXPECT_EQ(clipped(std::string(81, 'a')), std::string(80, 'a') + "…");
  // A character that would be cut stays out as a whole.
  EXPECT_EQ(clipped(std::string(79, 'a') + "é"), std::string(79, 'a') + "…");
}

// A file must not command the terminal that shows a message about it.
TEST(Clipped, ShowsWhatIsNoCharacterByItsNumber) {
  EXPECT_EQ(clipped("a\x1b[31mb\n"), "a\\x1b[31mb\\x0a");
  EXPECT_EQ(clipped("σ² 1 – ½ €"), "σ² 1 – ½ €");
  EXPECT_EQ(clipped("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(clipped("\xc2\x9b"), "\\xc2\\x9b");           // a control character of two bytes
  EXPECT_EQ(clipped("\xc0\x80"), "\\xc0\\x80");           // zero, written too long
  EXPECT_EQ(clipped("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
}

TEST(OneLine, HasNoControlCharacters) {
  EXPECT_EQ(oneLine("a\nb\tc\x1b \n"), "a b c");
}

}  // namespace
}  // namespace umbra
