// Writes a technique's bleeding onto the scene's mesh, beside the interface's thread.
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>
#include <thread>

#include "analysis/surfaces/SurfaceErrors.h"

namespace umbra {

// All that the work needs, so that the window may go on meanwhile.
struct SurfaceJob {
  std::shared_ptr<const Scene> scene;
  LightFrame light;
  DepthMap map;
  FrameSettings frame;
  std::shared_ptr<Technique> technique;
  bool adapts = true;  // the technique is still to follow the map
};

class SurfaceExport : public QObject {
  Q_OBJECT

 public:
  explicit SurfaceExport(QObject* parent = nullptr);
  // Cancels the work, and waits until its thread has ended.
  ~SurfaceExport() override;

  bool busy() const { return busy_; }
  // Writes a .vtp or .ply file; throws BadOutput for another one. The work ends in `written`,
  // `failed` or `cancelled`, on the thread of this object. Must not be called while busy.
  void start(const SurfaceJob& job, const std::filesystem::path& file);

 public slots:
  // The file stays as it was before.
  void cancel();

 signals:
  void progressed(int percent);
  // `name` is the file's, without its folder.
  void written(const QString& name, const umbra::SurfaceSummary& summary);
  void failed(const QString& message);  // one line for people
  void cancelled();

 private:
  void run(const SurfaceJob& job, const std::filesystem::path& file, const std::stop_token& stop);
  void finish(const std::function<void()>& report);

  bool busy_ = false;
  std::jthread thread_;
};

}  // namespace umbra
