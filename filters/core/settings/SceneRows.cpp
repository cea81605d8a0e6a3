// The rows of the light and of the camera.
#include "filters/core/settings/SettingRow.h"
#include "filters/core/settings/SettingsTable.h"

namespace umbra {
namespace {

using detail::settingRow;

constexpr std::string_view group = "View";
constexpr std::string_view kinds[] = {"directional", "spot"};
constexpr std::string_view kindTitles[] = {"Directional", "Spot"};

std::string_view withoutCone(const Light& light) {
  return light.kind == LightKind::Spot ? "" : "a directional light has no cone";
}

constexpr SettingRow<Light> lightRows[] = {
    settingRow<&Light::kind>(
        {.name = "light.kind",
         .key = "light.kind",
         .option = "--light",
         .group = group,
         .title = "Light",
         .noun = "light",
         .choices = kinds,
         .doc = "Shines everywhere in one direction, or from a point in a cone",
         .choiceTitles = kindTitles,
         .stage = Stage::Depth}),
    settingRow<&Light::position>({.name = "light.position",
                                  .key = "light.position",
                                  .option = "--light",
                                  .group = group,
                                  .title = "Light's position",
                                  .noun = "light's position",
                                  .unit = "world units",
                                  .low = -largestCoordinate,
                                  .high = largestCoordinate,
                                  .doc = "Where the light is; a directional one shines from here",
                                  .reach = 20.0,
                                  .stage = Stage::Depth}),
    settingRow<&Light::target>({.name = "light.target",
                                .key = "light.target",
                                .option = "--light",
                                .group = group,
                                .title = "Light's target",
                                .noun = "light's target",
                                .unit = "world units",
                                .low = -largestCoordinate,
                                .high = largestCoordinate,
                                .doc = "The point that the light shines at",
                                .reach = 20.0,
                                .stage = Stage::Depth}),
    settingRow<&Light::halfAngle>({.name = "light.half-angle",
                                   .key = "light.halfAngle",
                                   .option = "--light",
                                   .group = group,
                                   .title = "Half angle",
                                   .noun = "half angle",
                                   .unit = "degrees",
                                   .low = Light::smallestHalfAngle,
                                   .high = Light::largestHalfAngle,
                                   .doc = "From the axis of a spot light to the edge of its cone",
                                   .greyedWhenIdle = true,
                                   .stage = Stage::Depth},
                                  withoutCone),
    settingRow<&Light::colour>({.name = "light.colour",
                                .key = "light.colour",
                                .option = "--light-colour",
                                .takes = "R,G,B",
                                .group = group,
                                .title = "Light's colour",
                                .noun = "light's colour",
                                .low = 0.0,
                                .high = 1.0,
                                .doc = "Linear red, green and blue of the light",
                                .stage = Stage::Shade}),
    settingRow<&Light::intensity>({.name = "light.intensity",
                                   .key = "light.intensity",
                                   .option = "--light-intensity",
                                   .takes = "I",
                                   .group = group,
                                   .title = "Intensity",
                                   .noun = "intensity",
                                   .low = 0.0,
                                   .high = Light::largestIntensity,
                                   .doc = "Factor of the light's colour",
                                   .reach = 4.0,
                                   .stage = Stage::Shade})};

constexpr SettingRow<Camera> cameraRows[] = {
    settingRow<&Camera::position>({.name = "camera.position",
                                   .key = "camera.position",
                                   .option = "--camera",
                                   .group = group,
                                   .title = "Camera's position",
                                   .noun = "camera's position",
                                   .unit = "world units",
                                   .low = -largestCoordinate,
                                   .high = largestCoordinate,
                                   .doc = "Where the picture is taken from",
                                   .reach = 20.0,
                                   .stage = Stage::Shade}),
    settingRow<&Camera::target>({.name = "camera.target",
                                 .key = "camera.target",
                                 .option = "--camera",
                                 .group = group,
                                 .title = "Camera's target",
                                 .noun = "camera's target",
                                 .unit = "world units",
                                 .low = -largestCoordinate,
                                 .high = largestCoordinate,
                                 .doc = "The point in the middle of the picture",
                                 .reach = 20.0,
                                 .stage = Stage::Shade}),
    settingRow<&Camera::up>({.name = "camera.up",
                             .key = "camera.up",
                             .option = "--camera-up",
                             .takes = "X,Y,Z",
                             .group = group,
                             .title = "Camera's up",
                             .noun = "camera's up vector",
                             .low = -largestCoordinate,
                             .high = largestCoordinate,
                             .doc = "The direction that is up in the picture",
                             .reach = 1.0,
                             .stage = Stage::Shade}),
    settingRow<&Camera::viewAngle>({.name = "camera.view-angle",
                                    .key = "camera.viewAngle",
                                    .option = "--camera",
                                    .group = group,
                                    .title = "View angle",
                                    .noun = "view angle",
                                    .unit = "degrees",
                                    .low = Camera::smallestViewAngle,
                                    .high = Camera::largestViewAngle,
                                    .doc = "From the picture's lower edge to its upper one",
                                    .stage = Stage::Shade})};

}  // namespace

std::span<const SettingRow<Light>> lightTable() {
  return lightRows;
}

std::span<const SettingRow<Camera>> cameraTable() {
  return cameraRows;
}

}  // namespace umbra
