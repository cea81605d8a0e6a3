#include "ui/window/files/BleedingExport.h"

#include <QProgressDialog>

#include "filters/core/support/Error.h"
#include "ui/errors/SurfaceExport.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/files/Attempt.h"
#include "ui/window/files/FileDialogs.h"

namespace umbra {
namespace {

QString textOf(const SurfaceSummary& summary) {
  const SurfaceSums& all = summary.all;
  QString text = BleedingExport::tr("no surface bleeds visibly.");
  if (all.worst) {
    const Eigen::Vector3d& p = all.worst->position;
    text = BleedingExport::tr("light bleeds on %1 of %2 square units, most by %3 at (%4, %5, %6).")
               .arg(style::figure(all.bleedingArea), style::figure(all.area),
                    style::figure(all.worst->error), style::figure(p.x()), style::figure(p.y()),
                    style::figure(p.z()));
  }
  const SurfaceMeshSettings asked;
  if (summary.edge <= asked.edge) return text;
  return text + BleedingExport::tr(
                    " The mesh's edges are up to %1 texels long in place of %2, which would "
                    "add more than %L3 faces to the scene's.")
                    .arg(summary.edge)
                    .arg(asked.edge)
                    .arg(qulonglong(asked.mostFaces));
}

}  // namespace

BleedingExport::BleedingExport(QWidget& window, FileDialogs& dialogs, SessionController& controller,
                               SceneView& view, Prober& prober)
    : QObject(&window),
      window_(window),
      dialogs_(dialogs),
      controller_(controller),
      view_(view),
      prober_(prober),
      work_(new SurfaceExport(this)) {
  connect(work_, &SurfaceExport::failed, this, &BleedingExport::failed);
  connect(work_, &SurfaceExport::cancelled, this,
          [this] { emit message(tr("Cancelled; no file was written.")); });
  connect(work_, &SurfaceExport::written, this,
          [this](const QString& file, const SurfaceSummary& summary) {
            emit written(tr("Wrote %1: %2").arg(file, textOf(summary)));
          });
}

QString BleedingExport::refusal() const {
  const Document& document = controller_.document();
  if (!prober_.veil().isEmpty()) return prober_.veil();
  if (!document.content.scene)
    return tr("A depth map has no surfaces to write on; open a scene or a mesh.");
  const QString refusal = controller_.refusals().value(style::text(document.session.technique));
  if (!refusal.isEmpty()) return refusal;
  const std::string reason = whyNoSurfaceErrors(document.session.frame);
  if (!reason.empty()) return tr("Bleeding on the mesh: %1.").arg(style::text(reason));
  if (work_->busy()) return tr("A mesh is being written; wait until it is there.");
  return {};
}

void BleedingExport::start(const std::filesystem::path& file) {
  if (const QString reason = refusal(); !reason.isEmpty())
    throw Error(ErrorKind::BadCommandLine, reason.toStdString());
  if (view_.stale()) view_.repaint();
  if (!view_.lastFrame())
    throw Error(ErrorKind::WorkFailed, tr("The picture cannot be drawn.").toStdString());
  ShadowRenderer& frame = *view_.lastFrame();
  SurfaceJob job{controller_.document().content.scene,
                 frame.lightFrame(),
                 frame.depthMap(),
                 controller_.session().frame,
                 controller_.technique().clone(),
                 true};
  // The mesh shows the splits that the picture shows.
  if (const std::vector<double> splits = frame.adaptedSplits(); !splits.empty()) {
    job.technique->setAdaptedSplits(splits);
    job.adapts = false;
  }
  work_->start(job, file);
}

// A refusal is told before a person is asked where to write.
void BleedingExport::ask() {
  if (const QString reason = refusal(); !reason.isEmpty()) {
    emit failed(reason);
    return;
  }
  const QString name =
      QStringLiteral("bleeding-%1.vtp").arg(style::text(controller_.session().technique));
  const auto file =
      dialogs_.askWhere(tr("Export bleeding on the mesh"), name,
                        tr("VTK PolyData, for ParaView (*.vtp);;PLY, for MeshLab (*.ply)"));
  if (!file) return;
  attempt(
      [&] {
        start(*file);
        showProgress();
      },
      [this](const QString& problem) { emit failed(problem); });
}

void BleedingExport::showProgress() {
  auto* dialog = new QProgressDialog(tr("Reading the shadow map on every surface …"), tr("Cancel"),
                                     0, 100, &window_);
  dialog->setWindowTitle(tr("Bleeding on the mesh"));
  dialog->setWindowModality(Qt::WindowModal);
  dialog->setMinimumDuration(300);
  dialog->setAutoReset(false);
  connect(dialog, &QProgressDialog::canceled, work_, &SurfaceExport::cancel);
  connect(work_, &SurfaceExport::progressed, dialog, &QProgressDialog::setValue);
  connect(work_, &SurfaceExport::failed, dialog, &QObject::deleteLater);
  connect(work_, &SurfaceExport::written, dialog, &QObject::deleteLater);
  connect(work_, &SurfaceExport::cancelled, dialog, &QObject::deleteLater);
}

}  // namespace umbra
