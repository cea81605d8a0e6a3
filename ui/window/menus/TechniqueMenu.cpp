#include "ui/window/menus/TechniqueMenu.h"

#include <QActionGroup>

#include "datasets/session/PaneChoice.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/TechniqueList.h"
#include "ui/window/menus/MenuActions.h"

namespace umbra {

TechniqueMenu::TechniqueMenu(SessionController& controller, QWidget* parent)
    : QMenu(tr("&Technique"), parent),
      controller_(controller),
      techniques_(new QActionGroup(this)) {
  setToolTipsVisible(true);
  addTechniques();
  addSeparator();
  umbra::addAction(*this, tr("Reset its &parameters"), {}, [this] {
    controller_.edit(tr("Reset parameters"),
                     [](Session& session) { session.parameters.erase(session.technique); });
  });
  connect(&controller_, &SessionController::changed, this, &TechniqueMenu::refresh);
  refresh();
}

void TechniqueMenu::addTechniques() {
  int place = 0;
  for (const Technique* technique : controller_.catalogue().all()) {
    const std::string id(technique->info().id);
    const QKeySequence key(techniqueKey(place));
    QAction* action =
        umbra::addAction(*this, style::text(technique->info().title), key, [this, id] {
          controller_.editPanes(tr("Choose technique"),
                                [&](Workspace& workspace) { chooseTechnique(workspace, id); });
        });
    action->setCheckable(true);
    action->setData(style::text(id));
    techniques_->addAction(action);
    ++place;
  }
}

void TechniqueMenu::refresh() {
  const QMap<QString, QString> refusals = controller_.refusals();
  for (QAction* action : techniques_->actions()) {
    const QString id = action->data().toString();
    const bool current = id == style::text(controller_.session().technique);
    const QString refusal = refusals.value(id);
    action->setChecked(current);
    action->setEnabled(current || refusal.isEmpty());
    action->setToolTip(refusal);
  }
}

}  // namespace umbra
