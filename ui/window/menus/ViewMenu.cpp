#include "ui/window/menus/ViewMenu.h"

#include <QActionGroup>
#include <QWidgetAction>

#include "ui/session/SessionController.h"
#include "ui/window/menus/CompareMenu.h"
#include "ui/window/menus/MenuActions.h"
#include "ui/window/menus/ViewpointForms.h"

namespace umbra {
namespace {

struct ViewEntry {
  ViewMode mode;
  const char* text;
  int key;
};
constexpr ViewEntry viewModes[] = {
    {ViewMode::Shaded, "Shaded", Qt::Key_F2},      {ViewMode::Visibility, "Visibility", Qt::Key_F3},
    {ViewMode::Error, "Signed error", Qt::Key_F4}, {ViewMode::Depth, "Depth", Qt::Key_F5},
    {ViewMode::Layers, "Layers", Qt::Key_F6},      {ViewMode::Cascades, "Cascades", Qt::Key_F7}};

}  // namespace

ViewMenu::ViewMenu(SessionController& controller, QWidget* parent)
    : QMenu(tr("&View"), parent), controller_(controller), modes_(new QActionGroup(this)) {
  addModes();
  compare_ = new CompareMenu(controller, this);
  addMenu(compare_);
  addSeparator();
  umbra::addAction(*this, tr("The scene's &camera"), QKeySequence("Home"), [this] {
    controller_.edit(tr("Reset camera"), [](Session& session) { session.camera.reset(); });
  });
  umbra::addAction(*this, tr("The scene's &light"), QKeySequence("Shift+Home"), [this] {
    controller_.edit(tr("Reset light"), [](Session& session) { session.light.reset(); });
  });
  addForm(tr("Ca&mera in numbers"), makeCameraForm(controller_));
  connect(&controller_, &SessionController::changed, this, &ViewMenu::refresh);
  refresh();
}

void ViewMenu::addForm(const QString& title, QWidget* form) {
  auto* action = new QWidgetAction(this);
  action->setDefaultWidget(form);
  addMenu(title)->addAction(action);
}

QList<QAction*> ViewMenu::modes() const {
  return modes_->actions();
}

void ViewMenu::addModes() {
  for (const ViewEntry& mode : viewModes) {
    QAction* action = umbra::addAction(*this, tr(mode.text), QKeySequence(mode.key), [this, mode] {
      controller_.edit(tr("View %1").arg(tr(mode.text).toLower()),
                       [&](Session& session) { session.frame.view = mode.mode; });
    });
    action->setCheckable(true);
    action->setData(int(mode.mode));
    modes_->addAction(action);
  }
}

void ViewMenu::refresh() {
  const bool onScene = controller_.document().content.scene != nullptr;
  for (QAction* action : modes_->actions()) {
    action->setChecked(action->data().toInt() == int(controller_.session().frame.view));
    action->setEnabled(onScene);
  }
}

}  // namespace umbra
