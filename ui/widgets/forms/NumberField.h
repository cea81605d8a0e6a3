// A number as text, with every digit that it has; empty stands for none.
#pragma once

#include <QLineEdit>
#include <optional>

namespace umbra {

class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);

  // Emits nothing.
  void setNumber(const std::optional<double>& number);
  // Nothing where the field is empty, or holds no number.
  std::optional<double> number() const;
  // Whether what stands there is a number, or nothing.
  bool isRight() const;

 signals:
  void numberEdited();  // by a person who left the field or pressed Return

 private:
  void showWhetherRight();

  QString known_;  // what was set or announced last
};

}  // namespace umbra
