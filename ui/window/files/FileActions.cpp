#include "ui/window/files/FileActions.h"

#include <QBuffer>

#include "datasets/lessons/LessonFile.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/maps/Raster.h"
#include "datasets/session/file/SessionFile.h"
#include "datasets/session/file/SessionInExr.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/session/SessionController.h"
#include "ui/window/files/Attempt.h"
#include "ui/window/files/FileDialogs.h"
#include "ui/window/files/RecentFiles.h"
#include "ui/window/files/SavedSession.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

std::string lowerExtension(const fs::path& file) {
  return toText(file.extension()).toLower().toStdString();
}

}  // namespace

FileActions::FileActions(FileDialogs& dialogs, SessionController& controller, SceneView& view,
                         Prober& prober, ComparisonPanes& panes, QObject* parent)
    : QObject(parent),
      dialogs_(dialogs),
      controller_(controller),
      view_(view),
      prober_(prober),
      panes_(panes) {}

void FileActions::open(const fs::path& file) {
  const auto read = [&] {
    std::error_code none;
    const fs::path named = splitDepthArgument(file.string()).first;
    if (fs::is_regular_file(named, none)) rememberFile(file);
    if (lowerExtension(file) == ".json") {
      if (looksLikeLesson(file))
        emit lessonOpened(readLesson(file));
      else
        controller_.open(readWorkspace(file));
      return;
    }
    const auto [path, channel] = splitDepthArgument(file.string());
    // What this program wrote brings back what it was made of; with a channel it is a depth map.
    if (channel.empty() && rasterReaderOf(path) == readExr && sessionInExr(path))
      return controller_.open(readWorkspace(path));
    SceneSource source;
    source.kind = rasterReaderOf(path) ? SourceKind::DepthFile : SourceKind::MeshFile;
    source.name = fs::absolute(path).string();
    source.depth.channel = channel;
    controller_.openSource(source);
  };
  attempt(read, [this](const QString& problem) { emit failed(problem); });
}

void FileActions::saveSession(const fs::path& file) {
  writeWorkspace(sessionToSave(controller_, view_, prober_), file);
  rememberFile(file);
}

void FileActions::savePicture(const fs::path& file) {
  if (lowerExtension(file) != ".png")
    throw Error(ErrorKind::BadOutput, file.string() + ": a picture is written as .png");
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!panes_.snapshot().save(&buffer, "PNG"))
    throw Error(ErrorKind::BadOutput, file.string() + ": the picture cannot be encoded as PNG");
  writeTextAtomically(file, std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

void FileActions::askToOpen(const QString& title, const QString& filter) {
  if (const auto file = dialogs_.askWhich(title, filter)) open(*file);
}

void FileActions::askToSaveSession() {
  dialogs_.askAndWrite(tr("Save session"), "session.json", tr("Session (*.json)"),
                       [this](const fs::path& file) { saveSession(file); });
}

void FileActions::askToSavePicture() {
  if (!controller_.document().content.scene) {
    emit failed(tr("A depth map has no picture; its plots and tables can be exported."));
    return;
  }
  dialogs_.askAndWrite(tr("Export picture"), "picture.png", tr("Picture (*.png)"),
                       [this](const fs::path& file) { savePicture(file); });
}

}  // namespace umbra
