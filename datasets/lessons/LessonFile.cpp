#include "datasets/lessons/LessonFile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "datasets/json/JsonText.h"
#include "datasets/lessons/LessonNumbers.h"
#include "datasets/session/file/JsonObject.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr const char* formatName = "umbrascope-lesson/1";
constexpr double largestNumber = std::numeric_limits<double>::max();

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::BadInput, where + why);
}

void require(const std::string& text, const JsonObject& object, const char* key) {
  if (text.empty()) refuse(object.where(), std::string(": needs a text '") + key + "'");
}

// The place of a step in its lesson, which quantities and claims refer to.
struct Place {
  const Session& session;  // the step's own
  std::size_t step, steps;
};

LessonQuantity quantityOf(JsonObject& object, const Place& place) {
  LessonQuantity result;
  bool named = false;
  object.readName("quantity", [&](const std::string& name, const std::string& where) {
    result.quantity = quantityFrom(name, where);
    named = true;
  });
  if (!named) refuse(object.where(), ": needs a 'quantity'");
  int step = int(place.step) + 1;
  object.read("step", step, 1, int(place.steps));
  result.step = std::size_t(step - 1);
  object.readName("technique", [&](const std::string& id, const std::string& where) {
    result.technique = allTechniques().make(id, where)->info().id;
  });
  if (result.technique.empty()) result.technique = place.session.technique;
  return result;
}

LessonQuestion questionOf(JsonObject& object, const Place& place) {
  LessonQuestion question;
  object.readLines("text", question.text);
  require(question.text, object, "text");
  question.asked = quantityOf(object, place);
  if (infoOf(question.asked.quantity).ofFrame || question.asked.step != place.step)
    refuse(object.where(), ".quantity: a question asks for one of this step's own probe");
  object.read("low", question.low, -largestNumber, largestNumber);
  object.read("high", question.high, -largestNumber, largestNumber);
  if (question.low >= question.high) refuse(object.where(), ".high: should be greater than 'low'");
  question.tolerance = -1.0;
  object.read("tolerance", question.tolerance, 0.0, question.high - question.low);
  if (question.tolerance < 0.0)
    refuse(object.where(), ": needs a 'tolerance', how far off a right prediction may be");
  object.readLines("explanation", question.explanation);
  require(question.explanation, object, "explanation");
  return question;
}

LessonClaim claimOf(JsonObject& object, const Place& place) {
  LessonClaim claim;
  object.readLines("text", claim.text);
  require(claim.text, object, "text");
  claim.left = quantityOf(object, place);
  bool related = false;
  object.readName("relation", [&](const std::string& name, const std::string& where) {
    claim.relation = relationFrom(name, where);
    related = true;
  });
  if (!related) refuse(object.where(), ": needs a 'relation', one of <, > and ≈");
  const double missing = std::numeric_limits<double>::infinity();
  claim.value = missing;
  object.read("value", claim.value, -largestNumber, largestNumber);
  object.readObject("than", [&](JsonObject& than) { claim.right = quantityOf(than, place); });
  if (claim.right.has_value() == (claim.value != missing))
    refuse(object.where(), ": needs exactly one of 'value' and 'than'");
  claim.tolerance = -1.0;
  object.read("tolerance", claim.tolerance, 0.0, largestNumber);
  if ((claim.relation == Relation::Near) != (claim.tolerance >= 0.0))
    refuse(object.where(), ": a 'tolerance' goes with the relation ≈, and ≈ needs one");
  return claim;
}

// Reads the point that the step is about.
Eigen::Vector3d pointOf(JsonObject& step) {
  std::optional<Eigen::Vector3d> point;
  step.readObject("at", [&](JsonObject& at) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    double world[3] = {none, none, none};
    at.readVector("world", world);
    if (std::isfinite(world[0])) point = {world[0], world[1], world[2]};
    at.finish();
  });
  if (!point)
    refuse(step.where(),
           ": needs an 'at', the point of a surface that it is about: {\"world\": [x, y, z]}");
  return *point;
}

