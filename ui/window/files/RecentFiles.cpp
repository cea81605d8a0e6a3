#include "ui/window/files/RecentFiles.h"

#include <QSettings>
#include <QStringList>

#include "ui/window/files/FileDialogs.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

constexpr const char* recentKey = "window/recent";
constexpr int mostRecent = 10;

}  // namespace

std::vector<fs::path> recentFiles() {
  std::vector<fs::path> files;
  for (const QString& file : QSettings().value(recentKey).toStringList())
    files.push_back(toPath(file));
  return files;
}

void rememberFile(const fs::path& file) {
  const QString name = toText(fs::absolute(file).lexically_normal());
  QSettings settings;
  QStringList names = settings.value(recentKey).toStringList();
  names.removeAll(name);
  names.prepend(name);
  settings.setValue(recentKey, QStringList(names.mid(0, mostRecent)));
}

void forgetRecentFiles() {
  QSettings().remove(recentKey);
}

}  // namespace umbra
