#include "ui/window/WindowMemory.h"

#include <QFileInfo>
#include <QGuiApplication>
#include <QScreen>
#include <QSettings>
#include <algorithm>
#include <exception>
#include <filesystem>

#include "datasets/session/file/SessionFile.h"
#include "ui/window/MainWindow.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

// This number is raised when docks are added or renamed, so that an older arrangement is not put
// back.
constexpr int arrangement = 2;

// The last session is a session file like any other; it lies beside the settings.
fs::path sessionFile() {
  const QString folder = QFileInfo(QSettings().fileName()).absolutePath();
  return fs::path((folder + "/last-session.json").toStdU16String());
}

}  // namespace

std::optional<Workspace> lastSession() {
  const fs::path file = sessionFile();
  std::error_code none;
  if (!fs::exists(file, none)) return std::nullopt;
  try {
    return readWorkspace(file);
  } catch (const std::exception&) {
    return std::nullopt;  // of another version, or damaged: start afresh
  }
}

void restoreWindow(MainWindow& window) {
  const QSettings settings;
  const QByteArray geometry = settings.value("window/geometry").toByteArray();
  const QByteArray docks = settings.value("window/docks").toByteArray();
  if (geometry.isEmpty() || !window.restoreGeometry(geometry)) {
    const QSize room = window.screen() ? window.screen()->availableSize() : QSize(1280, 720);
    window.resize(room.boundedTo({1660, 965}));
  }
  if (docks.isEmpty() || !window.restoreState(docks, arrangement)) window.resetLayout();
}

void rememberWindow(MainWindow& window) {
  QSettings settings;
  settings.setValue("window/geometry", window.saveGeometry());
  settings.setValue("window/docks", window.saveState(arrangement));
  settings.sync();
  try {
    writeWorkspace(window.sessionToRemember(), sessionFile());
  } catch (const std::exception&) {
    return;  // the next start begins with the default scene
  }
}

}  // namespace umbra
