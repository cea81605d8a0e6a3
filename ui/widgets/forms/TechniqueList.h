// All techniques in teaching order, to switch between them.
#pragma once

#include <QMap>
#include <vector>

#include "filters/core/technique/Technique.h"
#include "ui/widgets/base/Card.h"

class QListWidget;

namespace umbra {

// The key that selects the technique at this place of the list: 0 to 9, then M; empty after these.
QString techniqueKey(int place);

class TechniqueList : public Card {
  Q_OBJECT

 public:
  explicit TechniqueList(QWidget* parent = nullptr);

  // As TechniqueCatalogue::all() gives them; each shows its key (techniqueKey). The keys
  // are only written here: the window owns the shortcuts.
  void setTechniques(const std::vector<const Technique*>& techniques);
  // Highlights the technique; emits nothing. An unknown id highlights none.
  void setCurrent(const QString& id);
  QString current() const;
  // Greys out what cannot be chosen; the reasons by id, shown as tool tips.
  void setRefusals(const QMap<QString, QString>& reasons);

 signals:
  // Emitted after a click or an arrow key, never by setCurrent.
  void techniqueChosen(const QString& id);

 private:
  QListWidget* list_;
};

}  // namespace umbra
