// What the window reads and writes.
#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QStatusBar>
#include <algorithm>
#include <exception>

#include "datasets/lessons/LessonFile.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/EvidencePanes.h"
#include "ui/probe/KeptProbesPane.h"
#include "ui/probe/Prober.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MainWindow.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

fs::path toPath(const QString& text) {
  return fs::path(text.toStdU16String());
}
QString toText(const fs::path& path) {
  return QString::fromStdU16String(path.u16string());
}

std::string lowerExtension(const fs::path& file) {
  return toText(file.extension()).toLower().toStdString();
}

}  // namespace

void MainWindow::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& problem) {
    showError(QString::fromUtf8(problem.what()));
  }
}

void MainWindow::openFile(const fs::path& file) {
  attempt([&] {
    if (lowerExtension(file) == ".json") {
      if (looksLikeLesson(file)) return enterLesson(readLesson(file));
      controller_.open(readSession(file));
      return;
    }
    const auto [path, channel] = splitDepthArgument(file.string());
    SceneSource source;
    source.kind = lowerExtension(path) == ".exr" ? SourceKind::DepthFile : SourceKind::MeshFile;
    source.name = fs::absolute(path).string();
    source.channel = channel;
    controller_.openSource(source);
  });
}

void MainWindow::saveSession(const fs::path& file) {
  writeSession(sessionToSave(), file);
}

void MainWindow::savePicture(const fs::path& file) {
  if (lowerExtension(file) != ".png")
    throw Error(ErrorKind::BadOutput, file.string() + ": a picture is written as .png");
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!centre_->comparison().snapshot().save(&buffer, "PNG"))
    throw Error(ErrorKind::BadOutput, file.string() + ": the picture cannot be encoded as PNG");
  writeTextAtomically(file, std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

std::optional<fs::path> MainWindow::askWhere(const QString& title, const QString& name,
                                             const QString& filter) {
  const QString chosen = QFileDialog::getSaveFileName(this, title, name, filter);
  if (chosen.isEmpty()) return std::nullopt;
  fs::path file = toPath(chosen);
  if (!file.has_extension()) file += fs::path(name.toStdU16String()).extension();
  return file;
}

void MainWindow::askToOpen(const QString& title, const QString& filter) {
  const QString chosen = QFileDialog::getOpenFileName(this, title, {}, filter);
  if (!chosen.isEmpty()) openFile(toPath(chosen));
}

void MainWindow::askToSaveSession() {
  const auto file = askWhere(tr("Save session"), "session.json", tr("Session (*.json)"));
  if (!file) return;
  attempt([&] {
    saveSession(*file);
    statusBar()->showMessage(tr("Wrote %1").arg(toText(*file)), 6000);
  });
}

void MainWindow::askToSavePicture() {
  if (!controller_.document().content.scene)
    return showError(tr("A depth map has no picture; its plots and tables can be exported."));
  const auto file = askWhere(tr("Export picture"), "picture.png", tr("Picture (*.png)"));
  if (!file) return;
  attempt([&] {
    savePicture(*file);
    statusBar()->showMessage(tr("Wrote %1").arg(toText(*file)), 6000);
  });
}

void MainWindow::askToSaveTable() {
  const auto file =
      askWhere(tr("Export table"), "techniques.tsv", tr("Tab-separated values (*.tsv *.txt)"));
  if (!file) return;
  attempt([&] {
    writeTextAtomically(*file, evidence_->table().asText().toStdString());
    statusBar()->showMessage(tr("Wrote %1").arg(toText(*file)), 6000);
  });
}

void MainWindow::askToSaveKeptProbes() {
  if (!prober_->veil().isEmpty()) return showError(prober_->veil());
  if (keptPane_->asText(',').isEmpty())
    return showError(tr("There is no table of kept probes to export: keep a probe first (K)."));
  const auto file =
      askWhere(tr("Export kept probes"), "probes.csv", tr("Comma-separated values (*.csv)"));
  if (!file) return;
  attempt([&] {
    writeTextAtomically(*file, keptPane_->asText(',').toStdString());
    statusBar()->showMessage(tr("Wrote %1").arg(toText(*file)), 6000);
  });
}

}  // namespace umbra
