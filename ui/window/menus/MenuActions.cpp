#include "ui/window/menus/MenuActions.h"

#include <QAction>
#include <QMenu>

namespace umbra {

QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& key,
                   const std::function<void()>& run) {
  QAction* action = menu.addAction(text);
  action->setShortcut(key);
  QObject::connect(action, &QAction::triggered, &menu, run);
  return action;
}

}  // namespace umbra
