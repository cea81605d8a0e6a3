#include "filters/core/settings/SettingsTable.h"

#include <algorithm>

#include "filters/core/settings/FrameRows.h"
#include "filters/core/settings/SettingRow.h"

namespace umbra {
namespace {

template <class P>
Stage firstStale(std::span<const SettingRow<P>> table, const P& before, const P& after) {
  Stage first = Stage::Nothing;
  if (before == after) return first;
  for (const SettingRow<P>& row : table) {
    if (row.idleIn(before) && row.idleIn(after)) continue;
    if (row.valueIn(before) == row.valueIn(after)) continue;
    first = std::min(first, row.staleBy ? row.staleBy(before, after) : row.info.stage);
  }
  return first;
}

std::vector<SettingRow<FrameSettings>> frameRows() {
  std::vector<SettingRow<FrameSettings>> rows;
  for (const auto& part : {kernelRows(), mapRows(), readRows()})
    rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

}  // namespace

std::span<const SettingRow<FrameSettings>> frameTable() {
  static const std::vector<SettingRow<FrameSettings>> rows = frameRows();
  return rows;
}

Stage firstStaleStage(const FrameSettings& before, const FrameSettings& after) {
  return firstStale(frameTable(), before, after);
}

Stage firstStaleStage(const Light& before, const Light& after) {
  return firstStale(lightTable(), before, after);
}

Stage firstStaleStage(const Camera& before, const Camera& after) {
  return firstStale(cameraTable(), before, after);
}

std::vector<double> detail::numbersOf(const std::optional<Camera>& camera) {
  if (!camera) return {};
  const auto& [position, target, up, angle] = *camera;
  return {position.x(), position.y(), position.z(), target.x(), target.y(),
          target.z(),   up.x(),       up.y(),       up.z(),     angle};
}

std::optional<Camera> detail::cameraFrom(const std::vector<double>& numbers) {
  if (numbers.size() != 10) return std::nullopt;
  const double* n = numbers.data();
  return Camera{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9]};
}

}  // namespace umbra
