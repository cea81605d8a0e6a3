// Writes the tables of the probe and of the kept probes as text.
#pragma once

#include <QObject>

namespace umbra {

class FileDialogs;
class KeptProbesPane;
class Prober;
class ProbeTable;

class TableExport : public QObject {
  Q_OBJECT

 public:
  TableExport(FileDialogs& dialogs, Prober& prober, ProbeTable& table, KeptProbesPane& kept,
              QObject* parent = nullptr);

  void askToSaveTechniques();
  void askToSaveKeptProbes();

 signals:
  void failed(const QString& problem);  // one line for people

 private:
  FileDialogs& dialogs_;
  Prober& prober_;
  ProbeTable& table_;
  KeptProbesPane& kept_;
};

}  // namespace umbra
