// What can be written: pictures, plots, tables, the session.
#pragma once

#include <QMenu>

namespace umbra {

class BleedingExport;
class EvidencePanes;
class FileActions;
class TableExport;

class ExportMenu : public QMenu {
  Q_OBJECT

 public:
  ExportMenu(FileActions& files, BleedingExport& bleeding, TableExport& tables,
             EvidencePanes& evidence, QWidget* parent = nullptr);
};

}  // namespace umbra
