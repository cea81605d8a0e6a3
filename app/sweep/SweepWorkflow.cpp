#include "app/sweep/SweepWorkflow.h"

#include <algorithm>

#include "app/output/Output.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// A text of Python: its escapes are those of JSON, as long as other characters stand as they are.
std::string pythonText(const std::string& text) {
  try {
    return Json(text).dump(-1, ' ', false);
  } catch (const std::exception&) {
    throw Error(ErrorKind::BadCommandLine,
                clipped(text) + ": a workflow can name files whose names are UTF-8 alone");
  }
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
  const std::string planText =
      pythonText(std::filesystem::absolute(planFile).lexically_normal().string());
  std::string inputs = planText;
  for (const std::filesystem::path& file : plan.files) inputs += ", " + pythonText(file.string());
  const std::string results = "results-" + plan.fingerprint.substr(0, 8);
  const std::string text =
      "# A sweep of " + std::to_string(plan.cells.size()) +
      " cells in batches, written by umbrascope " UMBRA_VERSION
      ".\n"
      "# Run it here:  snakemake --cores 4\n"
      "# A job that was ended goes on where it was; the table is the same as that of one process.\n"
      "PLAN = " +
      planText +
      "\n"
      "PROGRAM = config.get(\"umbrascope\", " +
      pythonText(program.string()) +
      ")\n"
      "INPUTS = [" +
      inputs +
      "]\n"
      "# The plan and its files, as they were: others have another folder.\n"
      "RESULTS = \"" +
      results +
      "\"\n"
      "PARTS = [\n" +
      parts +
      "]\n"
      "\n"
      "localrules: all, table\n"
      "\n"
      "rule all:\n"
      "    input: RESULTS + \"/cells.csv\", RESULTS + \"/cells.jsonl\"\n"
      "\n"
      "rule part:\n"
      "    input: INPUTS\n"
      "    output: RESULTS + \"/cells-{part}.jsonl\"\n"
      "    wildcard_constraints: part=r\"\\d+-\\d+\"\n"
      "    shell: \"{PROGRAM:q} sweep {PLAN:q} --cells {wildcards.part} -o {RESULTS}\"\n"
      "\n"
      "rule table:\n"
      "    input: expand(RESULTS + \"/cells-{part}.jsonl\", part=PARTS)\n"
      "    output: RESULTS + \"/cells.csv\", RESULTS + \"/cells.jsonl\"\n"
      "    shell: \"{PROGRAM:q} sweep {PLAN:q} -o {RESULTS}\"\n";
  OutputFolder files(folder);
  writeTextAtomically(files.file("Snakefile"), text);
  files.finish();
}

}  // namespace umbra
