// Random maps, regions, receivers and parameters, drawn by RapidCheck inside a property, or by
// fromSeed outside one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/maps/Region.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/settings/StorageFormat.h"
#include "filters/core/technique/Technique.h"

namespace umbra::draws {

// A number in [0,1]; the ends and simple fractions are frequent.
double unit();
double between(double low, double high);

// A texel of a small map: noise, a few planes, one depth, a slope with an edge, or open ground.
struct Place {
  DepthMap map;
  Kernel kernel;
  Region region;  // read at a texel, or bilinearly between texels
};
Place place();

// A map of 1 to 12 texels a side with 1, 2, 4 or 8 samples a texel, at most `mostSamples`.
DepthMap map(int mostSamples);
Kernel kernel();
// A read anywhere on the map, with a footprint for the filter. A bilinear read lies between texel
// centres, where its region has the weights of its channels.
ReadPoint read(const DepthMap& map, ReadFilter filter);

// A depth anywhere, or at or just beside one of the region's depths.
double receiverFor(const Region& region);

// Draws every parameter of the technique over its whole range.
void parametersOf(Technique& technique);
// What a parameter can be at most: both ends of its range, every choice, no splits and the most.
std::vector<ParameterValue> endsOf(const Parameter& parameter);
// The technique at its defaults; then, for every parameter and each of its ends, with this value
// and the others drawn; then with all drawn, until there are `atLeast`.
std::vector<std::unique_ptr<Technique>> settingsOf(const std::string& id, int atLeast);
// "esm with exponent 80, bleed-reduction 0".
std::string described(const Technique& technique);

// Runs `draw` outside a property. The same seed draws the same: what a test that runs by itself
// draws does not change from run to run, unless UMBRA_TEST_SEED names another number.
void fromSeed(std::uint64_t seed, const std::function<void()>& draw);

// Draws a format that the technique does not refuse, and limits the technique to it.
StorageFormat formatFor(Technique& technique);

// The ids of all techniques, and an id with '_' for names of test cases.
std::vector<std::string> techniqueIds();
std::string caseName(std::string id);
std::unique_ptr<Technique> make(const std::string& id);

// The visibility from channels that were reduced over the region without a map.
double visibilityOf(const Technique& technique, const Region& region, double receiver,
                    StorageFormat format = StorageFormat::Double);

// A region of these depths and weights.
Region regionOf(const std::vector<double>& depths, const std::vector<double>& weights);

}  // namespace umbra::draws
