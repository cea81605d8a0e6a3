// "Why is it lit?": a technique's evaluation at the probe, step by step, and the step that errs.
#pragma once

#include "filters/core/technique/Trace.h"
#include "ui/widgets/base/Card.h"

class QLabel;
class QTableWidget;

namespace umbra {

class TracePane : public Card {
  Q_OBJECT

 public:
  explicit TracePane(QWidget* parent = nullptr);

  // The last value of the trace is the visibility of the technique with this title.
  void setTrace(const QString& technique, const Trace& trace);
  // Removes the steps and shows a hint in their place; an empty one says how to get steps.
  void clear(const QString& hint = {});

  // Sentence and steps as plain text; empty without a trace.
  QString asText() const { return text_; }
  QTableWidget* view() { return view_; }
  QString sentence() const;

 public slots:
  void copy() const;  // asText to the clipboard

 private:
  void setStep(int row, const TraceStep& step, bool culprit);

  QLabel* sentence_;
  QTableWidget* view_;
  QString text_;
};

}  // namespace umbra
