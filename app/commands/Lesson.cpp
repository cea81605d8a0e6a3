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

OptionParser addOne(OptionParser& parent, LessonCommand& command, const char* name,
                    const char* what) {
  OptionParser one = parent.addCommand(name, what);
  one.addRequired("NAME", command.name,
                  {.text = "A lesson of the list, or a file.json of your own"});
  return one;
}

}  // namespace

Command addLesson(OptionParser& program) {
  OptionParser lesson =
      program.addCommand("lesson", "List, read, check and export lessons", commandsGroup);
  lesson.requireCommand();
  const auto command = std::make_shared<LessonCommand>();
  OptionParser list = lesson.addCommand("list", "List the lessons");
  list.addFlag("--json", command->json, {.text = "Print one JSON object"});
  const OptionParser show = addOne(lesson, *command, "show", "Print a lesson's text");
  OptionParser page = addOne(lesson, *command, "export", "Write one self-contained HTML hand-out");
  page.add("-o,--output", command->folder,
           {.takes = "DIR", .text = "Folder to write NAME.html into"});
  OptionParser check = addOne(lesson, *command, "check", "Measure whether a lesson's claims hold");
  check.addFlag("--json", command->json, {.text = "Print one JSON object"});
  return {lesson, [=] {
            if (list.wasAsked()) return listLessons(command->json);
            if (show.wasAsked()) return print(lessonText(lessonNamed(command->name)));
            if (page.wasAsked()) return exportLesson(*command);
            if (check.wasAsked()) checkLesson(*command);
          }};
}

}  // namespace umbra
