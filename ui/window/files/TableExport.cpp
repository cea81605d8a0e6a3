#include "ui/window/files/TableExport.h"

#include "filters/core/support/AtomicFile.h"
#include "ui/probe/Prober.h"
#include "ui/probe/SavedProbesPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/window/files/FileDialogs.h"

namespace umbra {

namespace fs = std::filesystem;

TableExport::TableExport(FileDialogs& dialogs, Prober& prober, ProbeTable& table,
                         SavedProbesPane& saved, QObject* parent)
    : QObject(parent), dialogs_(dialogs), prober_(prober), table_(table), saved_(saved) {}

void TableExport::askToSaveTechniques() {
  dialogs_.askAndWrite(
      tr("Export table"), "techniques.tsv", tr("Tab-separated values (*.tsv *.txt)"),
      [this](const fs::path& file) { writeTextAtomically(file, table_.asText().toStdString()); });
}

void TableExport::askToSaveProbes() {
  if (!prober_.veil().isEmpty()) {
    emit failed(prober_.veil());
    return;
  }
  if (saved_.asText(',').isEmpty()) {
    emit failed(tr("There is no table of saved probes to export: save a probe first (K)."));
    return;
  }
  dialogs_.askAndWrite(tr("Export saved probes"), "probes.csv",
                       tr("Comma-separated values (*.csv)"), [this](const fs::path& file) {
                         writeTextAtomically(file, saved_.asText(',').toStdString());
                       });
}

}  // namespace umbra
