#include "tests/properties/Draws.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/technique/TechniqueCatalogue.h"
#include "filters/techniques/lvsm/Layers.h"

namespace umbra::draws {
namespace {

// Both ends are included.
int whole(int low, int high) {
  return *rc::gen::inRange(low, high + 1);
}

DepthMap drawnMap(int largestSide, int samples) {
  DepthMap map(whole(1, largestSide), whole(1, largestSide), samples, 1.0);
  const std::vector<double> planes{unit(), unit(), unit()};
  const int kind = whole(0, 4);
  const double base = unit(), slope = between(-0.05, 0.05);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      double depth = planes[0];
      if (kind == 0) depth = unit();
      if (kind == 1) depth = planes[whole(0, 2)];
      if (kind == 3) depth = x > y ? std::clamp(base + slope * (x + 2 * y), 0.0, 1.0) : planes[0];
      if (kind == 4) depth = whole(0, 1) ? 1.0 : planes[0];
      for (double& sample : map.pixel(x, y)) {
        sample = depth;
        if (kind == 0) depth = unit();
        if (kind == 1) depth = planes[whole(0, 2)];
      }
    }
  }
  return map;
}

ParameterValue drawnValue(const Parameter& parameter) {
  if (!parameter.choices.empty())
    return std::string(parameter.choices[whole(0, int(parameter.choices.size()) - 1)]);
  if (std::holds_alternative<int>(parameter.defaultValue))
    return whole(int(parameter.low), int(parameter.high));
  if (std::holds_alternative<double>(parameter.defaultValue)) {
    const double u = unit();
    if (u == 0.0 || u == 1.0) return u == 0.0 ? parameter.low : parameter.high;
    if (parameter.scale == Scale::Linear)
      return parameter.low + u * (parameter.high - parameter.low);
    // A logarithmic range that begins at 0 is drawn over its upper twelve decades.
    const double smallest = parameter.low > 0.0 ? parameter.low : parameter.high * 1e-12;
    return smallest * std::pow(parameter.high / smallest, u);
  }
  // Lists are layer splits: they rise strictly inside the range.
  std::set<double> list;
  for (int i = whole(0, 6); i > 0; --i) {
    const double value = between(parameter.low, parameter.high);
    if (value > parameter.low && value < parameter.high) list.insert(value);
  }
  return std::vector<double>(list.begin(), list.end());
}

}  // namespace

double unit() {
  constexpr int fine = 1 << 24;
  if (whole(0, 3) == 0) return whole(0, 8) / 8.0;
  return double(whole(0, fine)) / fine;
}

double between(double low, double high) {
  return low + unit() * (high - low);
}

Place place() {
  Place drawn;
  drawn.map = drawnMap(9, 1);
  drawn.kernel = kernel();
  drawn.region = whole(0, 1)
                     ? regionAtTexel(drawn.map, drawn.kernel, whole(0, drawn.map.width() - 1),
                                     whole(0, drawn.map.height() - 1))
                     : regionBilinear(drawn.map, drawn.kernel, unit(), unit());
  return drawn;
}

DepthMap map(int mostSamples) {
  int samples = 1;
  while (2 * samples <= mostSamples && whole(0, 1)) samples *= 2;
  return drawnMap(12, samples);
}

Kernel kernel() {
  Kernel drawn;
  drawn.shape = *rc::gen::element(KernelShape::None, KernelShape::Box, KernelShape::Gaussian);
  drawn.radius = whole(0, 6);
  drawn.sigma = whole(0, 1) ? 0.0 : between(0.25, 4.0);
  return drawn;
}

ReadPoint read(const DepthMap& map, ReadFilter filter) {
  ReadPoint drawn{filter, unit(), unit(), {}};
  if (filter == ReadFilter::Bilinear) {
    drawn.u = (0.5 + drawn.u * (map.width() - 1)) / map.width();
    drawn.v = (0.5 + drawn.v * (map.height() - 1)) / map.height();
  }
  if (filter == ReadFilter::Trilinear || filter == ReadFilter::Anisotropic)
    drawn.footprint = {between(-20.0, 20.0), between(-20.0, 20.0), 1};
  if (filter == ReadFilter::Anisotropic) drawn.footprint.probes = whole(1, 16);
  if (filter == ReadFilter::SummedArea)
    drawn.footprint = {between(1.0, 20.0), between(1.0, 20.0), 1};
  return drawn;
}

