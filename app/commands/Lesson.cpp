#include <filesystem>
#include <memory>
#include <string>

#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/lessons/LessonPage.h"
#include "app/lessons/LessonSteps.h"
#include "app/options/OptionValues.h"
#include "app/output/Output.h"
#include "app/output/Table.h"
#include "datasets/lessons/LessonCatalogue.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

struct LessonCommand {
  std::string name, folder = "umbrascope-out";
  bool json = false;
};

void listLessons(bool json) {
  Json list = Json::array();
  std::vector<TableRow> rows{{"NAME", "TITLE", "STEPS", "AFTER"}};
  for (const Lesson& lesson : lessonCatalogue()) {
    rows.push_back({lesson.name, lesson.title, std::to_string(lesson.steps.size()), lesson.after});
    list.push_back({{"name", lesson.name},
                    {"title", lesson.title},
                    {"summary", lesson.summary},
                    {"after", lesson.after},
                    {"steps", lesson.steps.size()}});
  }
  if (json) return printJson({{"lessons", list}});
  print(tableText(rows));
}

Json claimJson(std::size_t step, const LessonClaim& claim, const ClaimResult& result) {
  return {{"step", step + 1},
          {"text", claim.text},
          {"quantity", describe(claim.left)},
          {"measured", result.left},
          {"relation", nameOf(claim.relation)},
          {"against", result.right},
          {"holds", result.holds}};
}

void checkLesson(const LessonCommand& command) {
  const Lesson lesson = lessonNamed(command.name);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::vector<StepResult> results = measureSteps(*display, lesson);
  Json list = Json::array();
  std::vector<TableRow> rows{{"STEP", "QUANTITY", "MEASURED", "", "AGAINST", "HOLDS", "CLAIM"}};
  std::size_t failed = 0;
  for (std::size_t step = 0; step < lesson.steps.size(); ++step)
    for (const LessonClaim& claim : lesson.steps[step].claims) {
      const ClaimResult result = checkClaim(results, claim);
      if (!result.holds) ++failed;
      list.push_back(claimJson(step, claim, result));
      rows.push_back({std::to_string(step + 1), describe(claim.left), shortNumber(result.left),
                      nameOf(claim.relation), shortNumber(result.right),
                      result.holds ? "yes" : "no", claim.text});
    }
  if (command.json)
    printJson({{"lesson", lesson.name}, {"steps", lesson.steps.size()}, {"claims", list}});
  else
    print(tableText(rows));
  if (failed > 0)
    throw Error(ErrorKind::WorkFailed, "lesson " + lesson.name + ": " + std::to_string(failed) +
                                           " of its claims do not hold");
}

void exportLesson(const LessonCommand& command) {
  refuseEmpty(command.folder, "-o", "DIR");
  const Lesson lesson = lessonNamed(command.name);
  const std::filesystem::path file =
      std::filesystem::path(command.folder) / (lesson.name + ".html");
  checkWritable(file);
  const std::unique_ptr<Display> display = loadDisplay();
  writeTextAtomically(file, lessonPage(*display, lesson, measureSteps(*display, lesson)));
  announce(file);
}

CLI::App* addOne(CLI::App& parent, LessonCommand& command, const char* name, const char* what) {
  CLI::App* one = parent.add_subcommand(name, what);
  one->add_option("NAME", command.name, "A lesson of the list, or a file.json of your own")
      ->required()
      ->type_name("");
  return one;
}

}  // namespace

Command addLesson(CLI::App& program) {
  CLI::App* lesson = program.add_subcommand("lesson", "List, read, check and export lessons");
  lesson->require_subcommand(1);
  const auto command = std::make_shared<LessonCommand>();
  CLI::App* list = lesson->add_subcommand("list", "List the lessons");
  list->add_flag("--json", command->json, "Print one JSON object");
  CLI::App* show = addOne(*lesson, *command, "show", "Print a lesson's text");
  CLI::App* page = addOne(*lesson, *command, "export", "Write one self-contained HTML hand-out");
  page->add_option("-o,--output", command->folder, "Folder to write NAME.html into")
      ->type_name("DIR")
      ->capture_default_str();
  CLI::App* check = addOne(*lesson, *command, "check", "Measure whether a lesson's claims hold");
  check->add_flag("--json", command->json, "Print one JSON object");
  return {lesson, [=] {
            if (list->parsed()) return listLessons(command->json);
            if (show->parsed()) return print(lessonText(lessonNamed(command->name)));
            if (page->parsed()) return exportLesson(*command);
            if (check->parsed()) checkLesson(*command);
          }};
}

}  // namespace umbra
