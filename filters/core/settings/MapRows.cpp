#include "filters/core/settings/FrameRows.h"
#include "filters/core/settings/SettingRow.h"

namespace umbra {
namespace {

using detail::settingRow;
using Frame = FrameSettings;
using Text = std::string_view;

constexpr Text shadowMap = "Shadow map";

constexpr Text formatNames[] = {"unorm8", "unorm16", "half", "float", "double"};
constexpr std::size_t texturesTake = 4;  // of them, the first ones
constexpr Text formatLabels[] = {"8 bit", "16 bit", "half", "float", "double"};
constexpr Text frozenLabels[] = {"", "frozen"};
constexpr Text planeLabels[] = {"no receiver-plane bias", "receiver-plane bias"};
constexpr Text cullLabels[] = {"front faces kept", "front faces culled"};
constexpr Text sizeLabel[] = {"map #"}, samplesLabel[] = {"# samples"},
               countLabel[] = {"# cascades"}, lambdaLabel[] = {"split λ #"},
               seamLabel[] = {"seam #"}, constantLabel[] = {"bias #"},
               slopeLabel[] = {"slope bias #"};

constexpr int mapSizes[] = {16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192};
constexpr int sampleCounts[] = {1, 2, 4, 8};
constexpr int cascadeCounts[] = {1, 2, 3, 4};
static_assert(mapSizes[0] == MapSettings::smallest && mapSizes[9] == MapSettings::largest);
static_assert(sampleCounts[3] == MapSettings::largestSamples);
static_assert(cascadeCounts[3] == CascadeSettings::largestCount);

Text ofOneMap(const Frame& frame) {
  return frame.map.cascades.count > 1 ? "" : "there is one cascade";
}

constexpr SettingRow<Frame> ofMap[] = {
    settingRow<&Frame::map, &MapSettings::size>({.name = "map.size",
                                                 .key = "frame.mapSize",
                                                 .option = "--map-size",
                                                 .takes = "N",
                                                 .group = shadowMap,
                                                 .title = "Map",
                                                 .noun = "map size",
                                                 .unit = "texels",
                                                 .low = MapSettings::smallest,
                                                 .high = MapSettings::largest,
                                                 .doc = "Side of the shadow map",
                                                 .offered = mapSizes,
                                                 .offeredAs = "#²",
                                                 .labels = sizeLabel,
                                                 .pane = PaneSetting::MapSize,
                                                 .stage = Stage::Depth}),
    settingRow<&Frame::map, &MapSettings::format>({.name = "map.format",
                                                   .key = "frame.format",
                                                   .option = "--format",
                                                   .takes = "NAME",
                                                   .group = shadowMap,
                                                   .title = "Storage",
                                                   .noun = "format",
                                                   .choices = formatNames,
                                                   .doc = "How a channel is stored per texel; "
                                                          "double is for a depth map's file",
                                                   .offeredChoices = texturesTake,
                                                   .labels = formatLabels,
                                                   .pane = PaneSetting::Format,
                                                   .stage = Stage::Encode}),
    settingRow<&Frame::map, &MapSettings::samples>({.name = "map.samples",
                                                    .key = "frame.msaa",
                                                    .option = "--msaa",
                                                    .takes = "N",
                                                    .group = shadowMap,
                                                    .title = "Samples",
                                                    .noun = "samples",
                                                    .low = 1,
                                                    .high = MapSettings::largestSamples,
                                                    .values = sampleCounts,
                                                    .doc = "Depths a texel, as far as the driver "
                                                           "can; their channels are averaged",
                                                    .offered = sampleCounts,
                                                    .offeredAs = "#",
                                                    .labels = samplesLabel,
                                                    .pane = PaneSetting::Samples,
                                                    .stage = Stage::Depth}),
    settingRow<&Frame::map, &MapSettings::cascades, &CascadeSettings::count>(
        {.name = "cascades.count",
         .key = "frame.cascades.count",
         .option = "--cascades",
         .takes = "N",
         .group = shadowMap,
         .title = "Cascades",
         .noun = "cascades",
         .low = 1,
         .high = CascadeSettings::largestCount,
         .doc = "Parts of the view along its depth, each with a shadow map of its own",
         .offered = cascadeCounts,
         .offeredAs = "#",
         .labels = countLabel,
         .pane = PaneSetting::Cascades,
         .stage = Stage::Depth}),
    settingRow<&Frame::map, &MapSettings::cascades, &CascadeSettings::splitLambda>(
        {.name = "cascades.split-lambda",
         .key = "frame.cascades.splitLambda",
         .option = "--split-lambda",
         .takes = "L",
         .group = shadowMap,
         .title = "Split λ",
         .noun = "split lambda",
         .symbol = "λ",
         .low = 0.0,
         .high = 1.0,
         .doc = "Where cascades cut the view: 0 evenly, 1 logarithmically",
         .labels = lambdaLabel,
         .pane = PaneSetting::Cascades,
         .stage = Stage::Depth},
        ofOneMap),
    settingRow<&Frame::map, &MapSettings::cascades, &CascadeSettings::seam>(
        {.name = "cascades.seam",
         .key = "frame.cascades.seam",
         .option = "--cascade-seam",
         .takes = "S",
         .group = shadowMap,
         .title = "Seam",
         .noun = "cascade seam",
         .low = 0.0,
         .high = CascadeSettings::largestSeam,
         .doc = "The last part of a cascade, over which it goes over into the next",
         .labels = seamLabel,
         .pane = PaneSetting::Cascades,
         .stage = Stage::Depth},
        ofOneMap),
    settingRow<&Frame::map, &MapSettings::cascades, &CascadeSettings::frozen>(
        {.name = "cascades.frozen",
         .key = "frame.cascades.frozen",
         .group = shadowMap,
         .title = "Freeze cascades",
         .noun = "frozen cascades",
         .doc = "They stay where the camera is now, so that one can look at them",
         .labels = frozenLabels,
         .pane = PaneSetting::Cascades,
         .stage = Stage::Depth},
        ofOneMap),
    settingRow<&Frame::bias, &Bias::constant>({.name = "bias.constant",
                                               .key = "frame.bias.constant",
                                               .option = "--bias-constant",
                                               .takes = "D",
                                               .group = shadowMap,
                                               .title = "Constant bias",
                                               .noun = "constant bias",
                                               .low = 0.0,
                                               .high = Bias::largestConstant,
                                               .doc = "Depth taken off every receiver, as a part "
                                                      "of the light's range",
                                               .reach = 0.05,
                                               .labels = constantLabel,
                                               .pane = PaneSetting::Bias,
                                               .stage = Stage::Shade}),
    settingRow<&Frame::bias, &Bias::slope>({.name = "bias.slope",
                                            .key = "frame.bias.slope",
                                            .option = "--bias-slope",
                                            .takes = "T",
                                            .group = shadowMap,
                                            .title = "Slope bias",
                                            .noun = "slope bias",
                                            .unit = "texels",
                                            .low = 0.0,
                                            .high = Bias::largestSlope,
                                            .doc = "The depth that the receiver's plane gains over "
                                                   "so many texels is taken off as well",
                                            .reach = 8.0,
                                            .labels = slopeLabel,
                                            .pane = PaneSetting::Bias,
                                            .stage = Stage::Shade}),
    settingRow<&Frame::bias, &Bias::receiverPlane>({.name = "bias.receiver-plane",
                                                    .key = "frame.bias.receiverPlane",
                                                    .option = "--bias-receiver-plane",
                                                    .takes = "on|off",
                                                    .group = shadowMap,
                                                    .title = "Receiver-plane bias",
                                                    .noun = "receiver plane",
                                                    .doc = "The plane's slope over half the filter "
                                                           "region is taken off too, so that no "
                                                           "tap of a plane blocks the plane",
                                                    .labels = planeLabels,
                                                    .pane = PaneSetting::Bias,
                                                    .stage = Stage::Shade}),
    settingRow<&Frame::bias, &Bias::cullFrontFaces>({.name = "bias.cull-front-faces",
                                                     .key = "frame.bias.cullFrontFaces",
                                                     .option = "--cull-front-faces",
                                                     .takes = "on|off",
                                                     .group = shadowMap,
                                                     .title = "Cull front faces",
                                                     .noun = "front-face culling",
                                                     .doc = "Casters' faces towards the light "
                                                            "leave no depth",
                                                     .labels = cullLabels,
                                                     .pane = PaneSetting::Bias,
                                                     .stage = Stage::Depth})};

}  // namespace

std::span<const SettingRow<FrameSettings>> mapRows() {
  return ofMap;
}

}  // namespace umbra
