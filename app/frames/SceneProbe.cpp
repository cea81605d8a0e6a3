#include "app/frames/SceneProbe.h"

#include <nlohmann/json.hpp>

#include "analysis/frame/FrameReads.h"
#include "analysis/surfaces/PointRead.h"
#include "app/output/Cancellation.h"
#include "app/reports/Reports.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

std::string textOf(Pixel pixel) {
  return std::to_string(pixel.x) + "," + std::to_string(pixel.y);
}

SurfacePoint surfaceOf(HeadlessFrame& frame, const Session& session, Pixel pixel) {
  if (pixel.x >= session.width || pixel.y >= session.height)
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: " + textOf(pixel) + " is outside the picture of " +
                    std::to_string(session.width) + "x" + std::to_string(session.height) +
                    " pixels, which count from 0");
  const std::optional<SurfacePoint> surface = frame.surfaceAt(pixel.x, pixel.y);
  if (!surface)
    throw Error(
        ErrorKind::BadCommandLine,
        "--pixel: " + textOf(pixel) + " shows no surface; choose one on an object, or 'worst'");
  if (!surface->isInMap())
    throw Error(ErrorKind::BadCommandLine,
                "--pixel: " + textOf(pixel) +
                    " lies outside the shadow map; choose one inside, or 'worst'");
  return *surface;
}

// A surface as the frames of all techniques show it; only the visibilities differ.
struct SeenSurface {
  Pixel pixel;
  std::vector<SurfacePoint> surfaces;  // one for each technique, or a single one where `computed`
  bool hidden = false;                 // from the camera
  bool computed = false;  // whether the read was computed for the point, and not taken from a pixel
};

SceneProbe takeSceneProbe(HeadlessFrame& frame,
                          const std::vector<std::shared_ptr<const Technique>>& techniques,
                          const SeenSurface& seen, const std::optional<double>& receiver) {
  const SurfacePoint& surface = seen.surfaces.front();
  const auto snapshot = frame.snapshot();
  ProbeRequest request = requestOf(*snapshot, surface);
  request.receiver = receiver.value_or(surface.receiver);
  request.techniques = techniques;
  SceneProbe result{takeProbe(request), seen.pixel, surface, seen.hidden};
  // A receiver set by hand is not the one that the frame was shaded with.
  if (receiver || seen.computed) return result;
  for (std::size_t i = 0; i < techniques.size(); ++i)
    result.probe.techniques[i].gpu = seen.surfaces[i].visibility;
  return result;
}

struct SavedPlace {
  SeenSurface seen;
  std::string reason;  // why there is none
};

std::string reasonOf(NotRead why) {
  switch (why) {
    case NotRead::NoSurface:
      return "no surface of the scene is there";
    case NotRead::OutsideMap:
      return "outside the shadow map";
    case NotRead::NotInSight:
      break;
  }
  return "not in sight, and the filter reads as wide as a pixel";
}

// Where the last frame reads the surface at `point`.
SavedPlace placeOf(HeadlessFrame& frame, const Eigen::Vector3d& point) {
  const auto drawn = frame.snapshot();
  const PictureView picture{drawn->camera, drawn->surfaces.width(), drawn->surfaces.height()};
  const auto spot = surfaceNear(*drawn->scene, point);
  std::optional<SeenPoint> seen;
  if (spot)
    seen =
        seenPoint(point, *spot, picture, [&frame](int x, int y) { return frame.surfaceAt(x, y); });
  const double extent = drawn->scene->lightBounds().diagonal().norm();
  const auto found = readOfPoint(
      point, spot, {picture, drawn->light, drawn->cascades, drawn->settings, extent}, seen);
  if (const auto* why = std::get_if<NotRead>(&found)) return {{}, reasonOf(*why)};
  const auto& read = std::get<PointRead>(found);
  return {{seen ? Pixel{seen->x, seen->y} : Pixel{}, {read.surface}, !seen, !read.asShown}, {}};
}

}  // namespace

