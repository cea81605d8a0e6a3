#include "analysis/surfaces/SurfaceRead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "filters/core/maps/ReceiverBias.h"

namespace umbra {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearest = 1e-6;  // smaller cosines and distances count as 0

struct CameraAxes {
  Vector3d right, up, forward;
  double scale;  // pixels per unit of slope
};

CameraAxes axesOf(const PictureView& view) {
  const Camera& camera = view.camera;
  const Vector3d forward = (camera.target - camera.position).normalized();
  const Vector3d right = forward.cross(camera.up).normalized();
  const double angle = camera.viewAngle * std::numbers::pi / 180.0;
  return {right, right.cross(forward), forward, 0.5 * view.height / std::tan(0.5 * angle)};
}

struct CascadePlace {
  int cascade = 0;
  double next = 0.0;
};

std::optional<CascadePlace> cascadeOf(const Vector3d& point, const LightPoint& light,
                                      const FrameView& frame) {
  const std::vector<Cascade>& cascades = frame.cascades;
  const CascadeSettings& settings = frame.settings.map.cascades;
  const auto holds = [&](const Cascade& cascade) {
    const double u = cascade.u(light.u), v = cascade.v(light.v);
    return u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
  };
  const int last = int(cascades.size()) - 1;
  const Camera& camera = settings.frozen ? *settings.frozen : frame.picture.camera;
  const double distance =
      (camera.target - camera.position).normalized().dot(point - camera.position);
  for (int i = 0; i < last; ++i) {
    if (distance >= cascades[i].farDistance || !holds(cascades[i])) continue;
    const double begin = cascades[i].seamDistance(settings.seam);
    const double seam = std::max(cascades[i].farDistance - begin, 1e-20);
    const double weight = std::clamp((distance - begin) / seam, 0.0, 0.999999);
    return CascadePlace{i, holds(cascades[i + 1]) ? weight : 0.0};
  }
  if (!holds(cascades[last])) return std::nullopt;
  return CascadePlace{last, 0.0};
}

// How much the position on the map, in texels of `cascade`, moves from a pixel to the next one to
// the right and upwards in the picture. Nothing where the camera does not look at the point.
std::optional<std::pair<Vector2d, Vector2d>> stepsOnMap(const Vector3d& point,
                                                        const Vector3d& normal,
                                                        const FrameView& frame,
                                                        const Cascade& cascade) {
  const auto centre = frame.picture.pixelOf(point);
  if (!centre) return std::nullopt;
  const Vector3d eye = frame.picture.camera.position;
  const auto place = [&](double dx, double dy) {
    const Vector3d ray = frame.picture.rayThrough(*centre + Vector2d(dx, dy));
    const double t = normal.dot(point - eye) / normal.dot(ray);
    const LightPoint at = frame.light.project(eye + t * ray);
    // Behind the camera the plane has no end: the footprint is wider than any map.
    if (!(t > 0.0)) return Vector2d(Vector2d::Constant(std::numeric_limits<double>::infinity()));
    return Vector2d(Vector2d(at.u, at.v) * (frame.settings.map.size / cascade.side));
  };
  return std::pair<Vector2d, Vector2d>{place(0.5, 0.0) - place(-0.5, 0.0),
                                       place(0.0, -0.5) - place(0.0, 0.5)};
}

// The footprint of a trilinear or anisotropic read: the longer axis and the probes along it.
Footprint axisOf(const Vector2d& dx, const Vector2d& dy, const FrameSettings& settings) {
  const double longest = settings.map.size;
  Vector2d axis = dx.norm() > dy.norm() ? dx : dy;
  double longer = axis.norm(), shorter = std::min(dx.norm(), dy.norm());
  if (!(longer < longest)) {
    axis = {longest, 0.0};
    longer = shorter = longest;
  }
  const double most =
      settings.read.filter == ReadFilter::Anisotropic ? settings.read.anisotropy : 1.0;
  return {axis.x(), axis.y(),
          int(std::clamp(std::ceil(longer / std::max(shorter, 1.0)), 1.0, most))};
}

// The box of a summed-area table, for a size that depends on the pixel or on the distance.
Footprint boxOf(const Vector2d& dx, const Vector2d& dy, double distance, const FrameView& frame) {
  const ReadSettings& read = frame.settings.read;
  const double kernel = 2.0 * frame.settings.kernel.effectiveRadius() + 1.0;
  const double largest = ReadSettings::largestSatWidth;
  const auto limited = [&](double width) { return width < largest ? width : largest; };
  if (read.satSize == SatSize::Footprint)
    return {limited(std::max(std::abs(dx.x()) + std::abs(dy.x()), kernel)),
            limited(std::max(std::abs(dx.y()) + std::abs(dy.y()), kernel))};
  const double full = read.satDistance > 0.0 ? read.satDistance : frame.extent;
  const bool grows = read.satSize == SatSize::Distance;
  const double width = limited(grows ? kernel * std::max(full / distance, 1.0) : kernel);
  return {width, width};
}

// World units at the depth of a point.
double pixelSide(const PictureView& picture, const Vector3d& point) {
  const CameraAxes axes = axesOf(picture);
  return std::abs(axes.forward.dot(point - picture.camera.position)) / axes.scale;
}

}  // namespace

