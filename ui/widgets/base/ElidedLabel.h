// One line of plain text that is cut with an ellipsis where there is too little room for it.
#pragma once

#include <QLabel>

namespace umbra {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace umbra
