#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

std::string nameOf(const PictureShape& shape) {
  return std::to_string(shape.width) + "x" + std::to_string(shape.height);
}

// What a claim comes to in pictures of every shape.
struct CheckedClaim {
  std::size_t step;  // index
  std::string text, quantity, relation;
  std::vector<double> measured, expected;  // by shape
  std::optional<double> within;            // of ≈
  std::vector<bool> holds;                 // by shape

  bool holdsEverywhere() const {
    return std::find(holds.begin(), holds.end(), false) == holds.end();
  }
};

// The lesson's claims, and of each question that its answer is the same in every shape.
std::vector<CheckedClaim> claimsOf(const Lesson& lesson) {
  std::vector<CheckedClaim> claims;
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    if (const auto& question = lesson.steps[step].question)
      claims.push_back({step,
                        "The answer is the same in every window",
                        describe(question->asked),
                        "≈",
                        {},
                        {},
                        question->tolerance / 2.0,
                        {}});
    for (const LessonClaim& claim : lesson.steps[step].claims) {
      const bool near = claim.relation == LessonRelation::Near;
      claims.push_back({step,
                        claim.text,
                        describe(claim.left),
                        umbra::nameOf(claim.relation),
                        {},
                        {},
                        near ? std::optional(claim.tolerance) : std::nullopt,
                        {}});
    }
  }
  return claims;
}

// Adds what the lesson's steps come to in pictures of one more shape.
void measureClaims(const Lesson& lesson, const std::vector<StepResult>& results,
                   std::vector<CheckedClaim>& claims) {
  auto checked = claims.begin();
  const auto add = [&](double measured, double expected, bool holds) {
    checked->measured.push_back(measured);
    checked->expected.push_back(expected);
    checked->holds.push_back(holds);
    ++checked;
  };
  for (const LessonStep& step : lesson.steps) {
    if (step.question) {
      const double answer = valueOf(results, step.question->asked);
      const double first = checked->measured.empty() ? answer : checked->measured.front();
      add(answer, first, std::abs(answer - first) <= *checked->within);
    }
    for (const LessonClaim& claim : step.claims) {
      const ClaimResult result = checkClaim(results, claim);
      add(result.left, result.right, result.holds);
    }
  }
}

std::vector<CheckedClaim> checked(Display& display, const Lesson& lesson) {
  std::vector<CheckedClaim> claims = claimsOf(lesson);
  for (const PictureShape& shape : lessonShapes)
    measureClaims(lesson, measureSteps(display, lesson, shape), claims);
  return claims;
}

Json claimsJson(const Lesson& lesson, const std::vector<CheckedClaim>& claims) {
  Json steps = Json::array();
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    Json list = Json::array();
    for (const CheckedClaim& claim : claims)
      for (std::size_t i = 0; i < std::size(lessonShapes) && claim.step == step; ++i)
        list.push_back({{"text", claim.text},
                        {"quantity", claim.quantity},
                        {"relation", claim.relation},
                        {"measured", claim.measured[i]},
                        {"expected", claim.expected[i]},
                        {"within", claim.within ? Json(*claim.within) : Json()},
                        {"shape", nameOf(lessonShapes[i])},
                        {"holds", bool(claim.holds[i])}});
    steps.push_back({{"step", step + 1}, {"claims", std::move(list)}});
  }
  return {{"name", lesson.name}, {"steps", std::move(steps)}};
}

// "0.216 ± 0.004"; by shape where what is expected depends on it: "0.1307 0.1611 …".
std::string expectedText(const CheckedClaim& claim) {
  std::string text = shortNumber(claim.expected.front());
  const bool same = std::all_of(claim.expected.begin(), claim.expected.end(),
                                [&](double value) { return shortNumber(value) == text; });
  for (std::size_t i = 1; i < claim.expected.size() && !same; ++i)
    text += " " + shortNumber(claim.expected[i]);
  return claim.within ? text + " ± " + shortNumber(*claim.within) : text;
}

std::string claimsText(const Lesson& lesson, const std::vector<CheckedClaim>& claims) {
  TableRow heading{"STEP", "QUANTITY"};
  for (const PictureShape& shape : lessonShapes) heading.push_back(nameOf(shape));
  for (const char* column : {"", "EXPECTED", "HOLDS", "CLAIM"}) heading.push_back(column);
  std::vector<TableRow> rows{heading};
  for (const CheckedClaim& claim : claims) {
    TableRow row{std::to_string(claim.step + 1), claim.quantity};
    for (const double measured : claim.measured) row.push_back(shortNumber(measured));
    row.insert(row.end(), {claim.relation, expectedText(claim),
                           claim.holdsEverywhere() ? "yes" : "no", claim.text});
    rows.push_back(std::move(row));
  }
  return lesson.name + "\n" + tableText(rows);
}

void checkLessons(const LessonCommand& command) {
  const std::vector<Lesson> lessons =
      command.name == "all" ? lessonCatalogue() : std::vector{lessonNamed(command.name)};
  const std::unique_ptr<Display> display = loadDisplay();
  Json list = Json::array();
  std::string text;
  std::vector<std::string> failed;
  for (const Lesson& lesson : lessons) {
    const std::vector<CheckedClaim> claims = checked(*display, lesson);
    const auto wrong = std::count_if(claims.begin(), claims.end(), [](const CheckedClaim& claim) {
      return !claim.holdsEverywhere();
    });
    if (wrong > 0)
      failed.push_back("lesson " + lesson.name + ": " + std::to_string(wrong) +
                       " of its claims do not hold");
    list.push_back(claimsJson(lesson, claims));
    text += (text.empty() ? "" : "\n") + claimsText(lesson, claims);
  }
  Json shapes = Json::array();
  for (const PictureShape& shape : lessonShapes) shapes.push_back(nameOf(shape));
  if (command.json)
    printJson({{"format", "umbrascope-lesson-check/1"},
               {"shapes", std::move(shapes)},
               {"holds", failed.empty()},
               {"lessons", std::move(list)}});
  else
    print(text);
  if (!failed.empty()) throw Error(ErrorKind::WorkFailed, joined(failed, "; "));
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
