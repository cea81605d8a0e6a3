#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/Commands.h"
#include "app/options/OptionValues.h"
#include "app/output/Output.h"
#include "app/output/Table.h"
#include "app/output/TerminalProgress.h"
#include "app/reproduce/FigureResult.h"
#include "app/reproduce/ReportPage.h"
#include "datasets/figures/FigureCatalogue.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

struct ReproduceCommand {
  void run() const;
  std::vector<Figure> figures() const;
  void write() const;

  std::vector<std::string> names;
  std::optional<std::string> folder;
  bool list = false, json = false;
};

// Each once, in the order that they are named; all without names.
std::vector<Figure> ReproduceCommand::figures() const {
  if (names.empty()) return figureCatalogue();
  std::vector<Figure> chosen;
  for (const std::string& name : names) {
    Figure figure = figureNamed(name);
    const bool isNew = std::none_of(chosen.begin(), chosen.end(),
                                    [&](const Figure& other) { return other.name == figure.name; });
    if (isNew) chosen.push_back(std::move(figure));
  }
  return chosen;
}

void listFigures(const std::vector<Figure>& figures, bool json) {
  Json done = Json::array(), leftOut = Json::array();
  std::vector<TableRow> rows{{"NAME", "PAPER", "NUMBER", "CLAIMS", "TITLE"}};
  std::vector<TableRow> leftRows{{"LEFT OUT", "PAPER", "NUMBER", "WHY"}};
  for (const Figure& figure : figures) {
    Json entry{{"name", figure.name},
               {"paper", figure.paper},
               {"number", figure.number},
               {"title", figure.title}};
    if (figure.leftOut.empty()) {
      entry["claims"] = figure.claims.size();
      done.push_back(entry);
      rows.push_back({figure.name, figure.paper, figure.number,
                      std::to_string(figure.claims.size()), figure.title});
    } else {
      entry["reason"] = figure.leftOut;
      leftOut.push_back(entry);
      leftRows.push_back({figure.name, figure.paper, figure.number, figure.leftOut});
    }
  }
  if (json) return printJson({{"figures", std::move(done)}, {"leftOut", std::move(leftOut)}});
  print(tableText(rows) + (leftRows.size() > 1 ? "\n" + tableText(leftRows) : ""));
}

void ReproduceCommand::write() const {
  std::vector<Figure> done, leftOut;
  std::size_t cells = 0, measured = 0;
  for (Figure& figure : figures()) {
    cells += figure.cells.size();
    (figure.leftOut.empty() ? done : leftOut).push_back(std::move(figure));
  }
  if (done.empty())
    throw Error(ErrorKind::BadCommandLine, "the figure '" + leftOut.front().name +
                                               "' is left out: " + leftOut.front().leftOut);
  OutputFolder files(*folder);
  const Progress progress = progressOfCells(cells, 0);
  std::vector<FigureResult> results;
  for (const Figure& figure : done)
    results.push_back(
        measuredFigure(figure, [&] { progress.tell(double(measured++) / double(cells)); }));
  for (const FigureResult& result : results)
    for (std::size_t cell = 0; cell < result.pictures.size(); ++cell)
      if (!result.pictures[cell].empty())
        writeTextAtomically(files.file(pictureNameOf(result.figure, cell)), result.pictures[cell]);
  const Json report = reportToJson(results, leftOut);
  writeTextAtomically(files.file("report.json"), toText(report));
  writeTextAtomically(files.file("report.html"), reportPage(results, leftOut));
  files.finish();
  if (json) printJson(report);
}

void ReproduceCommand::run() const {
  if (list) return listFigures(figures(), json);
  if (!folder)
    throw Error(ErrorKind::BadCommandLine, "--output: is missing, give -o DIR, or --list");
  refuseEmpty(*folder, "-o", "DIR");
  write();
}

}  // namespace

Command addReproduce(OptionParser& program) {
  OptionParser command = program.addCommand(
      "reproduce", "Measure again what the papers' figures and tables state", commandsGroup);
  const auto reproduce = std::make_shared<ReproduceCommand>();
  const std::string group = "Report";
  command.addArguments("NAME", reproduce->names,
                       {.text = "Figures of the list, or files.json of your own; all without"});
  command.addFlag("--list", reproduce->list,
                  {group, "", "List the figures, and what is left out, with the reason"});
  command.add("-o,--output", reproduce->folder,
              {group, "DIR", "Write report.html, report.json and the pictures"});
  command.addFlag("--json", reproduce->json, {group, "", "Print one JSON object"});
  command.setFooter(
      "A report has for each figure our pictures, what the paper states, what is measured, and\n"
      "a computed verdict for each claim: holds, partly or fails.");
  return {command, [reproduce] { reproduce->run(); }};
}

}  // namespace umbra
