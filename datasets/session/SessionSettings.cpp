#include "datasets/session/SessionSettings.h"

#include <algorithm>
#include <memory>

namespace umbra {
namespace {

SettingValue sizeOf(const Session& session, const SettingInfo&) {
  return std::vector<double>{double(session.width), double(session.height)};
}

void setSize(Session& session, const SettingInfo&, const SettingValue& value) {
  const auto& sides = std::get<std::vector<double>>(value);
  session.width = int(sides[0]);
  session.height = int(sides[1]);
}

constexpr SettingRow<Session> pictureRows[] = {{{.name = "picture.size",
                                                 .key = "size",
                                                 .option = "--size",
                                                 .takes = "WxH",
                                                 .group = "View",
                                                 .title = "Picture",
                                                 .noun = "picture's size",
                                                 .unit = "pixels",
                                                 .low = Session::smallestSide,
                                                 .high = Session::largestSide,
                                                 .doc = "Width and height of a rendered picture",
                                                 .stage = Stage::Shade,
                                                 .kind = SettingKind::Size},
                                                sizeOf,
                                                setSize}};

template <class P>
std::vector<Setting> boundTo(std::span<const SettingRow<P>> table, P& values) {
  std::vector<Setting> settings;
  for (const SettingRow<P>& row : table) settings.push_back(bound(row, values));
  return settings;
}

// Adds the rows of a light or camera, which a session may leave to its scene.
template <class P>
void addOptional(std::vector<Setting>& settings, std::span<const SettingRow<P>> table,
                 std::optional<P>& own, const P& scenes) {
  const auto shared = std::make_shared<const P>(scenes);
  for (const SettingRow<P>& row : table) {
    const auto current = [&own, shared]() -> const P& { return own ? *own : *shared; };
    settings.push_back(
        {row.info, row.defaultValue(), [&row, current] { return row.valueIn(current()); },
         [&row, &own, shared](const SettingValue& value) {
           if (!own) own = *shared;
           row.putInto(*own, value);
         },
         [&row, current] { return row.whyIdle ? row.whyIdle(current()) : std::string_view(); }});
  }
}

template <class P>
Stage firstStale(const std::optional<P>& before, const std::optional<P>& after, Stage ifOneOnly) {
  if (before && after) return firstStaleStage(*before, *after);
  return before.has_value() == after.has_value() ? Stage::Nothing : ifOneOnly;
}

}  // namespace

std::span<const SettingRow<Session>> pictureTable() {
  return pictureRows;
}

bool isOfScene(const SettingInfo& info) {
  return info.name.starts_with("light.") || info.name.starts_with("camera.");
}

std::vector<Setting> settingsOf(FrameSettings& frame) {
  return boundTo(frameTable(), frame);
}

std::vector<Setting> settingsOf(Light& light) {
  return boundTo(lightTable(), light);
}

std::vector<Setting> settingsOf(Camera& camera) {
  return boundTo(cameraTable(), camera);
}

std::vector<Setting> pictureSettingsOf(Session& session) {
  return boundTo(pictureTable(), session);
}

std::vector<Setting> settingsOf(Session& session, const Light& sceneLight,
                                const Camera& sceneCamera) {
  std::vector<Setting> settings = settingsOf(session.frame);
  addOptional(settings, lightTable(), session.light, sceneLight);
  addOptional(settings, cameraTable(), session.camera, sceneCamera);
  for (Setting& setting : pictureSettingsOf(session)) settings.push_back(std::move(setting));
  return settings;
}

Stage firstStaleStage(const Session& before, const Session& after) {
  if (!(before.source == after.source)) return Stage::Depth;
  Stage first = firstStaleStage(before.frame, after.frame);
  first = std::min(first, firstStale(before.light, after.light, Stage::Depth));
  first = std::min(first, firstStale(before.camera, after.camera, Stage::Shade));
  if (before.technique != after.technique ||
      parametersOf(before, before.technique) != parametersOf(after, after.technique))
    first = std::min(first, Stage::Encode);
  for (const auto& row : pictureTable())
    if (row.valueIn(before) != row.valueIn(after)) first = std::min(first, row.info.stage);
  return first;
}

}  // namespace umbra
