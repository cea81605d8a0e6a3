#include "ui/window/menus/RecentMenu.h"

#include "datasets/maps/DepthFile.h"
#include "ui/widgets/base/Style.h"
#include "ui/window/files/FileActions.h"
#include "ui/window/files/FileDialogs.h"
#include "ui/window/files/RecentFiles.h"
#include "ui/window/menus/MenuActions.h"

namespace umbra {

RecentMenu::RecentMenu(FileActions& files, QWidget* parent)
    : QMenu(tr("Open &recent"), parent), files_(files) {
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &RecentMenu::refresh);
  refresh();
}

// A file that is gone stays in the list, greyed: it may lie on a disk that is not there today.
void RecentMenu::refresh() {
  clear();
  const auto recent = recentFiles();
  if (recent.empty()) addAction(tr("No file was opened yet"))->setEnabled(false);
  for (const std::filesystem::path& file : recent) {
    // An ampersand would underline the letter after it.
    const QString name = toText(file.filename()).replace("&", "&&");
    QAction* action = umbra::addAction(*this, name, {}, [this, file] { files_.open(file); });
    std::error_code none;
    const bool there = std::filesystem::exists(splitDepthArgument(file.string()).first, none);
    action->setEnabled(there);
    const QString place = toText(file);
    action->setToolTip(style::plainTip(there ? place : tr("%1 is not there any more").arg(place)));
  }
  addSeparator();
  umbra::addAction(*this, tr("&Clear this list"), {}, forgetRecentFiles)
      ->setEnabled(!recent.empty());
}

}  // namespace umbra
