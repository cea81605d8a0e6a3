#include "datasets/lessons/LessonFile.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "datasets/session/file/JsonObject.h"
#include "datasets/session/file/JsonText.h"
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

LessonRelation relationFrom(const std::string& name, const std::string& where) {
  for (const auto relation : {LessonRelation::Less, LessonRelation::Greater, LessonRelation::Near})
    if (name == nameOf(relation)) return relation;
  refuse(where, ": '" + name + "' is no relation; there are <, > and ≈");
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
  if ((claim.relation == LessonRelation::Near) != (claim.tolerance >= 0.0))
    refuse(object.where(), ": a 'tolerance' goes with the relation ≈, and ≈ needs one");
  return claim;
}

Session sessionOf(const Json& json, const std::string& where) {
  Session session = sessionFrom(json, where);
  if (session.source.kind == SourceKind::DepthFile)
    refuse(where, ".source: a lesson's step shows a scene, not a depth map");
  if (!session.probe) refuse(where, ": needs a 'probe', the pixel that the step is about");
  if (session.probe->x >= session.width || session.probe->y >= session.height)
    refuse(where, ".probe: is outside the picture of " + std::to_string(session.width) + " x " +
                      std::to_string(session.height) + " pixels");
  return session;
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
  step.session = sessionOf(json.at("session"), where + ".session");
  const Place place{step.session, index, count};
  object.readObject("question",
                    [&](JsonObject& question) { step.question = questionOf(question, place); });
  object.readList("claims", [&](const Json& element, const std::string& at) {
    JsonObject claim(element, at);
    step.claims.push_back(claimOf(claim, place));
    claim.finish();
  });
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
  for (LessonStep& step : lesson.steps)
    if (step.session.source.kind == SourceKind::MeshFile)
      step.session.source.name =
          (fs::absolute(file).parent_path() / step.session.source.name).lexically_normal().string();
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
