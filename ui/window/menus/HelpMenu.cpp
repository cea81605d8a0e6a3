#include "ui/window/menus/HelpMenu.h"

#include "ui/session/SessionController.h"
#include "ui/window/menus/HelpDialogs.h"
#include "ui/window/menus/MenuActions.h"

namespace umbra {

HelpMenu::HelpMenu(SessionController& controller, QWidget& window, QWidget* parent)
    : QMenu(tr("&Help"), parent), window_(window) {
  umbra::addAction(*this, tr("This &technique"), QKeySequence::HelpContents,
                   [&] { showTechniquePage(controller.technique(), &window); });
  umbra::addAction(*this, tr("&Keyboard and mouse"), {}, [this] { listKeys(); });
  umbra::addAction(*this, tr("&About Umbrascope"), {}, [&] { showAbout(&window); });
}

void HelpMenu::listKeys() {
  std::vector<std::pair<QString, QString>> keys{
      {tr("Probe the point under the pointer"), tr("move")},
      {tr("Hold the probe at a point"), tr("click")},
      {tr("Turn the camera"), tr("left drag")},
      {tr("Move the camera"), tr("middle drag, Shift + left drag")},
      {tr("Nearer, farther"), tr("wheel, right drag")},
      {tr("Move the light"), tr("drag the sun")},
      {tr("Study another receiver depth"), tr("drag the amber line in a plot")}};
  for (const QAction* action : window_.findChildren<QAction*>())
    if (!action->shortcut().isEmpty())
      keys.emplace_back(action->text().remove('&').remove(QStringLiteral(" …")),
                        action->shortcut().toString(QKeySequence::NativeText));
  showShortcuts(keys, &window_);
}

}  // namespace umbra
