// The parameters of one technique, built from its field table.
#pragma once

#include <QMetaType>
#include <memory>
#include <vector>

#include "filters/core/technique/Technique.h"
#include "ui/widgets/base/Card.h"

class QLabel;

namespace umbra {

class ParameterRow;

class ParameterForm : public Card {
  Q_OBJECT

 public:
  explicit ParameterForm(QWidget* parent = nullptr);
  ~ParameterForm() override;

  // Shows the technique's values; emits nothing. For the technique that is already shown the rows
  // stay and only their values follow, so that a drag is not interrupted.
  void setTechnique(const Technique& technique);

  // A widget between the rows and what is below them; the form owns it.
  void setTools(QWidget* tools);

  // Sentences below the form, such as what Technique::limitTo returned; empty hides them.
  void setNotices(const QStringList& notices);

 signals:
  // Emitted with a value within the range at every change, also while a slider moves.
  void parameterChanged(const QString& name, const umbra::ParameterValue& value);
  // A slider was let go or a box was left: the next change is a new step for undo.
  void editingFinished(const QString& name);

 private:
  void rebuild();

  std::unique_ptr<Technique> shown_;  // a copy that the rows read
  std::vector<ParameterRow*> rows_;
  QLabel* empty_;
  QLabel* notices_;
  QLabel* source_;  // formula and citation
};

}  // namespace umbra

Q_DECLARE_METATYPE(umbra::ParameterValue)
