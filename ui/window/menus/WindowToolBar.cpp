#include "ui/window/menus/WindowToolBar.h"

#include <QLabel>
#include <QToolButton>
#include <QWidgetAction>

#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/menus/CompareMenu.h"
#include "ui/window/menus/ExportMenu.h"
#include "ui/window/menus/SceneForm.h"
#include "ui/window/menus/SceneMenu.h"
#include "ui/window/menus/ViewMenu.h"
#include "ui/window/menus/ViewpointForms.h"
#include "ui/window/menus/WindowMenus.h"

namespace umbra {

WindowToolBar::WindowToolBar(SessionController& controller, WindowMenus& menus, QWidget* parent)
    : QToolBar(tr("Tools"), parent),
      controller_(controller),
      sceneForm_(new SceneForm(controller)) {
  setObjectName("tools");
  setMovable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  scene_ = addMenuButton(tr("Scene"), &menus.scene());
  adjust_ = addMenuButton(tr("Adjust"), menuOf(sceneForm_));
  addMenuButton(tr("Light"), menuOf(makeLightForm(controller_)));
  addWidget(new QLabel(tr("View")));
  addActions(menus.view().modes());
  addMenuButton(tr("Compare"), &menus.view().compare());
  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  addWidget(space);
  addMenuButton(tr("Export …"), &menus.exports());
  connect(&controller_, &SessionController::changed, this, &WindowToolBar::refresh);
  refresh();
}

QToolButton* WindowToolBar::addMenuButton(const QString& text, QMenu* menu) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  addWidget(button);
  return button;
}

QMenu* WindowToolBar::menuOf(QWidget* form) {
  auto* menu = new QMenu(this);
  auto* action = new QWidgetAction(menu);
  action->setDefaultWidget(form);
  menu->addAction(action);
  return menu;
}

void WindowToolBar::refresh() {
  const SceneSource& source = controller_.session().source;
  scene_->setText(tr("Scene: %1")
                      .arg(source.kind == SourceKind::Catalogue ? style::text(source.name)
                                                                : style::text(titleOf(source))));
  adjust_->setEnabled(sceneForm_->adjustable());
}

}  // namespace umbra
