// Properties of every technique in the catalogue.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "filters/core/prefilter/Prefilter.h"
#include "tests/properties/Draws.h"

namespace umbra {
namespace {

class EveryTechnique : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Technique> make() const { return draws::make(GetParam()); }
  bool isAnyOf(const std::set<std::string>& ids) const { return ids.contains(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryTechnique, testing::ValuesIn(draws::techniqueIds()),
                         [](const auto& drawn) { return draws::caseName(drawn.param); });

TEST_P(EveryTechnique, GivesAVisibilityWhateverItReads) {
  rc::detail::checkGTest([&] {
    const auto technique = make();
    draws::parametersOf(*technique);
    const StorageFormat format = draws::formatFor(*technique);
    const draws::Place place = draws::place();
    technique->adapt(place.map);
    const std::vector<double> channels = prefilteredRegion(place.region, *technique, format);
    for (double channel : channels) RC_ASSERT(std::isfinite(channel));
    const double receiver = draws::receiverFor(place.region);
    const double visibility = technique->visibility({channels, place.region}, receiver);
    RC_ASSERT(visibility >= 0.0 && visibility <= 1.0);  // this is false for a NaN
  });
}

// Depths and receivers so near to 0, to 1 and to each other that squares and differences of them
// vanish: every setting is defined there, too.
TEST_P(EveryTechnique, GivesAVisibilityWhereDifferencesVanish) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double above = std::nextafter(0.5, 1.0), below = std::nextafter(1.0, 0.0);
  const std::vector<std::vector<double>> depths{
      {0.0},        {least},      {1e-162},         {0.5},       {1.0}, {0.0, 1.0},
      {0.5, above}, {0.0, least}, {1e-162, 1e-160}, {below, 1.0}};
  draws::fromSeed(1692, [&] {
    for (const auto& technique : draws::settingsOf(GetParam(), 20))
      for (const std::vector<double>& texels : depths) {
        DepthMap map(int(texels.size()), 1);
        std::copy(texels.begin(), texels.end(), map.values().begin());
        technique->adapt(map);
        const Region region = regionAtTexel(map, {KernelShape::Box, 1}, 0, 0);
        const std::vector<double> channels =
            prefilteredRegion(region, *technique, StorageFormat::Double);
        for (double receiver : {0.0, least, 1e-308, 1e-162, 1e-154, 0.5, above, below, 1.0}) {
          const double visibility = technique->visibility({channels, region}, receiver);
          EXPECT_TRUE(visibility >= 0.0 && visibility <= 1.0)
              << draws::described(*technique) << " gives " << visibility << " at " << receiver
              << " for " << texels.size() << " depths from " << texels[0];
        }
      }
  });
}

// A normalised format stores values between low and high: others would be cut.
TEST_P(EveryTechnique, EncodesIntoTheRangesOfItsChannels) {
  if (!make()->refusal(StorageFormat::Unorm16).empty()) {
    EXPECT_FALSE(make()->refusal(StorageFormat::Unorm8).empty());
    return;
  }
  rc::detail::checkGTest([&] {
    const auto technique = make();
    draws::parametersOf(*technique);
    const std::vector<Channel> layout = technique->channels();
    std::vector<double> values(layout.size());
    technique->encode(draws::unit(), values);
    for (std::size_t c = 0; c < layout.size(); ++c) {
      RC_ASSERT(values[c] >= layout[c].low - 1e-15);
      RC_ASSERT(values[c] <= layout[c].high + 1e-15);
    }
  });
}

// The farther the receiver, the darker it is. This does not hold where layers take turns, where a
// series rings, and for the moment bound, whose bias is not monotone.
TEST_P(EveryTechnique, DarkensWithTheReceiversDepth) {
  if (isAnyOf({"lvsm", "layered-power-cdf", "csm", "msm"})) return;
  // Warped depth g is right to a few ε; the bound's slope in it is at most 0.65/σmin, where
  // σmin = √min-variance · c · g, and √min-variance · c is 1e-3 for VSM, more for EVSM.
  constexpr double rounding = 16.0 * 1.2e-16 / 1e-3;
  rc::detail::checkGTest([&] {
    const auto technique = make();
    const draws::Place place = draws::place();
    const double one = draws::receiverFor(place.region), other = draws::receiverFor(place.region);
    const auto [near, far] = std::minmax(one, other);
    RC_ASSERT(draws::visibilityOf(*technique, place.region, far) <=
              draws::visibilityOf(*technique, place.region, near) + rounding);
  });
}

TEST_P(EveryTechnique, IsNeverBelowTheReferenceIfItSaysSo) {
  if (!make()->info().upperBound) return;
  rc::detail::checkGTest([&] {
    const auto technique = make();
    const draws::Place place = draws::place();
    const double receiver = draws::receiverFor(place.region);
    // A sum over the taps is right to taps·ε of its largest term. The smallest variance, 1e-6 of
    // that term's square or more, divides it.
    const double rounding = 1.2e-16 * place.region.texels.size() / 1e-6;
    RC_ASSERT(draws::visibilityOf(*technique, place.region, receiver) >=
              referenceVisibility(place.region, receiver) - rounding);
  });
}

// One depth and a receiver on it or before it: nothing blocks.
TEST_P(EveryTechnique, LightsTheNearSideOfOneDepth) {
  // Half the moment bias, and rounding divided by the bias squared.
  const double msm = 1.5e-5 + 1e-6;
  const double tolerance = isAnyOf({"msm"}) ? msm : 1e-12;
  rc::detail::checkGTest([&] {
    const auto technique = make();
    const double z = draws::unit();
    // A Fourier series rings before the step: it promises light on the depth itself only.
    const double receiver = isAnyOf({"csm"}) ? z : z * draws::unit();
    const Region region = draws::regionOf({z, z, z}, {0.25, 0.5, 0.25});
    const double visibility = draws::visibilityOf(*technique, region, receiver);
    RC_ASSERT(visibility >= 1.0 - tolerance);
  });
}

TEST_P(EveryTechnique, IsCopiedWithItsParameters) {
  rc::detail::checkGTest([&] {
    const auto technique = make();
    draws::parametersOf(*technique);
    const draws::Place place = draws::place();
    technique->adapt(place.map);
    const auto copy = technique->clone();
    const double receiver = draws::receiverFor(place.region);
    const double visibility = draws::visibilityOf(*technique, place.region, receiver);
    RC_ASSERT(draws::visibilityOf(*copy, place.region, receiver) == visibility);
    draws::parametersOf(*copy);  // parameters of the copy's own
    RC_ASSERT(draws::visibilityOf(*technique, place.region, receiver) == visibility);
  });
}

TEST_P(EveryTechnique, ReadsItsParametersBackFromTheirText) {
  rc::detail::checkGTest([&] {
    const auto technique = make(), other = make();
    draws::parametersOf(*technique);
    const std::vector<Parameter> from = technique->parameters(), to = other->parameters();
    for (std::size_t i = 0; i < from.size(); ++i) to[i].setFromText(from[i].text(), "test");
    for (std::size_t i = 0; i < from.size(); ++i) RC_ASSERT(to[i].get() == from[i].get());
  });
}

TEST_P(EveryTechnique, DeclaresItsParametersInFull) {
  const auto technique = make();
  std::set<std::string_view> names;
  for (const Parameter& parameter : technique->parameters()) {
    SCOPED_TRACE(parameter.name);
    EXPECT_TRUE(names.insert(parameter.name).second);
    EXPECT_FALSE(parameter.doc.empty());
    EXPECT_TRUE(!parameter.symbol.empty() || !parameter.choices.empty());
    EXPECT_TRUE(parameter.get() == parameter.defaultValue);
    EXPECT_NO_THROW(parameter.set(parameter.defaultValue, "default"));
    EXPECT_TRUE(parameter.scale == Scale::Linear || parameter.low >= 0.0);
  }
}

TEST_P(EveryTechnique, DescribesItself) {
  const auto technique = make();
  const TechniqueInfo& info = technique->info();
  EXPECT_EQ(info.id, GetParam());
  EXPECT_FALSE(info.title.empty() || info.citation.empty() || info.summary.empty() ||
               info.formula.empty());
  EXPECT_TRUE(std::regex_match(std::string(info.colour), std::regex("#[0-9a-f]{6}")));
  for (std::string_view section : {"# ", "**Stores**", "**Exact**", "**Fails", "Source:"})
    EXPECT_NE(technique->page().find(section), std::string_view::npos) << section;
}

// "float umbra_overlap", "float umbra_layer_low[16]": what the shader declares where it has the
// technique's channels.
std::set<std::string> declaredUniforms(const Technique& technique) {
  std::set<std::string> declared;
  std::istringstream shader{std::string(technique.glsl())};
  const std::regex condition("#if UMBRA_CHANNELS == (\\d+)"), comment("//.*");
  const std::regex declaration("uniform (float|int) (\\w+(\\[16\\])?); *"), word("\\buniform\\b");
  bool counts = true;
  for (std::string line; std::getline(shader, line);) {
    std::smatch match;
    line = std::regex_replace(line, comment, "");
    if (std::regex_match(line, match, condition))
      counts = std::stoul(match[1]) == technique.channels().size();
    else if (line == "#endif")
      counts = true;
    else if (std::regex_match(line, match, declaration)) {
      if (counts) declared.insert(match.str(1) + " " + match.str(2));
    } else {
      EXPECT_FALSE(std::regex_search(line, word)) << "not understood: " << line;
    }
  }
  return declared;
}

// Those that a shader may declare for a parameter; a list also has its length.
std::vector<std::string> uniformsOf(const Parameter& parameter) {
  std::string name = "umbra_" + std::string(parameter.name);
  std::replace(name.begin(), name.end(), '-', '_');
  if (std::holds_alternative<std::vector<double>>(parameter.defaultValue))
    return {"float " + name + "[16]", "int " + name + "_count"};
  return {(std::holds_alternative<double>(parameter.defaultValue) ? "float " : "int ") + name};
}

std::string uniformOf(const Uniform& uniform) {
  const auto* list = std::get_if<std::vector<float>>(&uniform.value);
  EXPECT_TRUE(!list || list->size() == 16) << uniform.name;
  return (std::holds_alternative<int>(uniform.value) ? "int " : "float ") + uniform.name +
         (list ? "[16]" : "");
}

// Everything that reaches a shader beside the uniforms of the parameters themselves.
std::string derivedText(const Technique& technique) {
  std::ostringstream text;
  text << technique.channels().size();
  for (const Uniform& uniform : technique.derivedUniforms()) {
    text << ' ' << uniform.name;
    if (const auto* list = std::get_if<std::vector<float>>(&uniform.value))
      for (float value : *list) text << ' ' << value;
    else if (const auto* real = std::get_if<float>(&uniform.value))
      text << ' ' << *real;
    else
      text << ' ' << std::get<int>(uniform.value);
  }
  return text.str();
}

// Each in its type: a parameter's own, or one that the technique derives.
TEST_P(EveryTechnique, SetsEveryUniformOfItsShader) {
  const auto technique = make();
  std::set<std::string> given;
  for (const Parameter& parameter : technique->parameters())
    for (const std::string& uniform : uniformsOf(parameter)) given.insert(uniform);
  for (const Uniform& uniform : technique->derivedUniforms()) given.insert(uniformOf(uniform));
  for (const std::string& uniform : declaredUniforms(*technique))
    EXPECT_TRUE(given.contains(uniform)) << uniform;
}

// A parameter that is no uniform changes what is derived, or how many channels there are.
TEST_P(EveryTechnique, BringsEveryParameterToItsShader) {
  const auto technique = make();
  const std::set<std::string> declared = declaredUniforms(*technique);
  for (const Uniform& uniform : technique->derivedUniforms())
    EXPECT_TRUE(declared.contains(uniformOf(uniform))) << uniform.name;
  DepthMap map(3, 2);
  std::ranges::copy(std::vector{0.1, 0.2, 0.3, 0.35, 0.4, 0.9}, map.values().begin());
  const std::size_t count = technique->parameters().size();
  for (std::size_t i = 0; i < count; ++i) {
    const Parameter parameter = technique->parameters()[i];
    if (declared.contains(uniformsOf(parameter).front())) continue;
    std::set<std::string> derived;
    for (const ParameterValue& end : draws::endsOf(parameter)) {
      const auto changed = make();
      changed->parameters()[i].set(end, "end");
      changed->adapt(map);
      derived.insert(derivedText(*changed));
    }
    EXPECT_GE(derived.size(), 2u) << parameter.name << " reaches no shader";
  }
}

}  // namespace
}  // namespace umbra
