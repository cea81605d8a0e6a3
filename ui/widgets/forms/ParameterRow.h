// One parameter of a technique as a row of a form, made for the parameter's type.
#pragma once

#include <QWidget>
#include <memory>

#include "filters/core/support/Parameters.h"

class QLabel;
class QToolButton;
class QVBoxLayout;
class QHBoxLayout;

namespace umbra {

class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  // Shows the parameter's value. `parameter` is copied; what it is bound to must live until the
  // next `follow`.
  static ParameterRow* make(const Parameter& parameter, QWidget* parent);

  // The same parameter of another instance: shows its value, emits nothing.
  void follow(const Parameter& parameter);
  QString name() const;

 signals:
  void changed(const umbra::ParameterValue& value);  // within range
  void finished();

 protected:
  ParameterRow(const Parameter& parameter, QWidget* parent);
  virtual void showValue(const ParameterValue& value) = 0;

  // Stores it in what the row is bound to, shows whether it differs from the default, and emits.
  void take(const ParameterValue& value);
  const Parameter& parameter() const { return parameter_; }
  // Beside the label, and beneath it over the whole width.
  void addBeside(QWidget* editor);
  void addBeneath(QWidget* editor);

 private:
  void showReset();

  Parameter parameter_;
  QToolButton* reset_;
  QHBoxLayout* line_;
  QVBoxLayout* rows_;
};

}  // namespace umbra
