#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/Commands.h"
#include "app/options/OptionValues.h"
#include "app/output/Cancellation.h"
#include "app/output/TerminalProgress.h"
#include "app/sweep/SweepRunner.h"
#include "app/sweep/SweepTable.h"
#include "app/sweep/SweepWorkflow.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

struct SweepCommand {
  explicit SweepCommand(OptionParser& command);

  void run() const;
  SweepRange rangeOf(const SweepPlan& plan) const;
  void measure(const SweepPlan& plan) const;

  std::optional<std::string> plan, folder, cells, snakemake, batch;
};

std::string keptPicture(const std::filesystem::path& folder, std::size_t cell,
                        const std::string& png) {
  char name[40];
  std::snprintf(name, sizeof name, "pictures/cell-%06zu.png", cell);
  writeTextAtomically(folder / name, png);
  return name;
}

SweepCommand::SweepCommand(OptionParser& command) {
  const std::string group = "Sweep";
  command.addArgument("PLAN", plan, {.text = "The plan (.json): a base, axes and measures"});
  command.add("-o,--output", folder,
              {group, "DIR", "Write cells.csv and cells.jsonl; a second run does what is missing"});
  command.add("--cells", cells,
              {group, "A-B", "Measure the cells A to B alone, counted from 0: cells-A-B.jsonl"});
  command.add("--snakemake", snakemake,
              {group, "DIR", "Write a workflow for Snakemake instead of measuring"});
  command.add("--batch", batch, {group, "N", "Cells of one job of the workflow (default 10)"});
  command.setFooter(
      "A plan: {\"format\": \"umbrascope-sweep/1\", \"base\": SESSION,\n"
      "  \"axes\": [{\"setting\": \"technique\", \"values\": [\"vsm\", \"esm\"]},\n"
      "           {\"setting\": \"kernel.radius\", \"range\": [1, 9, 5]},\n"
      "           {\"setting\": \"vsm.min-variance\", \"log\": [1e-7, 1e-4, 4],\n"
      "            \"when\": {\"technique\": \"vsm\"}}],\n"
      "  \"combine\": \"product\", \"measures\": [\"compare\"]}\n"
      "An axis sets technique, scene, scene.PARAMETER, mesh, depth, receiver, probe, a setting "
      "(see\n"
      "`settings`) or TECHNIQUE.PARAMETER. Measures: compare, decomposition, probe (counted from "
      "the\n"
      "map's corner as in sessions), cost, picture.\n"
      "\"zip\" in an axis steps several together; \"skip\" leaves cells out.\n"
      "What is measured is kept at once: a run that was ended goes on where it was.");
}

// "A-B", both from 0 and among the plan's cells.
SweepRange SweepCommand::rangeOf(const SweepPlan& swept) const {
  const std::size_t count = swept.cells.size();
  if (!cells) return {0, count - 1, true};
  const std::vector<std::string> ends = split(*cells, '-');
  SweepRange range{0, 0, false};
  const auto read = [](const std::string& text, std::size_t& value) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && end == text.data() + text.size();
  };
  if (ends.size() != 2 || !read(ends[0], range.first) || !read(ends[1], range.last) ||
      range.first > range.last || range.last >= count)
    throw Error(ErrorKind::BadCommandLine, "--cells: '" + clipped(*cells) +
                                               "' is not right, it takes A-B from 0 to " +
                                               std::to_string(count - 1));
  return range;
}

void SweepCommand::measure(const SweepPlan& swept) const {
  const SweepRange range = rangeOf(swept);
  SweepTable table(swept, range, *folder);
  SweepRunner runner(swept, *plan, [&](std::size_t cell, const std::string& png) {
    return keptPicture(*folder, cell, png);
  });
  const Progress progress = progressOfCells(range.count(), table.count());
  try {
    for (std::size_t cell = range.first; cell <= range.last; ++cell) {
      if (table.has(cell)) continue;
      progress.tell(double(table.count()) / double(range.count()));
      table.add(cell, runner.measured(cell));
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Cancelled) throw;
    throw Error(ErrorKind::Cancelled, "cancelled; " + std::to_string(table.count()) + " of " +
                                          std::to_string(range.count()) + " cells are kept in " +
                                          *folder + ", the same command goes on from there");
  }
  table.finish();
}

void SweepCommand::run() const {
  if (!plan) throw Error(ErrorKind::BadCommandLine, "PLAN: is missing, give PLAN.json");
  if (folder.has_value() == snakemake.has_value())
    throw Error(ErrorKind::BadCommandLine,
                folder ? "--snakemake: excludes -o, give one of them"
                       : "--output: is missing, give -o DIR, or --snakemake DIR");
  if (batch && !snakemake)
    throw Error(ErrorKind::BadCommandLine, "--batch: only goes with --snakemake");
  if (cells && snakemake)
    throw Error(ErrorKind::BadCommandLine, "--cells: excludes --snakemake, give one of them");
  const SweepPlan swept = readSweepPlan(*plan, throwIfCancelled);
  if (!snakemake) return measure(swept);
  const int size = batch ? integerFrom(*batch, "--batch", 1, int(mostCells)) : 10;
  writeSweepWorkflow(swept, *plan, std::filesystem::canonical("/proc/self/exe"), std::size_t(size),
                     *snakemake);
}

}  // namespace

Command addSweep(OptionParser& program) {
  OptionParser command = program.addCommand(
      "sweep", "Measure every combination of some settings, as a plan says", commandsGroup);
  const auto sweep = std::make_shared<SweepCommand>(command);
  return {command, [sweep] { sweep->run(); }};
}

}  // namespace umbra
