// The white, thinly bordered container that every pane of the window is.
#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace umbra {

class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(const QString& title = {}, QWidget* parent = nullptr);

  // An empty title hides the title line, such as in a dock that has a title bar of its own.
  void setTitle(const QString& title);
  QString title() const;

  // What the card contains goes in here.
  QVBoxLayout* body() { return body_; }
  // To the right of the title, at the line's end.
  void addToHeader(QWidget* widget);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QLabel* title_;
  QHBoxLayout* header_;
  QVBoxLayout* body_;
};

}  // namespace umbra
