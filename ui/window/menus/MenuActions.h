// What every menu needs.
#pragma once

#include <QKeySequence>
#include <functional>

class QAction;
class QMenu;

namespace umbra {

// At the end of the menu; `run` when it is chosen or its key is pressed. No key where it is empty.
QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& key,
                   const std::function<void()>& run);

}  // namespace umbra
