#include "ui/window/menus/ExportMenu.h"

#include "ui/probe/EvidencePanes.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/window/files/BleedingExport.h"
#include "ui/window/files/FileActions.h"
#include "ui/window/files/TableExport.h"
#include "ui/window/menus/MenuActions.h"

namespace umbra {

ExportMenu::ExportMenu(FileActions& files, BleedingExport& bleeding, TableExport& tables,
                       EvidencePanes& evidence, QWidget* parent)
    : QMenu(tr("&Export"), parent) {
  const auto add = [this](const QString& text, const std::function<void()>& run) {
    return umbra::addAction(*this, text, {}, run);
  };
  add(tr("Picture …"), [&] { files.askToSavePicture(); })->setShortcut(QKeySequence("Ctrl+E"));
  add(tr("Bleeding on the mesh …"), [&] { bleeding.ask(); });
  addSeparator();
  add(tr("Visibility plot …"), [&] { evidence.curves().saveAs(); });
  add(tr("Depths plot …"), [&] { evidence.histogram().saveAs(); });
  add(tr("Distribution plot …"), [&] { evidence.cdf().saveAs(); });
  add(tr("Table of techniques …"), [&] { tables.askToSaveTechniques(); });
  add(tr("Table of saved probes …"), [&] { tables.askToSaveProbes(); });
  addSeparator();
  add(tr("Session …"), [&] { files.askToSaveSession(); });
}

}  // namespace umbra
