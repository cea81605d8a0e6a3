// How the file is read: what a person can correct while the picture follows.
#pragma once

#include <QDialog>
#include <optional>

#include "datasets/maps/DepthGuesses.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace umbra {

class DepthImportForm;
class ElidedLabel;
class ImportDraft;
class PlotPane;
class SessionController;

class ImportSheet : public QDialog {
  Q_OBJECT

 public:
  // The dialog stands over the window, which stays usable.
  ImportSheet(QWidget& window, SessionController& controller);

  // Whether the open document is a file, which can be read in several ways.
  bool available() const;
  void showSheet();

 signals:
  // A refusal is told here, so that it needs no place elsewhere.
  void refused();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeDepthPart();
  QWidget* makeMeshPart();
  void refresh();
  void showFile();
  void showProblem(const QString& problem);
  void showDepth();
  void showGuesses();
  void showNotes();
  void take();
  void apply(const DepthGuess& guess);

  SessionController& controller_;
  ImportDraft* draft_;
  ElidedLabel* name_;
  QLabel *size_, *problem_, *notes_, *guessTitle_;
  QWidget *depthPart_, *meshPart_;
  PlotPane* plot_;
  DepthImportForm* form_;
  QVBoxLayout* guesses_;
  QComboBox* up_;
  std::optional<DepthImport> shown_;  // what the form was last set to, or said itself
  QString formProblem_;               // of what stands in the form and was given to nobody
};

}  // namespace umbra
