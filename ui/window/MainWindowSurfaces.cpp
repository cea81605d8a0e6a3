// Bleeding written onto the mesh.
#include <QProgressDialog>
#include <QStatusBar>

#include "filters/core/support/Error.h"
#include "ui/errors/SurfaceExport.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MainWindow.h"
#include "ui/window/MessageBanner.h"

namespace umbra {
namespace {

QString textOf(const SurfaceSummary& summary) {
  const SurfaceSums& all = summary.all;
  QString text = MainWindow::tr("no surface bleeds visibly.");
  if (all.worst) {
    const Eigen::Vector3d& p = all.worst->position;
    text = MainWindow::tr("light bleeds on %1 of %2 square units, most by %3 at (%4, %5, %6).")
               .arg(style::figure(all.bleedingArea), style::figure(all.area),
                    style::figure(all.worst->error), style::figure(p.x()), style::figure(p.y()),
                    style::figure(p.z()));
  }
  const SurfaceMeshSettings asked;
  if (summary.edge <= asked.edge) return text;
  return text + MainWindow::tr(
                    " The mesh's edges are up to %1 texels long in place of %2, which would "
                    "add more than %L3 faces to the scene's.")
                    .arg(summary.edge)
                    .arg(asked.edge)
                    .arg(qulonglong(asked.mostFaces));
}

}  // namespace

// The first reason that stands against it, before a person is asked where to.
QString MainWindow::whyNoSurfaces() const {
  const Document& document = controller_.document();
  if (!prober_->veil().isEmpty()) return prober_->veil();
  if (!document.content.scene)
    return tr("A depth map has no surfaces to write on; open a scene or a mesh.");
  const QString refusal = controller_.refusals().value(style::text(document.session.technique));
  if (!refusal.isEmpty()) return refusal;
  const std::string reason = whyNoSurfaceErrors(document.session.frame);
  if (!reason.empty()) return tr("Bleeding on the mesh: %1.").arg(style::text(reason));
  if (surfaces_->busy()) return tr("A mesh is being written; wait until it is there.");
  return {};
}

void MainWindow::makeSurfaceExport() {
  surfaces_ = new SurfaceExport(this);
  connect(surfaces_, &SurfaceExport::failed, this, &MainWindow::showError);
  connect(surfaces_, &SurfaceExport::cancelled, this,
          [this] { statusBar()->showMessage(tr("Cancelled; no file was written."), 6000); });
  connect(surfaces_, &SurfaceExport::written, this,
          [this](const QString& file, const SurfaceSummary& summary) {
            centre_->banner().showNotice(tr("Wrote %1: %2").arg(file, textOf(summary)));
          });
}

void MainWindow::exportBleeding(const std::filesystem::path& file) {
  if (const QString reason = whyNoSurfaces(); !reason.isEmpty())
    throw Error(ErrorKind::BadCommandLine, reason.toStdString());
  if (view_->stale()) view_->repaint();
  if (!view_->lastFrame())
    throw Error(ErrorKind::WorkFailed, tr("The picture cannot be drawn.").toStdString());
  ShadowRenderer& frame = *view_->lastFrame();
  SurfaceJob job{controller_.document().content.scene,
                 frame.lightFrame(),
                 frame.depthMap(),
                 controller_.session().frame,
                 controller_.technique().clone(),
                 true};
  // As in the picture.
  if (const std::vector<double> splits = frame.adaptedSplits(); !splits.empty()) {
    job.technique->setAdaptedSplits(splits);
    job.adapts = false;
  }
  surfaces_->start(job, file);
}

void MainWindow::askToExportBleeding() {
  if (const QString reason = whyNoSurfaces(); !reason.isEmpty()) return showError(reason);
  const QString name =
      QStringLiteral("bleeding-%1.vtp").arg(style::text(controller_.session().technique));
  const auto file = askWhere(tr("Export bleeding on the mesh"), name,
                             tr("VTK PolyData, for ParaView (*.vtp);;PLY, for MeshLab (*.ply)"));
  if (!file) return;
  attempt([&] {
    exportBleeding(*file);
    auto* dialog = new QProgressDialog(tr("Reading the shadow map on every surface …"),
                                       tr("Cancel"), 0, 100, this);
    dialog->setWindowTitle(tr("Bleeding on the mesh"));
    dialog->setWindowModality(Qt::WindowModal);
    dialog->setMinimumDuration(300);
    dialog->setAutoReset(false);
    connect(dialog, &QProgressDialog::canceled, surfaces_, &SurfaceExport::cancel);
    connect(surfaces_, &SurfaceExport::progressed, dialog, &QProgressDialog::setValue);
    connect(surfaces_, &SurfaceExport::failed, dialog, &QObject::deleteLater);
    connect(surfaces_, &SurfaceExport::written, dialog, &QObject::deleteLater);
    connect(surfaces_, &SurfaceExport::cancelled, dialog, &QObject::deleteLater);
  });
}

}  // namespace umbra
