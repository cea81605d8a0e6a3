// What is drawn to be measured, and how it is measured.
#pragma once

#include <memory>

#include "filters/core/scene/Camera.h"
#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

// Processor: the processor time of all threads of the process, which is what a software renderer
// draws with. Gpu: from the first to the last command on the GPU, with the time that it waits in
// between for the program.
enum class CostClock { Processor, Gpu };

// What moves before a frame, by so little that the picture hardly changes. Camera: nothing has to
// be baked. Light: everything has to be.
enum class Motion { Camera, Light };

// What our frames are measured against: the same scene without shadows, and drawn by VTK's own
// vtkShadowMapPass, whose exponential shadow maps are never blurred.
enum class Baseline { NoShadow, VtkShadowMapPass };

struct BenchView {
  std::shared_ptr<const Scene> scene;
  Light light;
  Camera camera;
  int width = 1280, height = 720;  // pixels
};

}  // namespace umbra
