// The files that were opened last.
#pragma once

#include <QMenu>

namespace umbra {

class FileActions;

class RecentMenu : public QMenu {
  Q_OBJECT

 public:
  explicit RecentMenu(FileActions& files, QWidget* parent = nullptr);

 private:
  void refresh();

  FileActions& files_;
};

}  // namespace umbra
