#include "ui/window/menus/SceneMenu.h"

#include "datasets/scenes/SceneCatalogue.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/files/FileActions.h"
#include "ui/window/files/FileKinds.h"

namespace umbra {

SceneMenu::SceneMenu(SessionController& controller, FileActions& files, QWidget* parent)
    : QMenu(tr("&Scene"), parent) {
  setToolTipsVisible(true);
  for (const SceneInfo& info : sceneCatalogue()) {
    QAction* action = addAction(style::text(info.title));
    const QString about = style::text(info.description + "\n" + info.figure).trimmed();
    action->setToolTip(info.missing.empty() ? about : style::text(info.missing));
    action->setEnabled(info.missing.empty());
    connect(action, &QAction::triggered, this, [&controller, name = info.name] {
      SceneSource source;
      source.name = name;
      controller.openSource(source);
    });
  }
  addSeparator();
  addAction(tr("Open mesh …"), this, [&files] { files.askToOpen(tr("Open mesh"), meshFilter()); });
  addAction(tr("Open depth map …"), this,
            [&files] { files.askToOpen(tr("Open depth map"), depthFilter()); });
  addAction(tr("Open session …"), this,
            [&files] { files.askToOpen(tr("Open session"), tr("Session (*.json)")); });
}

}  // namespace umbra
