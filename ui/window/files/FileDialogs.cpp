#include "ui/window/files/FileDialogs.h"

#include <QFileDialog>

#include "ui/window/files/Attempt.h"

namespace umbra {

namespace fs = std::filesystem;

fs::path toPath(const QString& text) {
  return fs::path(text.toStdU16String());
}

QString toText(const fs::path& path) {
  return QString::fromStdU16String(path.u16string());
}

FileDialogs::FileDialogs(QWidget& window) : QObject(&window), window_(window) {}

std::optional<fs::path> FileDialogs::askWhich(const QString& title, const QString& filter) {
  const QString chosen = QFileDialog::getOpenFileName(&window_, title, {}, filter);
  if (chosen.isEmpty()) return std::nullopt;
  return toPath(chosen);
}

std::optional<fs::path> FileDialogs::askWhere(const QString& title, const QString& name,
                                              const QString& filter) {
  const QString chosen = QFileDialog::getSaveFileName(&window_, title, name, filter);
  if (chosen.isEmpty()) return std::nullopt;
  fs::path file = toPath(chosen);
  if (!file.has_extension()) file += toPath(name).extension();
  return file;
}

void FileDialogs::askAndWrite(const QString& title, const QString& name, const QString& filter,
                              const std::function<void(const fs::path&)>& write) {
  const auto file = askWhere(title, name, filter);
  if (!file) return;
  attempt(
      [&] {
        write(*file);
        emit message(tr("Wrote %1").arg(toText(*file)));
      },
      [this](const QString& problem) { emit failed(problem); });
}

}  // namespace umbra
