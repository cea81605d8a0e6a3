// Writes the light bleeding of the session's technique onto the scene's mesh.
#pragma once

#include <QObject>
#include <filesystem>

namespace umbra {

class FileDialogs;
class Prober;
class SceneView;
class SessionController;
class SurfaceExport;

class BleedingExport : public QObject {
  Q_OBJECT

 public:
  // What was asked for by `ask` shows its progress in a dialog over `window`.
  BleedingExport(QWidget& window, FileDialogs& dialogs, SessionController& controller,
                 SceneView& view, Prober& prober);

  // Why the session has nothing to write; empty where it has.
  QString refusal() const;
  // Writes a .vtp or .ply file, beside this thread. Throws where there is a refusal.
  void start(const std::filesystem::path& file);
  void ask();
  // The work itself, which announces its progress and its end.
  SurfaceExport& work() { return *work_; }

 signals:
  void message(const QString& text);
  void written(const QString& summary);  // what the mesh shows, in one sentence
  void failed(const QString& problem);   // one line for people

 private:
  void showProgress();

  QWidget& window_;
  FileDialogs& dialogs_;
  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  SurfaceExport* work_;
};

}  // namespace umbra