// A pixel would be another place in a window of another size. A saved probe stays on its point.
void hold(const Eigen::Vector3d& point, Workspace& workspace, const std::string& where) {
  Session& session = workspace.shared;
  if (session.source.kind == SourceKind::DepthFile)
    refuse(where, ".source: a lesson's step shows a scene, not a depth map");
  if (session.probe)
    refuse(where,
           ".probe: a pixel is another place in a window of another size; the step has an 'at' "
           "instead, whose point `umbrascope probe --pixel X,Y --json` tells as \"world\"");
  if (const std::string why = whyNotProbeName(session.probes, lessonProbe); !why.empty())
    refuse(where, ".probes: " + why);
  session.probes.push_back({lessonProbe, point, {}, session.receiver});
  session.keptProbe = lessonProbe;
  session.probe = Pixel{session.width / 2, session.height / 2};  // until a frame shows the point
}

// A question's text gives its answer away nowhere.
void checkNumbers(const LessonStep& step, std::size_t index, const std::string& where) {
  const std::string& technique = step.session.technique;
  for (const std::string& text : textsOf(step)) quantitiesIn(text, technique, index, where);
  if (!step.question) return;
  for (const LessonQuantity& quantity : quantitiesIn(step.question->text, technique, index, where))
    if (quantity == step.question->asked)
      refuse(where, ".question.text: has the number that the question asks for");
}

LessonStep stepOf(const Json& json, const std::string& where, std::size_t index,
                  std::size_t count) {
  JsonObject object(json, where);
  LessonStep step;
  object.read("title", step.title);
  require(step.title, object, "title");
  object.readLines("text", step.text);
  require(step.text, object, "text");
  object.readLines("look", step.look);
  if (!json.contains("session")) refuse(where, ": needs a 'session'");
  step.at = pointOf(object);
  step.workspace = workspaceFrom(json.at("session"), where + ".session");
  hold(step.at, step.workspace, where + ".session");
  step.session = sessionOf(step.workspace);
  const Place place{step.session, index, count};
  object.readObject("question",
                    [&](JsonObject& question) { step.question = questionOf(question, place); });
  object.readList("claims", [&](const Json& element, const std::string& at) {
    JsonObject claim(element, at);
    step.claims.push_back(claimOf(claim, place));
    claim.finish();
  });
  checkNumbers(step, index, where);
  object.readRest([&](const std::string& key, const Json&, const std::string& at) {
    if (key != "session") refuse(at, ": there is no such key");
  });
  return step;
}

bool isLessonName(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  };
  return name.size() <= 60 && std::all_of(name.begin(), name.end(), fits);
}

Lesson lessonFrom(const Json& json, const std::string& where) {
  JsonObject object(json, where);
  std::string format;
  object.read("format", format);
  if (format != formatName)
    refuse(where, std::string(": is no lesson, its \"format\" should be \"") + formatName + "\"");
  Lesson lesson;
  object.read("name", lesson.name);
  require(lesson.name, object, "name");
  if (!isLessonName(lesson.name))
    refuse(where, ".name: '" + clipped(lesson.name) +
                      "' is not right, a hand-out's file is called so: it takes up to 60 letters, "
                      "digits, '-' and '_'");
  object.read("title", lesson.title);
  require(lesson.title, object, "title");
  object.readLines("summary", lesson.summary);
  require(lesson.summary, object, "summary");
  object.read("after", lesson.after);
  const std::size_t count = json.contains("steps") ? json.at("steps").size() : 0;
  object.readList("steps", [&](const Json& element, const std::string& at) {
    lesson.steps.push_back(stepOf(element, at, lesson.steps.size(), count));
  });
  if (lesson.steps.empty()) refuse(where, ": needs at least one of 'steps'");
  object.finish();
  return lesson;
}

}  // namespace

Lesson lessonFromText(std::string_view text, std::string_view where) {
  return lessonFrom(jsonFromText(text, where), std::string(where));
}

Lesson readLesson(const fs::path& file) {
  Lesson lesson = lessonFromText(textOf(file), file.string());
  for (LessonStep& step : lesson.steps) {
    SceneSource& source = step.workspace.shared.source;
    if (source.kind == SourceKind::MeshFile)
      source.name = (fs::absolute(file).parent_path() / source.name).lexically_normal().string();
    step.session.source = source;
  }
  return lesson;
}

bool looksLikeLesson(const fs::path& file) {
  try {
    const Json json = jsonFromText(textOf(file), "");
    if (!json.is_object() || !json.contains("format")) return false;
    const Json& format = json.at("format");
    return format.is_string() && format.get<std::string>().starts_with("umbrascope-lesson");
  } catch (const Error&) {
    return false;  // whoever reads it as something else says what is wrong with it
  }
}

}  // namespace umbra
