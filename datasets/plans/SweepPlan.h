// A sweep: every combination of some settings, each a cell that is measured. As JSON:
//
// {"format": "umbrascope-sweep/1",
//  "base": {"source": {"depth": "m.exr"}, "receiver": 0.7}   a session, or the name of its file
//  "axes": [{"setting": "technique", "values": ["vsm", "esm"]},
//           {"setting": "kernel.radius", "range": [1, 9, 5]}          five values, both ends
//           {"setting": "vsm.min-variance", "log": [1e-7, 1e-4, 4], "when": {"technique": "vsm"}},
//           {"zip": [{"setting": "map.size", "values": [512, 1024]},
//                    {"setting": "kernel.radius", "values": [2, 4]}]}]  stepped together
//  "combine": "product" | "zip",
//  "skip": [{"technique": "esm", "kernel.radius": [7, 9]}],            cells that match all of one
//  "measures": ["compare", "decomposition", "probe", "cost", "picture"]}
//
// An axis names "technique", "scene", "scene.PARAMETER", "mesh", "depth", "receiver", "probe" (a
// pixel), a setting of the table or TECHNIQUE.PARAMETER. One with "when" is left out of cells that
// do not match it.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datasets/session/Workspace.h"

namespace umbra {

inline constexpr const char* sweepFormat = "umbrascope-sweep/1";
// More are a mistake: at a tenth of a second each they take a day.
inline constexpr std::size_t mostCells = 1'000'000;

enum class SweepMeasure { Compare, Decomposition, Probe, Cost, Picture };
std::string_view nameOf(SweepMeasure measure);

using SweepValue = nlohmann::ordered_json;
// What one cell sets, in the order of the axes.
using SweepCell = std::vector<std::pair<std::string, SweepValue>>;

struct SweepPlan {
  Workspace base;
  std::vector<std::string> settings;  // of all axes, each once, in their order
  std::vector<SweepCell> cells;       // in the plan's order: the last axis changes fastest
  std::vector<SweepMeasure> measures;
  // Without it a depth map is measured in double, which is stored nowhere.
  bool namesFormat = false;
  std::filesystem::path folder;           // what paths in cells are relative to
  std::set<std::filesystem::path> files;  // meshes and depth maps that cells are measured of
  std::string fingerprint;                // of all that bears on what cells hold, files as well
};

// Throws BadInput that begins with `where`, for a key, a setting or a value that is wrong.
// `folder` is what paths in the plan are relative to.
// Every cell is checked; `between` is called now and then, and may throw to end that.
SweepPlan sweepPlanFrom(
    std::string_view text, std::string_view where, const std::filesystem::path& folder,
    const std::function<void()>& between = [] {});
SweepPlan readSweepPlan(
    const std::filesystem::path& file, const std::function<void()>& between = [] {});

// A plan of cells that are listed instead of spanned by axes. `base` is as in a file. Throws as the
// above.
SweepPlan sweepPlanOfCells(const nlohmann::ordered_json& base, std::vector<SweepCell> cells,
                           std::vector<SweepMeasure> measures, std::string_view where,
                           const std::filesystem::path& folder);
// The measure of this name. Throws BadInput.
SweepMeasure sweepMeasureFrom(const nlohmann::ordered_json& value, const std::string& where);

}  // namespace umbra
