#include "ui/window/menus/CompareMenu.h"

#include <QActionGroup>
#include <algorithm>

#include "datasets/session/PaneChoice.h"
#include "datasets/session/PaneEditing.h"
#include "ui/session/SessionController.h"
#include "ui/window/menus/MenuActions.h"

namespace umbra {
namespace {

struct ComparisonEntry {
  ComparisonMode mode;
  const char* text;
  const char* key;
};
constexpr ComparisonEntry comparisonModes[] = {
    {ComparisonMode::Single, "&One picture", "F8"},
    {ComparisonMode::Wipe, "&Wipe over two techniques", "F9"},
    {ComparisonMode::Grid, "&Panes side by side", "F11"}};
constexpr double wipeStep = 0.05;  // of the picture's width

}  // namespace

CompareMenu::CompareMenu(SessionController& controller, QWidget* parent)
    : QMenu(tr("Com&pare"), parent), controller_(controller), modes_(new QActionGroup(this)) {
  setObjectName("compare");
  setToolTipsVisible(true);
  addModes();
  addSeparator();
  addDuplicate();
  addCounts();
  addSeparator();
  addWipe();
  connect(&controller_, &SessionController::changed, this, &CompareMenu::refresh);
  refresh();
}

void CompareMenu::addModes() {
  for (const ComparisonEntry& mode : comparisonModes) {
    QAction* action = umbra::addAction(*this, tr(mode.text), QKeySequence(mode.key), [this, mode] {
      controller_.editPanes(tr("Compare techniques"),
                            [&](Workspace& workspace) { setMode(workspace, mode.mode); });
    });
    action->setCheckable(true);
    action->setData(int(mode.mode));
    modes_->addAction(action);
  }
}

void CompareMenu::addDuplicate() {
  duplicate_ = umbra::addAction(
      *this, tr("&Duplicate, with settings of its own"), QKeySequence("Ctrl+D"), [this] {
        controller_.editPanes(tr("Duplicate pane"), [](Workspace& workspace) {
          duplicatePane(workspace, comparisonOf(workspace).active);
        });
      });
  duplicate_->setToolTip(
      tr("The same beside it, such as with another radius: the copy is set by itself"));
}

void CompareMenu::addCounts() {
  QMenu* counts = addMenu(tr("&Number of panes"));
  std::vector<std::string> known;
  for (const Technique* technique : controller_.catalogue().all())
    known.emplace_back(technique->info().id);
  for (std::size_t count = Comparison::fewest; count <= Comparison::most; ++count)
    umbra::addAction(*counts, tr("%1 panes").arg(count),
                     QKeySequence(QStringLiteral("Ctrl+%1").arg(count)), [this, count, known] {
                       controller_.editPanes(
                           tr("Show %1 panes").arg(count),
                           [&](Workspace& workspace) { setPaneCount(workspace, count, known); });
                     });
}

void CompareMenu::addWipe() {
  const auto moveWipe = [this](double by) {
    controller_.editPanes(
        tr("Move wipe"),
        [&](Workspace& workspace) {
          double& at = workspace.comparison.wipe;
          at = std::clamp(at + by, 0.0, 1.0);
        },
        "wipe");
  };
  umbra::addAction(*this, tr("Wipe to the &left"), QKeySequence("Ctrl+Left"),
                   [moveWipe] { moveWipe(-wipeStep); });
  umbra::addAction(*this, tr("Wipe to the &right"), QKeySequence("Ctrl+Right"),
                   [moveWipe] { moveWipe(wipeStep); });
}

void CompareMenu::refresh() {
  const bool onScene = controller_.document().content.scene != nullptr;
  const Comparison comparison = comparisonOf(controller_.workspace());
  duplicate_->setEnabled(onScene && (comparison.mode != ComparisonMode::Grid ||
                                     comparison.panes.size() < Comparison::most));
  for (QAction* action : modes_->actions()) {
    action->setChecked(action->data().toInt() == int(controller_.workspace().comparison.mode));
    action->setEnabled(onScene);
  }
}

}  // namespace umbra