double receiverFor(const Region& region) {
  if (whole(0, 1)) return unit();
  const double depth = region.texels[whole(0, int(region.texels.size()) - 1)].depth;
  const double step = *rc::gen::element(0.0, 0.0, 1e-9, -1e-9, 1e-3, -1e-3);
  return std::clamp(depth + step, 0.0, 1.0);
}

void parametersOf(Technique& technique) {
  for (const Parameter& parameter : technique.parameters())
    parameter.set(drawnValue(parameter), "drawn");
}

std::vector<ParameterValue> endsOf(const Parameter& parameter) {
  if (!parameter.choices.empty()) {
    std::vector<ParameterValue> ends;
    for (std::string_view choice : parameter.choices) ends.emplace_back(std::string(choice));
    return ends;
  }
  if (std::holds_alternative<int>(parameter.defaultValue))
    return {int(parameter.low), int(parameter.high)};
  if (std::holds_alternative<double>(parameter.defaultValue))
    return {parameter.low, parameter.high};
  std::vector<double> most;
  for (int k = 1; k < largestLayerCount; ++k)
    most.push_back(parameter.low + (parameter.high - parameter.low) * k / largestLayerCount);
  return {std::vector<double>{}, most};
}

std::vector<std::unique_ptr<Technique>> settingsOf(const std::string& id, int atLeast) {
  std::vector<std::unique_ptr<Technique>> settings;
  settings.push_back(make(id));
  const auto add = [&](std::size_t parameter, const ParameterValue* end) {
    std::unique_ptr<Technique> technique = make(id);
    parametersOf(*technique);
    if (end) technique->parameters()[parameter].set(*end, "end");
    settings.push_back(std::move(technique));
  };
  const std::vector<Parameter> parameters = settings.front()->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const ParameterValue& end : endsOf(parameters[i])) add(i, &end);
  while (int(settings.size()) < atLeast) add(0, nullptr);
  return settings;
}

std::string described(const Technique& technique) {
  std::string text(technique.info().id);
  const std::unique_ptr<Technique> copy = technique.clone();
  const char* before = " with ";
  for (const Parameter& parameter : copy->parameters()) {
    text += before + std::string(parameter.name) + " " + parameter.text();
    before = ", ";
  }
  return text;
}

void fromSeed(std::uint64_t seed, const std::function<void()>& draw) {
  if (const char* other = std::getenv("UMBRA_TEST_SEED")) seed = std::strtoull(other, nullptr, 10);
  const auto whole = rc::gen::exec([&] {
    draw();
    return true;
  });
  whole(rc::Random(seed), rc::kNominalSize).value();
}

StorageFormat formatFor(Technique& technique) {
  std::vector<StorageFormat> accepted;
  for (StorageFormat format : {StorageFormat::Double, StorageFormat::Float, StorageFormat::Half,
                               StorageFormat::Unorm16, StorageFormat::Unorm8})
    if (technique.refusal(format).empty()) accepted.push_back(format);
  const StorageFormat format = accepted[whole(0, int(accepted.size()) - 1)];
  technique.limitTo(format);
  return format;
}

std::vector<std::string> techniqueIds() {
  const TechniqueCatalogue catalogue = allTechniques();
  std::vector<std::string> ids;
  for (const Technique* technique : catalogue.all()) ids.emplace_back(technique->info().id);
  return ids;
}

std::string caseName(std::string id) {
  std::replace(id.begin(), id.end(), '-', '_');
  return id;
}

std::unique_ptr<Technique> make(const std::string& id) {
  return allTechniques().make(id);
}

double visibilityOf(const Technique& technique, const Region& region, double receiver,
                    StorageFormat format) {
  const std::vector<double> channels = prefilteredRegion(region, technique, format);
  return technique.visibility({channels, region}, receiver);
}

Region regionOf(const std::vector<double>& depths, const std::vector<double>& weights) {
  Region region;
  for (std::size_t i = 0; i < depths.size(); ++i)
    region.texels.push_back({int(i), 0, depths[i], weights[i]});
  region.nearestDepth = depths.front();
  return region;
}

}  // namespace umbra::draws
