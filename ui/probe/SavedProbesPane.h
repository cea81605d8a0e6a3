// The table of the saved probes and what can be done with them.
#pragma once

#include "ui/widgets/base/Card.h"

class QLabel;
class QTableView;
class QToolButton;

namespace umbra {

class SavedProbes;
class SavedProbesModel;
class Prober;
class SessionController;

class SavedProbesPane : public Card {
  Q_OBJECT

 public:
  SavedProbesPane(SavedProbes& probes, SessionController& controller, Prober& prober,
                  QWidget* parent = nullptr);

  QTableView& view() { return *view_; }
  QToolButton& saveButton() { return *save_; }
  // None without probes, and while a veil hides the figures.
  QString asText(char separator) const;
  void editName(int row);

 private:
  void makeTable();
  void makeHeader();
  void makeMenu();
  void refresh();
  void arrangeColumns();
  void select(int row);  // −1 for none
  QString hint() const;

  SavedProbes& probes_;
  SessionController& controller_;
  Prober& prober_;
  SavedProbesModel* model_;
  QTableView* view_;
  QLabel* hint_;
  QToolButton *save_, *errors_, *copy_;
  int selected_ = -1;
};

}  // namespace umbra
