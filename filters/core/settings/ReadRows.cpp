#include "filters/core/settings/FrameRows.h"
#include "filters/core/settings/SettingRow.h"

namespace umbra {
namespace {

using detail::settingRow;
using Frame = FrameSettings;
using Text = std::string_view;

constexpr Text prefilter = "Technique and prefilter", readOfFrame = "Read of the shaded frame",
               view = "View";

constexpr Text kernelNames[] = {"none", "box", "gaussian"};
constexpr Text kernelTitles[] = {"None", "Box", "Gaussian"};
constexpr Text kernelLabels[] = {"no prefilter", "box", "Gaussian"};
constexpr Text filterNames[] = {"point", "bilinear", "trilinear", "anisotropic", "sat"};
constexpr Text filterTitles[] = {"Point", "Bilinear", "Trilinear", "Anisotropic", "Summed area"};
constexpr Text filterLabels[] = {"point", "bilinear", "trilinear", "anisotropic", "summed area"};
constexpr Text boxNames[] = {"footprint", "distance", "fixed"};
constexpr Text boxTitles[] = {"Footprint", "Distance", "Fixed"};
constexpr Text boxLabels[] = {"box by footprint", "box by distance", "fixed box"};
constexpr Text sumNames[] = {"centred", "integer", "plain"};
constexpr Text sumTitles[] = {"Centred float", "Integer", "Plain float"};
constexpr Text sumLabels[] = {"centred sums", "integer sums", "plain sums"};
constexpr Text viewNames[] = {"shaded", "visibility", "error", "depth", "layers", "cascades"};
constexpr Text radiusLabel[] = {"radius #"}, sigmaLabel[] = {"σ #"}, anisotropyLabel[] = {" ×#"},
               distanceLabel[] = {" #"};

constexpr int anisotropies[] = {1, 2, 4, 8, 16};
static_assert(anisotropies[4] == ReadSettings::largestAnisotropy);

bool sums(const Frame& frame) {
  return frame.read.filter == ReadFilter::SummedArea;
}

Text withoutKernel(const Frame& frame) {
  return frame.kernel.shape == KernelShape::None ? "there is no prefilter" : "";
}
Text withoutGaussian(const Frame& frame) {
  return frame.kernel.shape == KernelShape::Gaussian ? "" : "the kernel is no Gaussian";
}
Text unlessAnisotropic(const Frame& frame) {
  return frame.read.filter == ReadFilter::Anisotropic ? "" : "the read is not anisotropic";
}
Text withoutErrors(const Frame& frame) {
  return frame.view == ViewMode::Error ? "" : "the view does not show errors";
}
Text withoutTable(const Frame& frame) {
  return sums(frame) ? "" : "the read is no summed-area table";
}
Text unlessByDistance(const Frame& frame) {
  if (!sums(frame)) return withoutTable(frame);
  return frame.read.satSize == SatSize::Distance ? "" : "the box does not follow the distance";
}
// A summed-area table averages the kernel's box by itself, and cascades leave room for the kernel
// about their windows.
Stage ofKernel(const Frame& before, const Frame& after) {
  const bool cut = after.map.cascades.count > 1;
  if (cut && before.kernel.effectiveRadius() != after.kernel.effectiveRadius()) return Stage::Depth;
  return sums(before) && sums(after) ? Stage::Shade : Stage::Prefilter;
}
Stage ofFilter(const Frame& before, const Frame& after) {
  return sums(before) != sums(after) ? Stage::Prefilter : Stage::Read;
}

constexpr SettingRow<Frame> ofPrefilter[] = {
    settingRow<&Frame::kernel, &Kernel::shape>({.name = "kernel.shape",
                                                .key = "frame.kernel.shape",
                                                .option = "--kernel",
                                                .takes = "NAME",
                                                .group = prefilter,
                                                .title = "Kernel",
                                                .noun = "kernel",
                                                .choices = kernelNames,
                                                .doc = "Weights of the prefilter, square and "
                                                       "separable",
                                                .choiceTitles = kernelTitles,
                                                .labels = kernelLabels,
                                                .pane = PaneSetting::Kernel,
                                                .stage = Stage::Prefilter},
                                               nullptr, ofKernel),
    settingRow<&Frame::kernel, &Kernel::radius>({.name = "kernel.radius",
                                                 .key = "frame.kernel.radius",
                                                 .option = "--radius",
                                                 .takes = "R",
                                                 .group = prefilter,
                                                 .title = "Radius r",
                                                 .noun = "radius",
                                                 .symbol = "r",
                                                 .unit = "texels",
                                                 .low = 0,
                                                 .high = Kernel::largestRadius,
                                                 .doc = "The kernel has (2r+1)² taps",
                                                 .greyedWhenIdle = true,
                                                 .labels = radiusLabel,
                                                 .pane = PaneSetting::Kernel,
                                                 .stage = Stage::Prefilter},
                                                withoutKernel, ofKernel),
    settingRow<&Frame::kernel, &Kernel::sigma>({.name = "kernel.sigma",
                                                .key = "frame.kernel.sigma",
                                                .option = "--sigma",
                                                .takes = "S",
                                                .group = prefilter,
                                                .title = "Gaussian σ",
                                                .noun = "sigma",
                                                .symbol = "σ",
                                                .unit = "texels",
                                                .low = Kernel::smallestSigma,
                                                .high = Kernel::largestSigma,
                                                .automatic = "half the radius",
                                                .doc = "Standard deviation of the Gaussian",
                                                .reach = Kernel::largestRadius,
                                                .labels = sigmaLabel,
                                                .pane = PaneSetting::Kernel,
                                                .stage = Stage::Prefilter},
                                               withoutGaussian, ofKernel)};

constexpr SettingRow<Frame> ofRead[] = {
    settingRow<&Frame::read, &ReadSettings::filter>({.name = "read.filter",
                                                     .key = "frame.filter",
                                                     .option = "--filter",
                                                     .takes = "NAME",
                                                     .group = readOfFrame,
                                                     .title = "Read",
                                                     .noun = "read",
                                                     .choices = filterNames,
                                                     .doc = "How the shaded frame reads the "
                                                            "prefiltered channels; sat is a "
                                                            "summed-area table",
                                                     .choiceTitles = filterTitles,
                                                     .labels = filterLabels,
                                                     .pane = PaneSetting::Read,
                                                     .stage = Stage::Read},
                                                    nullptr, ofFilter),
    settingRow<&Frame::read, &ReadSettings::anisotropy>({.name = "read.anisotropy",
                                                         .key = "frame.anisotropy",
                                                         .option = "--anisotropy",
                                                         .takes = "N",
                                                         .group = readOfFrame,
                                                         .title = "Anisotropy",
                                                         .noun = "anisotropy",
                                                         .low = 1,
                                                         .high = ReadSettings::largestAnisotropy,
                                                         .doc = "Reads along the longer axis of "
                                                                "what a pixel covers, at most",
                                                         .offered = anisotropies,
                                                         .offeredAs = "×#",
                                                         .labels = anisotropyLabel,
                                                         .pane = PaneSetting::Read,
                                                         .stage = Stage::Shade},
                                                        unlessAnisotropic),
    settingRow<&Frame::read, &ReadSettings::satSize>(
        {.name = "read.sat-size",
         .key = "frame.sat.size",
         .option = "--sat-size",
         .takes = "NAME",
         .group = readOfFrame,
         .title = "Box",
         .noun = "box size",
         .choices = boxNames,
         .doc = "What a summed area covers, at least the kernel: what the pixel covers of the map; "
                "the kernel, wider near the camera; or the kernel",
         .choiceTitles = boxTitles,
         .labels = boxLabels,
         .pane = PaneSetting::Read,
         .stage = Stage::Shade},
        withoutTable),
    settingRow<&Frame::read, &ReadSettings::satDistance>(
        {.name = "read.sat-distance",
         .key = "frame.sat.distance",
         .option = "--sat-distance",
         .takes = "D",
         .group = readOfFrame,
         .title = "Box distance",
         .noun = "box distance",
         .unit = "world units",
         .low = 0.0,
         .high = ReadSettings::largestSatDistance,
         .automatic = "the width of the lit scene",
         .doc = "Distance from the camera at which the box is as wide as the kernel",
         .reach = 100.0,
         .labels = distanceLabel,
         .pane = PaneSetting::Read,
         .stage = Stage::Shade},
        unlessByDistance),
    settingRow<&Frame::read, &ReadSettings::satPrecision>(
        {.name = "read.sat-precision",
         .key = "frame.sat.precision",
         .option = "--sat-precision",
         .takes = "NAME",
         .group = readOfFrame,
         .title = "Sums",
         .noun = "table precision",
         .choices = sumNames,
         .doc = "What the table adds up: floats less their mean, integers, or plain floats, which "
                "lose digits as the map grows",
         .choiceTitles = sumTitles,
         .labels = sumLabels,
         .pane = PaneSetting::Read,
         .stage = Stage::Read},
        withoutTable),
    settingRow<&Frame::view>({.name = "view.mode",
                              .key = "frame.view",
                              .option = "--view",
                              .takes = "NAME",
                              .group = view,
                              .title = "View",
                              .noun = "view",
                              .choices = viewNames,
                              .doc = "What the picture shows of the frame",
                              .stage = Stage::Nothing}),
    settingRow<&Frame::errorRange>({.name = "view.error-range",
                                    .key = "frame.errorRange",
                                    .option = "--error-range",
                                    .takes = "E",
                                    .group = view,
                                    .title = "Error range",
                                    .noun = "error range",
                                    .low = Frame::smallestErrorRange,
                                    .high = 1.0,
                                    .doc = "The error that has its full colour in the view of "
                                           "errors, so that small ones are seen",
                                    .stage = Stage::Nothing},
                                   withoutErrors)};

}  // namespace

std::span<const SettingRow<FrameSettings>> kernelRows() {
  return ofPrefilter;
}

std::span<const SettingRow<FrameSettings>> readRows() {
  return ofRead;
}

}  // namespace umbra
