// The ray-traced visibility of the probe's region, computed beside the interface thread.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "filters/core/maps/Cascades.h"
#include "filters/core/maps/Region.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

class Prober;
class RayTracedVisibility;
class SceneView;
class SessionController;

// Follows the probe: while one is traced, only the latest of those that come after it is kept. What
// rays have met is kept for as long as the shadow maps stay as they are.
class RayTracedTruth : public QObject {
  Q_OBJECT

 public:
  RayTracedTruth(SessionController& controller, SceneView& view, Prober& prober,
                 QObject* parent = nullptr);
  ~RayTracedTruth() override;

  // A scene has surfaces that rays can meet, a depth file has none.
  bool applies() const;
  // The ray-traced visibility of the probe that was last reported; none until it is known.
  const std::optional<double>& visibility() const { return visibility_; }

 signals:
  void traced();  // visibility() is known, of the probe that was last reported

 private:
  struct Job {
    int number = 0;                    // of the report
    std::shared_ptr<const void> maps;  // Baked::maps
    std::shared_ptr<const Scene> scene;
    std::vector<Cascade> cascades;
    int mapSize = 0;
    bool cullFrontFaces = false;
    Region region;
    double receiver = 0.0;
  };

  void follow();
  std::optional<Job> jobOf() const;
  void start(Job job);
  void finished(int number, std::optional<double> visibility);

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  std::optional<double> visibility_;
  int reports_ = 0;
  std::optional<Job> next_;  // while another one is traced
  bool busy_ = false;
  // The thread's alone while it is busy: the rays and the map that they are for.
  std::unique_ptr<RayTracedVisibility> rays_;
  std::shared_ptr<const void> raysOf_;
  std::jthread thread_;  // ends before what it uses
};

}  // namespace umbra
