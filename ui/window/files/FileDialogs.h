// Asks a person which file to read or to write.
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>

class QWidget;

namespace umbra {

std::filesystem::path toPath(const QString& text);
QString toText(const std::filesystem::path& path);

// The dialogs stand over one window.
class FileDialogs : public QObject {
  Q_OBJECT

 public:
  explicit FileDialogs(QWidget& window);

  // None where the person cancels.
  std::optional<std::filesystem::path> askWhich(const QString& title, const QString& filter);
  // `name` is suggested; its extension is added where the person gave none.
  std::optional<std::filesystem::path> askWhere(const QString& title, const QString& name,
                                                const QString& filter);
  // Asks where, calls `write` with the file and reports how it went: `write` may throw.
  void askAndWrite(const QString& title, const QString& name, const QString& filter,
                   const std::function<void(const std::filesystem::path&)>& write);

 signals:
  void message(const QString& text);    // which file was written
  void failed(const QString& problem);  // one line for people

 private:
  QWidget& window_;
};

}  // namespace umbra
