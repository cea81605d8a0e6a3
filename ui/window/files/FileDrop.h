// Opens the file that is dropped onto a window, wherever in it.
#pragma once

#include <QObject>

class QDropEvent;
class QWidget;

namespace umbra {

class FileActions;

class FileDrop : public QObject {
  Q_OBJECT

 public:
  FileDrop(QWidget& window, FileActions& files);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool take(QDropEvent& event, bool dropped);

  FileActions& files_;
};

}  // namespace umbra
