#include "ui/window/files/FileDrop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

#include "ui/window/files/FileActions.h"
#include "ui/window/files/FileDialogs.h"

namespace umbra {
namespace {

// The first local file that is dragged; empty where there is none.
QString fileIn(const QMimeData& data) {
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

}  // namespace

FileDrop::FileDrop(QWidget& window, FileActions& files) : QObject(&window), files_(files) {
  window.setAcceptDrops(true);
  window.installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove)
    return take(*static_cast<QDropEvent*>(event), false);
  if (event->type() == QEvent::Drop) return take(*static_cast<QDropEvent*>(event), true);
  return QObject::eventFilter(watched, event);
}

// A file of any kind is taken: one that cannot be opened is refused with the reason.
bool FileDrop::take(QDropEvent& event, bool dropped) {
  const QString file = fileIn(*event.mimeData());
  if (file.isEmpty()) return false;
  event.setDropAction(Qt::CopyAction);
  event.accept();
  if (dropped) files_.open(toPath(file));
  return true;
}

}  // namespace umbra
