#include "app/SceneCompare.h"

#include "app/SceneProbe.h"

namespace umbra {

Metrics metricsOf(HeadlessFrame& frame) {
  const Image<float> surfaces = frame.surfaces(), reference = frame.reference();
  MetricsSum sum;
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x)
      if (receivesShadow(surfaces.pixel(x, y))) sum.add(surfaces(x, y, 3), reference(x, y));
  return sum.result();
}

}  // namespace umbra
