#include "datasets/lessons/LessonCatalogue.h"

#include "datasets/json/EmbeddedFiles.h"
#include "datasets/lessons/LessonFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

std::vector<Lesson> lessonCatalogue() {
  std::vector<Lesson> lessons;
  for (const EmbeddedFile& file : embeddedLessons())
    lessons.push_back(lessonFromText(file.text, file.name));
  return lessons;
}

Lesson lessonNamed(const std::string& name) {
  if (name.ends_with(".json")) return readLesson(name);
  std::vector<std::string> names;
  for (Lesson& lesson : lessonCatalogue()) {
    if (lesson.name == name) return std::move(lesson);
    names.push_back(lesson.name);
  }
  const std::string nearest = nearestWord(name, names);
  throw Error(ErrorKind::BadInput,
              "there is no lesson '" + name + "'" +
                  (nearest.empty() ? "; there are " + joined(names) + ", or a file.json"
                                   : "; did you mean '" + nearest + "'?"));
}

}  // namespace umbra
