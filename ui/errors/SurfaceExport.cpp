#include "ui/errors/SurfaceExport.h"

#include <QMetaObject>
#include <exception>

#include "datasets/meshes/FieldMeshPly.h"
#include "filters/core/support/Error.h"
#include "filters/gpu/VtpFile.h"

namespace umbra {
namespace {

struct Stopped {};

std::string extensionOf(const std::filesystem::path& file) {
  return QString::fromStdU16String(file.extension().u16string()).toLower().toStdString();
}

void write(const FieldMesh& mesh, const std::filesystem::path& file) {
  if (extensionOf(file) == ".ply")
    writePly(mesh, file);
  else
    writeVtp(mesh, file);
}

}  // namespace

SurfaceExport::SurfaceExport(QObject* parent) : QObject(parent) {}

// Events that the thread has posted to this object die with it.
SurfaceExport::~SurfaceExport() = default;

void SurfaceExport::start(const SurfaceJob& job, const std::filesystem::path& file) {
  if (extensionOf(file) != ".vtp" && extensionOf(file) != ".ply")
    throw Error(ErrorKind::BadOutput, file.string() + ": a mesh is written as .vtp or .ply");
  busy_ = true;
  thread_ = std::jthread([this, job, file](const std::stop_token& stop) { run(job, file, stop); });
}

void SurfaceExport::cancel() {
  thread_.request_stop();
}

void SurfaceExport::finish(const std::function<void()>& report) {
  QMetaObject::invokeMethod(
      this,
      [this, report] {
        busy_ = false;
        report();
      },
      Qt::QueuedConnection);
}

void SurfaceExport::run(const SurfaceJob& job, const std::filesystem::path& file,
                        const std::stop_token& stop) {
  const auto check = [&stop] {
    if (stop.stop_requested()) throw Stopped{};
  };
  int shown = -1;
  const auto progress = [&](double done) {
    check();
    const int percent = int(100.0 * done);
    if (percent == shown) return;
    shown = percent;
    QMetaObject::invokeMethod(
        this, [this, percent] { emit progressed(percent); }, Qt::QueuedConnection);
  };
  try {
    if (job.adapts) job.technique->adapt(job.map);
    const SurfaceMesh mesh = surfaceMeshOf(*job.scene, job.light, job.map.width(), {}, check);
    const SurfaceErrors errors =
        surfaceErrors(mesh, {*job.scene, job.light, job.map, job.frame, *job.technique}, progress);
    check();
    write(errors.mesh, file);
    const QString name = QString::fromStdU16String(file.filename().u16string());
    finish([this, name, summary = errors.summary] { emit written(name, summary); });
  } catch (const Stopped&) {
    finish([this] { emit cancelled(); });
  } catch (const std::exception& problem) {
    finish([this, text = QString::fromUtf8(problem.what())] { emit failed(text); });
  }
}

}  // namespace umbra
