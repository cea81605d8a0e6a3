// Opens what a person chooses, and writes session and picture.
#pragma once

#include <QObject>
#include <filesystem>

#include "datasets/lessons/Lesson.h"

namespace umbra {

class ComparisonPanes;
class FileDialogs;
class Prober;
class SceneView;
class SessionController;

class FileActions : public QObject {
  Q_OBJECT

 public:
  FileActions(FileDialogs& dialogs, SessionController& controller, SceneView& view, Prober& prober,
              ComparisonPanes& panes, QObject* parent = nullptr);

  // Opens what the file's extension says: a mesh, a depth map, a session or a lesson (.json), and
  // remembers it. A lesson is announced; anything else becomes the session, and its source is read
  // beside this thread.
  void open(const std::filesystem::path& file);
  // Throw BadOutput.
  void saveSession(const std::filesystem::path& file);
  void savePicture(const std::filesystem::path& file);  // PNG, as shown with the probe

  void askToOpen(const QString& title, const QString& filter);
  void askToSaveSession();
  void askToSavePicture();

 signals:
  void lessonOpened(const umbra::Lesson& lesson);
  void failed(const QString& problem);  // one line for people

 private:
  FileDialogs& dialogs_;
  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  ComparisonPanes& panes_;
};

}  // namespace umbra
