// One clear sentence above the picture, that stays until it is put away.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace umbra {

class MessageBanner : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBanner(QWidget* parent = nullptr);

  void showError(const QString& text);
  void showNotice(const QString& text);
  // Says that work goes on: the button asks to stop it, and the message goes away by `dismiss`.
  void showProgress(const QString& text);
  bool isProgress() const { return isProgress_ && !isHidden(); }
  QString text() const;

 public slots:
  void dismiss();

 signals:
  void stopAsked();

 private:
  void showText(const QString& text, const QColor& edge);

  QLabel* label_;
  QToolButton* close_;
  bool isProgress_ = false;
};

}  // namespace umbra
