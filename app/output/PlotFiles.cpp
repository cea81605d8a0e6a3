#include "app/output/PlotFiles.h"

#include "app/output/Cancellation.h"

namespace umbra {

void writePlots(OutputFolder& folder, Display& display, std::span<const Plot> plots) {
  for (const Plot& plot : plots) {
    for (const char* extension : {".png", ".svg", ".pdf"}) {
      throwIfCancelled();
      display.writePlot(plot, folder.file(plot.name + extension));
    }
    writeCsv(plot, folder.file(plot.name + ".csv"));
  }
}

}  // namespace umbra
