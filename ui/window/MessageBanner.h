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
  void showProgress(const QString& text);  // goes away by `dismiss` alone
  QString text() const;

 public slots:
  void dismiss();

 private:
  void showText(const QString& text, const QColor& edge, bool closable);

  QLabel* label_;
  QToolButton* close_;
};

}  // namespace umbra
