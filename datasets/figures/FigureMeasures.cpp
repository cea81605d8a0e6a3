#include "datasets/figures/FigureMeasures.h"

#include <vector>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

constexpr FigureMeasure knownMeasures[] = {
    {"rmse", SweepMeasure::Compare,
     "root mean square of e, a pixel's visibility less that of exact filtering (PCF with the same "
     "kernel, map and bias), over all pixels that receive shadow"},
    {"mae", SweepMeasure::Compare, "mean of |e|"},
    {"bleeding", SweepMeasure::Compare, "mean of max(e, 0): light where there should be less"},
    {"darkening", SweepMeasure::Compare, "mean of max(−e, 0): shadow where there should be less"},
    {"max", SweepMeasure::Compare, "largest e"},
    {"min", SweepMeasure::Compare, "smallest e"},
    {"umbraBleeding", SweepMeasure::Compare,
     "mean of e over the pixels that exact filtering leaves without light"},
    {"smallestReduction.amount", SweepMeasure::Compare,
     "the least bleeding reduction after which no pixel shows light in an umbra"},
    {"smallestReduction.darkening", SweepMeasure::Compare,
     "mean over-darkening that this reduction brings"},
    {"smallestReduction.maxDarkening", SweepMeasure::Compare,
     "largest over-darkening that this reduction brings"},
    {"decomposition.bleeding", SweepMeasure::Decomposition,
     "the part of the mean error that is light bleeding"},
    {"decomposition.contactLeak", SweepMeasure::Decomposition,
     "the part of the mean error that is light near contacts"},
    {"decomposition.overDarkening", SweepMeasure::Decomposition,
     "the part of the mean error that is over-darkening"},
    {"decomposition.precision", SweepMeasure::Decomposition,
     "the part of the mean error that comes of the storage format"},
    {"probe.visibility", SweepMeasure::Probe, "visibility at the probed point, 0 to 1"},
    {"probe.reference", SweepMeasure::Probe, "visibility there by exact filtering"},
    {"probe.error", SweepMeasure::Probe, "visibility less exact visibility there"},
    {"cost.bakeMs", SweepMeasure::Cost,
     "median milliseconds of map, channels and prefilter, on this machine"},
    {"cost.shadeMs", SweepMeasure::Cost,
     "median milliseconds of the shaded scene, on this machine"},
    {"cost.frameMs", SweepMeasure::Cost, "cost.bakeMs + cost.shadeMs: a frame whose light moves"},
    {"cost.bytesStored", SweepMeasure::Cost,
     "bytes per texel of the channels that the method stores, as the papers count"},
    {"cost.bytesUsed", SweepMeasure::Cost,
     "bytes per texel of all textures that the program takes"},
};

const Json* memberOf(const Json* object, const std::string& key) {
  if (!object || !object->is_object()) return nullptr;
  const auto found = object->find(key);
  return found == object->end() ? nullptr : &*found;
}

}  // namespace

std::span<const FigureMeasure> figureMeasures() {
  return knownMeasures;
}

const FigureMeasure& figureMeasureNamed(const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (const FigureMeasure& measure : knownMeasures) {
    if (measure.name == name) return measure;
    names.emplace_back(measure.name);
  }
  const std::string nearest = nearestWord(name, names);
  throw Error(ErrorKind::BadInput, where + ": '" + clipped(name) + "' is no measure; " +
                                       (nearest.empty() ? "there are " + joined(names)
                                                        : "did you mean '" + nearest + "'?"));
}

std::optional<double> measureIn(const Json& row, std::string_view measure) {
  if (measure == "cost.frameMs") {
    const auto bake = measureIn(row, "cost.bakeMs"), shade = measureIn(row, "cost.shadeMs");
    return bake && shade ? std::optional(*bake + *shade) : std::nullopt;
  }
  // A row has figures of compare, probe and cost; those of compare have no prefix here.
  const bool isPrefixed = measure.starts_with("probe.") || measure.starts_with("cost.");
  const Json* value = isPrefixed ? &row : memberOf(&row, "compare");
  for (const std::string& key : split(std::string(measure), '.')) value = memberOf(value, key);
  if (!value || !value->is_number()) return {};
  return value->get<double>();
}

}  // namespace umbra
