#include "ui/panes/PaneMenu.h"

#include "ui/session/SessionController.h"

namespace umbra {
namespace {

struct Own {
  PaneSetting setting;
  const char* text;
};
// The words are those of the controls.
constexpr Own ownSettings[] = {
    {PaneSetting::Parameters, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Parameters of the technique")},
    {PaneSetting::Kernel, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Kernel and radius")},
    {PaneSetting::Read, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Read")},
    {PaneSetting::Format, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Storage")},
    {PaneSetting::MapSize, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Map")},
    {PaneSetting::Samples, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Samples")},
    {PaneSetting::Cascades, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Cascades")},
    {PaneSetting::Bias, QT_TRANSLATE_NOOP("umbra::PaneMenu", "Bias")}};

}  // namespace

PaneMenu::PaneMenu(SessionController& controller, std::size_t pane, QWidget* parent)
    : QMenu(parent), controller_(controller), pane_(pane), own_(new QMenu(this)) {
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &PaneMenu::fill);
}

void PaneMenu::fill() {
  clear();
  const Comparison comparison = comparisonOf(controller_.workspace());
  if (pane_ >= comparison.panes.size()) return;
  const Pane& pane = comparison.panes[pane_];
  const bool full =
      comparison.mode == ComparisonMode::Grid && comparison.panes.size() == Comparison::most;
  add(tr("&Duplicate this pane"),
      full ? tr("There is room for six panes")
           : tr("The same beside it, such as with another radius: the copy is set by itself"),
      !full, duplicatePane);
  add(tr("&Same settings as the active pane"), tr("What the controls show now"),
      pane_ != comparison.active, copyActiveSettings);
  addSeparator();
  QAction* linked = addAction(tr("S&hare settings with the other panes"));
  linked->setCheckable(true);
  linked->setChecked(pane.linked());
  linked->setToolTip(tr("What one sets in one of the panes that share is set in all of them"));
  connect(linked, &QAction::triggered, this, [this](bool on) {
    controller_.editPanes(on ? tr("Share settings") : tr("Settings of its own"),
                          [&](Workspace& workspace) { setLinked(workspace, pane_, on); });
  });
  fillOwn(pane);
  addSeparator();
  add(tr("&Close this pane"), {}, true, closePane);
}

void PaneMenu::fillOwn(const Pane& pane) {
  own_->clear();
  own_->setTitle(tr("Settings &of its own"));
  for (const Own& own : ownSettings) {
    QAction* action = own_->addAction(tr(own.text));
    action->setCheckable(true);
    action->setChecked(hasOwn(pane, own.setting));
    connect(action, &QAction::triggered, this, [this, own](bool on) {
      controller_.editPanes(
          on ? tr("Settings of its own") : tr("Share settings"),
          [&](Workspace& workspace) { setOwn(workspace, pane_, own.setting, on); });
    });
  }
  addMenu(own_);
}

void PaneMenu::add(const QString& text, const QString& help, bool possible,
                   void (*change)(Workspace&, std::size_t)) {
  QAction* action = addAction(text);
  action->setToolTip(help);
  action->setEnabled(possible);
  connect(action, &QAction::triggered, this, [this, text, change] {
    controller_.editPanes(QString(text).remove('&'),
                          [&](Workspace& workspace) { change(workspace, pane_); });
  });
}

}  // namespace umbra
