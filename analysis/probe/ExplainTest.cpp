#include "analysis/probe/Explain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/probe/TestMaps.h"

namespace umbra {
namespace {

Probe explained(const DepthMap& map, double receiver) {
  return takeProbe({.map = map,
                    .read = ReadPoint::atTexel(map, 4, 4),
                    .kernel = {KernelShape::Box, 2},
                    .receiver = receiver,
                    .techniques = everyTechnique(map)});
}

TEST(Explain, EndsInTheVisibilityOfTheProbeAndOfTheCurve) {
  const DepthMap map = randomMap(9, 9, 5);
  const Probe probe = explained(map, 0.5);
  const Curves curves = curvesOf(probe, 3);  // at 0, ½ and 1
  for (std::size_t i = 0; i < probe.techniques.size(); ++i) {
    const Trace trace = explain(probe, probe.techniques[i]);
    EXPECT_EQ(trace.steps.back().value, probe.techniques[i].visibility);
    EXPECT_EQ(trace.steps.back().value, curves.techniques[i][1]);
  }
}

TEST(Explain, TheTextHasTheSentenceAndALineForEveryStep) {
  const DepthMap map = randomMap(9, 9, 5);
  const Probe probe = explained(map, 0.9);
  for (const TechniqueResult& result : probe.techniques) {
    const Trace trace = explain(probe, result);
    const std::string text = traceText(trace);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::ptrdiff_t(trace.steps.size()) + 1);
    EXPECT_EQ(text.substr(0, trace.sentence.size()), trace.sentence);
    EXPECT_EQ(text.find("→ ") != std::string::npos, trace.culprit.has_value());
  }
}

// Symbols are wider in bytes than on paper, and combining marks take no room at all.
TEST(Explain, TheTextIsAlignedInCharacters) {
  Trace trace;
  trace.sentence = "s";
  trace.steps = {{"z̄", "m", "f", 1.0}, {"σ²₊", "m", "f", 1.0}, {"M", "m", "f", 1.0}};
  EXPECT_EQ(traceText(trace), "s\n  z̄    1  f  m\n  σ²₊  1  f  m\n  M    1  f  m\n");
}

}  // namespace
}  // namespace umbra
