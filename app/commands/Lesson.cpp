#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/lessons/LessonCheck.h"
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

void checkLessons(const LessonCommand& command) {
  const std::vector<Lesson> lessons =
      command.name == "all" ? lessonCatalogue() : std::vector{lessonNamed(command.name)};
  const std::unique_ptr<Display> display = loadDisplay();
  LessonMeasurer measurer(*display);
  Json list = Json::array(), shapes = Json::array();
  std::vector<std::string> texts, failed;
  for (const Lesson& lesson : lessons) {
    const std::vector<CheckedClaim> claims = checkLesson(measurer, lesson);
    const auto wrong = std::count_if(claims.begin(), claims.end(),
                                     [](const CheckedClaim& claim) { return !claim.holds(); });
    if (wrong > 0)
      failed.push_back("lesson " + lesson.name + ": " + std::to_string(wrong) +
                       " of its claims do not hold");
    list.push_back(claimsToJson(lesson, claims));
    texts.push_back(lesson.name + "\n" + claimsText(claims));
  }
  for (const PictureShape& shape : lessonShapes) shapes.push_back(nameOf(shape));
  if (command.json)
    printJson({{"format", "umbrascope-lesson-check/1"},
               {"shapes", std::move(shapes)},
               {"holds", failed.empty()},
               {"lessons", std::move(list)}});
  else
    print(joined(texts, "\n"));
  if (!failed.empty()) throw Error(ErrorKind::WorkFailed, joined(failed, "; "));
}

void exportLesson(const LessonCommand& command) {
  refuseEmpty(command.folder, "-o", "DIR");
  const Lesson lesson = lessonNamed(command.name);
  const std::filesystem::path file =
      std::filesystem::path(command.folder) / (lesson.name + ".html");
  checkWritable(file);
  const std::unique_ptr<Display> display = loadDisplay();
  writeTextAtomically(file, lessonPage(*display, lesson, LessonMeasurer(*display).steps(lesson)));
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
  OptionParser check = addOne(lesson, *command, "check",
                              "Measure whether a lesson's claims hold, in windows of four "
                              "shapes; all checks every lesson");
  check.addFlag("--json", command->json, {.text = "Print one JSON object"});
  return {lesson, [=] {
            if (list.wasAsked()) return listLessons(command->json);
            if (show.wasAsked()) return print(lessonText(lessonNamed(command->name)));
            if (page.wasAsked()) return exportLesson(*command);
            if (check.wasAsked()) checkLessons(*command);
          }};
}

}  // namespace umbra
