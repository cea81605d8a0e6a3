#include "filters/core/settings/FrameSettings.h"

#include <span>
#include <utility>

namespace umbra {
namespace {

constexpr std::pair<ReadFilter, std::string_view> readFilters[] = {
    {ReadFilter::Point, "point"},
    {ReadFilter::Bilinear, "bilinear"},
    {ReadFilter::Trilinear, "trilinear"},
    {ReadFilter::Anisotropic, "anisotropic"},
    {ReadFilter::SummedArea, "sat"}};

constexpr std::pair<SatSize, std::string_view> satSizes[] = {
    {SatSize::Footprint, "footprint"}, {SatSize::Distance, "distance"}, {SatSize::Fixed, "fixed"}};

constexpr std::pair<SatPrecision, std::string_view> satPrecisions[] = {
    {SatPrecision::Centred, "centred"},
    {SatPrecision::Integer, "integer"},
    {SatPrecision::Plain, "plain"}};

constexpr std::pair<ViewMode, std::string_view> viewModes[] = {
    {ViewMode::Shaded, "shaded"}, {ViewMode::Visibility, "visibility"},
    {ViewMode::Error, "error"},   {ViewMode::Depth, "depth"},
    {ViewMode::Layers, "layers"}, {ViewMode::Cascades, "cascades"}};

template <class E>
std::string_view nameIn(std::span<const std::pair<E, std::string_view>> table, E value) {
  for (const auto& [candidate, name] : table)
    if (candidate == value) return name;
  return "";
}

}  // namespace

std::string_view nameOf(ReadFilter read) {
  return nameIn<ReadFilter>(readFilters, read);
}
std::string_view nameOf(SatSize size) {
  return nameIn<SatSize>(satSizes, size);
}
std::string_view nameOf(SatPrecision precision) {
  return nameIn<SatPrecision>(satPrecisions, precision);
}
std::string_view nameOf(ViewMode view) {
  return nameIn<ViewMode>(viewModes, view);
}

}  // namespace umbra
