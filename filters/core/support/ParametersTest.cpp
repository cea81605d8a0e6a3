#include "filters/core/support/Parameters.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

enum class Placement { Uniform, Manual, Lloyd };

struct Settings {
  double variance = 1e-6;
  int layers = 4;
  Placement placement = Placement::Uniform;
  std::vector<double> splits{0.5};

  static constexpr std::array<std::string_view, 3> placements{"uniform", "manual", "lloyd"};
  static constexpr auto fields() {
    using P = Settings;
    return std::tuple{
        Field<P, double>{&P::variance, "min-variance", "σ²", "depth²", 1e-12, 1e-2, "Smallest.",
                         Scale::Logarithmic},
        Field<P, int>{&P::layers, "layers", "N", "", 1, 8, "How many."},
        Field<P, Placement>{&P::placement, "placement", "", "", Placement::Uniform,
                            Placement::Lloyd, "How.", Scale::Linear, P::placements},
        Field<P, std::vector<double>>{&P::splits, "splits", "s", "depth", 0.0, 1.0, "Where."},
    };
  }
};

class Parameters : public testing::Test {
 protected:
  const Parameter& named(std::string_view name) { return parameterNamed(list, name, "test"); }

  // The message of the error that setting `text` throws, or "" where it is accepted.
  std::string refusal(std::string_view name, std::string_view text) {
    const std::string before = named(name).text();
    try {
      named(name).setFromText(text, "--set t." + std::string(name));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      EXPECT_EQ(named(name).text(), before) << "a refused value changes nothing";
      return error.what();
    }
    return "";
  }

  Settings values;
  std::vector<Parameter> list = bindFields(values, Settings::fields());
};

TEST_F(Parameters, CarryWhatTheTableSays) {
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].name, "min-variance");
  EXPECT_EQ(list[0].symbol, "σ²");
  EXPECT_EQ(list[0].unit, "depth²");
  EXPECT_EQ(list[0].low, 1e-12);
  EXPECT_EQ(list[0].high, 1e-2);
  EXPECT_EQ(list[0].scale, Scale::Logarithmic);
  EXPECT_EQ(list[2].choices.size(), 3u);
}

TEST_F(Parameters, DefaultsStayWhateverIsSet) {
  named("layers").setFromText("7", "test");
  EXPECT_EQ(named("layers").defaultValue, ParameterValue(4));
  EXPECT_EQ(named("placement").defaultValue, ParameterValue(std::string("uniform")));
}

TEST_F(Parameters, SetTheMemberFromText) {
  named("min-variance").setFromText("2.5e-4", "test");
  named("layers").setFromText("8", "test");
  named("placement").setFromText("lloyd", "test");
  named("splits").setFromText("0.2:0.5:0.7", "test");
  EXPECT_EQ(values.variance, 2.5e-4);
  EXPECT_EQ(values.layers, 8);
  EXPECT_EQ(values.placement, Placement::Lloyd);
  EXPECT_EQ(values.splits, (std::vector<double>{0.2, 0.5, 0.7}));
}

TEST_F(Parameters, TextReadsBack) {
  values = {1.0 / 3.0 * 1e-3, 3, Placement::Manual, {0.1, 1.0 / 3.0}};
  const Settings before = values;
  for (const Parameter& parameter : list) parameter.setFromText(parameter.text(), "test");
  EXPECT_EQ(values.variance, before.variance);
  EXPECT_EQ(values.layers, before.layers);
  EXPECT_EQ(values.placement, before.placement);
  EXPECT_EQ(values.splits, before.splits);
}

TEST_F(Parameters, RangesAreInclusive) {
  EXPECT_EQ(refusal("min-variance", "1e-12"), "");
  EXPECT_EQ(refusal("min-variance", "0.01"), "");
  EXPECT_EQ(refusal("layers", "1"), "");
  EXPECT_EQ(refusal("layers", "8"), "");
}

TEST_F(Parameters, RefuseWhatIsOutOfRangeOrNoValue) {
  for (const char* text : {"0.1", "0", "-1", "nan", "inf", "", "1e-6x", " 1e-6", "many"})
    EXPECT_NE(refusal("min-variance", text), "") << text;
  for (const char* text : {"0", "9", "2.5", "1e99", "four", ""})
    EXPECT_NE(refusal("layers", text), "") << text;
  for (const char* text : {"Lloyd", "lloyds", ""})
    EXPECT_NE(refusal("placement", text), "") << text;
  for (const char* text : {"0.2:1.5", "0.2::0.5", "0.2:", ":", "0.2;0.5", "nan"})
    EXPECT_NE(refusal("splits", text), "") << text;
}

TEST_F(Parameters, SayInOneLineWhereItWasAndWhatWouldBeRight) {
  EXPECT_EQ(refusal("layers", "9"),
            "--set t.layers: '9' is not right, it takes a whole number from 1 to 8");
  EXPECT_EQ(refusal("placement", "grid"),
            "--set t.placement: 'grid' is not right, it takes one of uniform, manual, lloyd");
}

TEST_F(Parameters, TakeAWholeNumberForARealOneOnly) {
  Settings other;
  const auto parameters = bindFields(other, Settings::fields());
  EXPECT_THROW(parameters[1].set(2.0, "file.json: layers"), Error);
  EXPECT_THROW(parameters[0].set(std::string("1e-6"), "file.json: min-variance"), Error);
  EXPECT_THROW(parameters[0].set(1, "file.json: min-variance"), Error) << "1 is above the range";
  struct Plain {
    double a = 0.0;
  } plain;
  const auto real =
      bindFields(plain, std::tuple{Field<Plain, double>{&Plain::a, "a", "", "", 0, 9, ""}});
  real[0].set(2, "file.json: a");
  EXPECT_EQ(plain.a, 2.0);
}

TEST_F(Parameters, UnknownNamesGetASuggestion) {
  const auto messageFor = [&](std::string_view name) -> std::string {
    try {
      named(name);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(messageFor("layer").find("did you mean 'layers'?"), std::string::npos);
  EXPECT_NE(messageFor("something-else").find("min-variance, layers, placement, splits"),
            std::string::npos);
}

}  // namespace
}  // namespace umbra
