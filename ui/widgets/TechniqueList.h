// All techniques in teaching order, to switch between them.
#pragma once

#include <vector>

#include "filters/core/Technique.h"
#include "ui/widgets/Card.h"

class QListWidget;

namespace umbra {

class TechniqueList : public Card {
  Q_OBJECT

 public:
  explicit TechniqueList(QWidget* parent = nullptr);

  // As TechniqueCatalogue::all() gives them; the first ten show the digit 0–9 that selects them.
  // The digits are only written here: the window owns the shortcuts.
  void setTechniques(const std::vector<const Technique*>& techniques);
  // Highlights the technique; emits nothing. An unknown id highlights none.
  void setCurrent(const QString& id);
  QString current() const;

 signals:
  // By click or arrow key, never by setCurrent.
  void techniqueChosen(const QString& id);

 private:
  QListWidget* list_;
};

}  // namespace umbra
