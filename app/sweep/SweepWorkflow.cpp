#include "app/sweep/SweepWorkflow.h"

#include <algorithm>

#include "app/output/Output.h"
#include "filters/core/support/AtomicFile.h"

namespace umbra {
namespace {

// A text of Python; JSON's strings are written as Python's are.
std::string pythonText(const std::string& text) {
  return Json(text).dump(-1, ' ', true);
}

}  // namespace

void writeSweepWorkflow(const SweepPlan& plan, const std::filesystem::path& planFile,
                        const std::filesystem::path& program, std::size_t batch,
                        const std::filesystem::path& folder) {
  std::string parts;
  for (std::size_t first = 0; first < plan.cells.size(); first += batch) {
    const std::size_t last = std::min(first + batch, plan.cells.size()) - 1;
    parts += "    \"" + std::to_string(first) + "-" + std::to_string(last) + "\",\n";
  }
  const std::string text =
      "# A sweep of " + std::to_string(plan.cells.size()) +
      " cells in batches, written by umbrascope " UMBRA_VERSION
      ".\n"
      "# Run it here:  snakemake --cores 4\n"
      "# A job that was ended goes on where it was; the table is the same as that of one process.\n"
      "PLAN = " +
      pythonText(std::filesystem::absolute(planFile).lexically_normal().string()) +
      "\n"
      "PROGRAM = config.get(\"umbrascope\", " +
      pythonText(program.string()) +
      ")\n"
      "PARTS = [\n" +
      parts +
      "]\n"
      "\n"
      "localrules: all, table\n"
      "\n"
      "rule all:\n"
      "    input: \"results/cells.csv\", \"results/cells.jsonl\"\n"
      "\n"
      "rule part:\n"
      "    output: \"results/cells-{part}.jsonl\"\n"
      "    wildcard_constraints: part=r\"\\d+-\\d+\"\n"
      "    shell: \"{PROGRAM:q} sweep {PLAN:q} --cells {wildcards.part} -o results\"\n"
      "\n"
      "rule table:\n"
      "    input: expand(\"results/cells-{part}.jsonl\", part=PARTS)\n"
      "    output: \"results/cells.csv\", \"results/cells.jsonl\"\n"
      "    shell: \"{PROGRAM:q} sweep {PLAN:q} -o results\"\n";
  OutputFolder files(folder);
  writeTextAtomically(files.file("Snakefile"), text);
  files.finish();
}

}  // namespace umbra
