// What every menu needs.
#pragma once

#include <QKeySequence>
#include <functional>

class QAction;
class QMenu;

namespace umbra {

// Adds an action at the end of the menu and calls `run` when it is chosen or its key is pressed. An
// empty key is none.
QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& key,
                   const std::function<void()>& run);

}  // namespace umbra
