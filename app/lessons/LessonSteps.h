// A lesson's steps rendered and measured, without a window.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/errors/Metrics.h"
#include "app/display/Display.h"
#include "app/frames/SceneProbe.h"
#include "datasets/lessons/Lesson.h"

namespace umbra {

struct StepResult {
  SceneProbe probe;                        // of every technique that the lesson measures there
  std::map<std::string, Metrics> metrics;  // by id, of those whose whole frame is measured
  Image<std::uint8_t> picture;             // as the session asks for it
};

struct ClaimResult {
  double left = 0.0, right = 0.0;
  bool holds = false;
};

// The size of a picture, in pixels.
struct PictureShape {
  int width, height;
};
// The windows in which a lesson must hold: wide and narrow ones, large and small.
inline constexpr PictureShape lessonShapes[] = {{1280, 720}, {1600, 900}, {1000, 900}, {960, 540}};

// Draws and measures lessons on one OpenGL context; a scene is loaded once.
class LessonMeasurer {
 public:
  explicit LessonMeasurer(Display& display);
  ~LessonMeasurer();

  // In the order of the lesson's steps, in pictures of that shape or else of the steps' sessions.
  // Throws BadInput that names lesson and step for a point on no surface and for a technique that
  // the step's format cannot hold.
  std::vector<StepResult> steps(const Lesson& lesson,
                                const std::optional<PictureShape>& shape = {});

 private:
  class Scenes;
  std::unique_ptr<Scenes> scenes_;
};

double valueOf(const std::vector<StepResult>& results, const LessonQuantity& quantity);
ClaimResult checkClaim(const std::vector<StepResult>& results, const LessonClaim& claim);

}  // namespace umbra
