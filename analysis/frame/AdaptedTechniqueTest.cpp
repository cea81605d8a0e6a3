#include "analysis/frame/AdaptedTechnique.h"

#include <gtest/gtest.h>

#include "analysis/probe/TestMaps.h"
#include "filters/core/technique/TechniqueCatalogue.h"

namespace umbra {
namespace {

// What a depth is stored as, which the layers' bounds decide.
std::vector<double> encoded(const Technique& technique, double depth) {
  std::vector<double> channels(technique.channels().size());
  technique.encode(depth, channels);
  return channels;
}

TEST(AdaptedTechnique, TakesTheSplitsThatAFrameWasDrawnWith) {
  const DepthMap map = randomMap(24, 24, 3);
  const std::unique_ptr<Technique> lloyd = allTechniques().make("lvsm");
  const std::vector<Parameter> parameters = lloyd->parameters();
  parameterNamed(parameters, "layers", "lvsm").set(2, "lvsm");
  parameterNamed(parameters, "placement", "lvsm").set(std::string("lloyd"), "lvsm");
  ASSERT_EQ(lloyd->adaptedSplitCount(), 1);
  const std::vector<double> drawn{0.9};
  const std::unique_ptr<Technique> given = lloyd->clone(), found = lloyd->clone();
  given->setAdaptedSplits(drawn);
  found->adapt(map);
  ASSERT_NE(encoded(*given, 0.7), encoded(*found, 0.7));
  EXPECT_EQ(encoded(*adaptedTechnique(*lloyd, map, drawn), 0.7), encoded(*given, 0.7));
  EXPECT_EQ(encoded(*adaptedTechnique(*lloyd, map), 0.7), encoded(*found, 0.7));
}

}  // namespace
}  // namespace umbra
