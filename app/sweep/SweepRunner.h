// Measures the cells of a sweep, one after the other.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "app/display/DisplayLibrary.h"
#include "app/options/SceneSources.h"
#include "app/output/Output.h"
#include "datasets/plans/SweepPlan.h"

namespace umbra {

// Keeps the picture of a cell, a PNG, and gives the name that its row has for it.
using KeepPicture = std::function<std::string(std::size_t cell, const std::string& png)>;

class SweepRunner {
 public:
  // Messages about cells begin with `where`, the plan's file.
  SweepRunner(const SweepPlan& plan, std::string where, KeepPicture keepPicture);
  ~SweepRunner();
  SweepRunner(const SweepRunner&) = delete;
  SweepRunner& operator=(const SweepRunner&) = delete;

  // {"cell": 0, "settings": {…}, "technique": "vsm", "compare": {…}, "probe": {…},
  //  "picture": "…"}; what was not asked for is absent. A cell whose settings cannot stand together
  // has a "reason" instead; one whose values were limited has "notices", and the "parameters" that
  // were used. Scenes and maps are read once, and of a frame only what the last cell
  // had otherwise is drawn. Throws what ends all cells: a file that cannot be read, no OpenGL,
  // Cancelled.
  Json measured(std::size_t cell);

 private:
  bool asks(SweepMeasure measure) const;
  void measureMap(const Session& session, const std::shared_ptr<Technique>& technique, Json& row);
  void measureScene(const Session& session, const std::shared_ptr<Technique>& technique,
                    std::size_t cell, Json& row);
  void measureFrame(const Session& session, const std::shared_ptr<Technique>& technique,
                    const std::shared_ptr<const Scene>& scene, std::size_t cell, Json& row);

  const SweepPlan& plan_;
  const std::string where_;
  const KeepPicture keepPicture_;
  const TechniqueCatalogue catalogue_ = allTechniques();
  SceneLoader scenes_;
  std::optional<SceneSource> mapSource_;  // of map_
  std::optional<DepthFile> map_;
  std::set<std::string> said_;  // notices that the log has had
  std::unique_ptr<Display> display_;
  std::unique_ptr<HeadlessFrame> frame_;
};

}  // namespace umbra
