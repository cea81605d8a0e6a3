// The menu that puts techniques beside each other.
#include <QActionGroup>
#include <QMenu>
#include <algorithm>

#include "datasets/session/PaneEditing.h"
#include "ui/panes/ComparisonPanes.h"
#include "ui/window/CentrePane.h"
#include "ui/window/MainWindow.h"

namespace umbra {
namespace {

struct Mode {
  ComparisonMode mode;
  const char* text;
  const char* key;
};
constexpr Mode comparisonModes[] = {{ComparisonMode::Single, "&One picture", "F8"},
                                    {ComparisonMode::Wipe, "&Wipe over two techniques", "F9"},
                                    {ComparisonMode::Grid, "&Panes side by side", "F11"}};
constexpr double wipeStep = 0.05;  // of the picture's width

}  // namespace

void MainWindow::makeCompareMenu(QMenu& view) {
  QMenu* menu = view.addMenu(tr("Com&pare"));
  menu->setObjectName("compare");
  menu->setToolTipsVisible(true);
  comparisons_ = new QActionGroup(this);
  for (const Mode& mode : comparisonModes) {
    QAction* action = addAction(*menu, tr(mode.text), QKeySequence(mode.key), [this, mode] {
      controller_.edit(tr("Compare techniques"),
                       [&](Session& session) { setMode(session, mode.mode); });
    });
    action->setCheckable(true);
    action->setData(int(mode.mode));
    comparisons_->addAction(action);
  }
  menu->addSeparator();
  duplicate_ =
      addAction(*menu, tr("&Duplicate, with settings of its own"), QKeySequence("Ctrl+D"), [this] {
        controller_.edit(tr("Duplicate pane"), [](Session& session) {
          duplicatePane(session, comparisonOf(session).active);
        });
      });
  duplicate_->setToolTip(
      tr("The same beside it, such as with another radius: the copy is set by itself"));
  QMenu* counts = menu->addMenu(tr("&Number of panes"));
  std::vector<std::string> known;
  for (const Technique* technique : controller_.catalogue().all())
    known.emplace_back(technique->info().id);
  for (std::size_t count = Comparison::fewest; count <= Comparison::most; ++count)
    addAction(*counts, tr("%1 panes").arg(count),
              QKeySequence(QStringLiteral("Ctrl+%1").arg(count)), [this, count, known] {
                controller_.edit(tr("Show %1 panes").arg(count),
                                 [&](Session& session) { setPaneCount(session, count, known); });
              });
  menu->addSeparator();
  const auto moveWipe = [this](double by) {
    controller_.edit(
        tr("Move wipe"),
        [&](Session& session) {
          double& at = session.comparison.wipe;
          at = std::clamp(at + by, 0.0, 1.0);
        },
        "wipe");
  };
  addAction(*menu, tr("Wipe to the &left"), QKeySequence("Ctrl+Left"),
            [moveWipe] { moveWipe(-wipeStep); });
  addAction(*menu, tr("Wipe to the &right"), QKeySequence("Ctrl+Right"),
            [moveWipe] { moveWipe(wipeStep); });
}

void MainWindow::refreshCompareMenu() {
  const bool onScene = controller_.document().content.scene != nullptr;
  const Comparison comparison = comparisonOf(controller_.session());
  duplicate_->setEnabled(onScene && (comparison.mode != ComparisonMode::Grid ||
                                     comparison.panes.size() < Comparison::most));
  for (QAction* action : comparisons_->actions()) {
    action->setChecked(action->data().toInt() == int(controller_.session().comparison.mode));
    action->setEnabled(onScene);
  }
}

}  // namespace umbra