std::shared_ptr<Technique> suspectOf(const std::vector<std::shared_ptr<Technique>>& chosen) {
  std::shared_ptr<Technique> bound;
  for (const auto& technique : chosen) {
    if (technique->info().id == "vsm") return technique;
    if (!bound && technique->info().upperBound) bound = technique;
  }
  return bound ? bound : chosen.front();
}

SceneProbe probeScene(HeadlessFrame& frame, const Session& session,
                      const std::vector<std::shared_ptr<Technique>>& techniques, Pixel pixel) {
  std::vector<SurfacePoint> surfaces;
  std::vector<std::shared_ptr<const Technique>> drawn;
  for (const auto& technique : techniques) {
    throwIfCancelled();
    frame.render(*technique, ViewMode::Shaded);
    surfaces.push_back(surfaceOf(frame, session, pixel));
    drawn.push_back(frame.snapshot()->technique);
  }
  return takeSceneProbe(frame, drawn, {pixel, surfaces}, session.receiver);
}

std::vector<SavedSceneProbe> probeSaved(HeadlessFrame& frame, const Session& session,
                                        const std::vector<std::shared_ptr<Technique>>& techniques,
                                        const std::vector<NamedProbe>& saved,
                                        const std::optional<double>& receiver) {
  std::vector<SavedPlace> places(saved.size());
  std::vector<std::shared_ptr<const Technique>> drawn;
  for (const auto& technique : techniques) {
    throwIfCancelled();
    frame.render(*technique, ViewMode::Shaded);
    drawn.push_back(frame.snapshot()->technique);
    for (std::size_t i = 0; i < saved.size(); ++i) {
      SeenSurface& seen = places[i].seen;
      if (technique == techniques.front())
        places[i] = placeOf(frame, *saved[i].point);
      else if (!seen.surfaces.empty() && !seen.computed)
        seen.surfaces.push_back(surfaceOf(frame, session, seen.pixel));
    }
  }
  std::vector<SavedSceneProbe> results;
  for (std::size_t i = 0; i < saved.size(); ++i) {
    throwIfCancelled();
    SavedSceneProbe& result = results.emplace_back();
    result.reason = places[i].reason;
    if (result.reason.empty())
      result.probe =
          takeSceneProbe(frame, drawn, places[i].seen, receiver ? receiver : saved[i].receiver);
  }
  return results;
}

Pixel worstBleeding(HeadlessFrame& frame, const Technique& technique) {
  frame.render(technique, ViewMode::Shaded);
  if (const std::optional<Pixel> plain = frame.plainestBleeding()) return *plain;
  const SurfaceImage surfaces = frame.surfaces();
  const Image<float> reference = frame.reference();
  std::optional<Pixel> worst;
  float largest = 0.0f;
  for (int y = 0; y < surfaces.height(); ++y)
    for (int x = 0; x < surfaces.width(); ++x) {
      if (!surfaces.receivesShadow(x, y)) continue;
      const float error = surfaces.visibility(x, y) - reference(x, y);
      if (worst && error <= largest) continue;
      worst = Pixel{x, y};
      largest = error;
    }
  if (!worst)
    throw Error(ErrorKind::WorkFailed,
                "no pixel of the picture faces the light inside its map; move light or camera");
  return *worst;
}

Json sceneProbeToJson(const SceneProbe& probe, const DepthMap& map, const std::string& name,
                      ReadFilter filter, int bins, int samples) {
  Json object = probeToJson(probe.probe, map, {name, bins, samples});
  const SurfacePoint& surface = probe.surface;
  if (probe.hidden)
    object["hidden"] = true;
  else
    object["pixel"] = {probe.pixel.x, probe.pixel.y};
  object["world"] = {surface.world.x(), surface.world.y(), surface.world.z()};
  object["uv"] = {surface.u, surface.v};
  object["cascade"] = surface.cascade;
  if (surface.nextCascade > 0.0) object["nextCascade"] = surface.nextCascade;
  object["filter"] = nameOf(filter);
  if (filter != ReadFilter::Point && filter != ReadFilter::Bilinear)
    object["footprint"] = {{"x", surface.footprint.x},
                           {"y", surface.footprint.y},
                           {"probes", surface.footprint.probes}};
  return object;
}

}  // namespace umbra
