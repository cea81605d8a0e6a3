// Writes the tables of the probe and of the saved probes as text.
#pragma once

#include <QObject>

namespace umbra {

class FileDialogs;
class SavedProbesPane;
class Prober;
class ProbeTable;

class TableExport : public QObject {
  Q_OBJECT

 public:
  TableExport(FileDialogs& dialogs, Prober& prober, ProbeTable& table, SavedProbesPane& saved,
              QObject* parent = nullptr);

  void askToSaveTechniques();
  void askToSaveProbes();

 signals:
  void failed(const QString& problem);  // one line for people

 private:
  FileDialogs& dialogs_;
  Prober& prober_;
  ProbeTable& table_;
  SavedProbesPane& saved_;
};

}  // namespace umbra