std::optional<Vector2d> PictureView::pixelOf(const Vector3d& world) const {
  const CameraAxes axes = axesOf(*this);
  const Vector3d way = world - camera.position;
  const double depth = axes.forward.dot(way);
  if (depth < nearest * (1.0 + way.norm())) return std::nullopt;
  return Vector2d(0.5 * width + axes.scale * axes.right.dot(way) / depth,
                  0.5 * height - axes.scale * axes.up.dot(way) / depth);
}

Vector3d PictureView::rayThrough(const Vector2d& pixel) const {
  const CameraAxes axes = axesOf(*this);
  return axes.forward + axes.right * ((pixel.x() - 0.5 * width) / axes.scale) -
         axes.up * ((pixel.y() - 0.5 * height) / axes.scale);
}

bool isSeenAt(const PictureView& picture, const Vector3d& point, const Vector3d& normal,
              const Vector3d& shown) {
  const Vector3d way = point - picture.camera.position;
  // A pixel's diagonal is at least twice as far as its centre can be from the point in it.
  const double diagonal = std::numbers::sqrt2 * pixelSide(picture, point);
  const double cosine = std::max(std::abs(normal.dot(way.normalized())), 0.01);
  return (shown - point).norm() <= diagonal / cosine + 1e-3 * way.norm();
}

bool isShownAt(const PictureView& picture, const Vector3d& point, const Vector3d& shown) {
  return (shown - point).norm() <= 0.01 * pixelSide(picture, point);
}

std::variant<SurfacePoint, Unreadable> readOfSurface(const SurfaceSpot& spot,
                                                     const FrameView& frame) {
  const auto& [point, normal, object, twoSided] = spot;
  const FrameSettings& settings = frame.settings;
  const LightPoint light = frame.light.project(point);
  const auto place = light.inside ? cascadeOf(point, light, frame) : std::nullopt;
  if (!place) return Unreadable::OutsideMap;
  const Cascade& own = frame.cascades[place->cascade];
  SurfacePoint result;
  result.world = point;
  result.cascade = place->cascade;
  result.nextCascade = place->next;
  result.u = own.u(light.u);
  result.v = own.v(light.v);

  const ReadFilter filter = settings.read.filter;
  const bool summed = filter == ReadFilter::SummedArea;
  const bool byPixel = filter == ReadFilter::Trilinear || filter == ReadFilter::Anisotropic ||
                       (summed && settings.read.satSize == SatSize::Footprint);
  const auto steps = stepsOnMap(point, normal, frame, own);
  if (byPixel && !steps) return Unreadable::NotInSight;
  const auto [dx, dy] = steps.value_or(std::pair<Vector2d, Vector2d>{{0.0, 0.0}, {0.0, 0.0}});
  if (summed)
    result.footprint = boxOf(dx, dy, (point - frame.picture.camera.position).norm(), frame);
  else if (byPixel)
    result.footprint = axisOf(dx, dy, settings);

  // In a seam both cascades have one receiver, with the bias of the coarser one.
  const double coarsest =
      place->next > 0.0 ? std::max(own.side, frame.cascades[place->cascade + 1].side) : own.side;
  const ReadPoint read{filter, result.u, result.v, result.footprint};
  result.receiver =
      biasedReceiver(light.z, settings.bias,
                     coarsest * depthPerTexel(frame.light, settings.map.size, point, normal),
                     readReach(read, settings, own.side / coarsest));
  const Vector3d toLight = frame.light.kind == LightKind::Spot
                               ? Vector3d(frame.light.position - point)
                               : Vector3d(-frame.light.direction);
  const double side =
      twoSided && normal.dot(frame.picture.camera.position - point) < 0.0 ? -1.0 : 1.0;
  result.facesLight = side * normal.dot(toLight) > 0.0;
  return result;
}

}  // namespace umbra
