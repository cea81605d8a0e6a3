#include "analysis/rays/CasterRays.h"

#if UMBRA_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

using Eigen::Vector3d;

template <class Handle, void (*release)(Handle)>
struct Releaser {
  void operator()(Handle handle) const { release(handle); }
};
template <class Handle, void (*release)(Handle)>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Releaser<Handle, release>>;

using Device = Owned<RTCDevice, rtcReleaseDevice>;
using Tracer = Owned<RTCScene, rtcReleaseScene>;
using Geometry = Owned<RTCGeometry, rtcReleaseGeometry>;

void throwIfFailed(RTCDevice device, const char* step) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw Error(ErrorKind::WorkFailed,
              std::string("ray tracing: ") + step + " failed with error " +
                  std::to_string(int(error)) + " of Embree" +
                  (error == RTC_ERROR_OUT_OF_MEMORY ? ", which found too little memory" : ""));
}

// Triangles run counter-clockwise seen from outside, so that their normal points outwards: a ray
// that runs against the normal meets the front.
void rejectFrontFaces(const RTCFilterFunctionNArguments* arguments) {
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] != -1) continue;
    const RTCRay ray = rtcGetRayFromRayN(arguments->ray, arguments->N, i);
    const RTCHit hit = rtcGetHitFromHitN(arguments->hit, arguments->N, i);
    if (hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z < 0.0f)
      arguments->valid[i] = 0;
  }
}

// Embree 3 and 4 differ in the further arguments of a ray, of which none is used here.
void intersect(RTCScene scene, RTCRayHit& ray) {
#if UMBRA_EMBREE >= 4
  rtcIntersect1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
#endif
}

Geometry geometryOf(RTCDevice device, const Mesh& mesh, bool cullFrontFaces) {
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  throwIfFailed(device, "making a mesh");
  void* vertices =
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(Eigen::Vector3f), mesh.positions.size());
  void* indices =
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              sizeof(mesh.triangles.front()), mesh.triangles.size());
  throwIfFailed(device, "copying a mesh");
  std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(Eigen::Vector3f));
  std::memcpy(indices, mesh.triangles.data(),
              mesh.triangles.size() * sizeof(mesh.triangles.front()));
  if (cullFrontFaces) rtcSetGeometryIntersectFilterFunction(geometry.get(), rejectFrontFaces);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace

class CasterRays::Implementation {
 public:
  Implementation(const Scene& scene, bool cullFrontFaces) : device_(rtcNewDevice(nullptr)) {
    throwIfFailed(device_.get(), "starting");
    tracer_.reset(rtcNewScene(device_.get()));
    // The flag makes rays between two triangles that share an edge hit one of them.
    rtcSetSceneFlags(tracer_.get(), RTC_SCENE_FLAG_ROBUST);
    for (const SceneObject& object : scene.objects) {
      if (object.mesh.triangles.empty()) continue;
      bounds_.extend(object.mesh.bounds());
      rtcAttachGeometry(tracer_.get(),
                        geometryOf(device_.get(), object.mesh, cullFrontFaces).get());
    }
    rtcCommitScene(tracer_.get());
    throwIfFailed(device_.get(), "building the tree of triangles");
  }

  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  // The first hit along `direction`, unit; infinite where there is none.
  double distance(const Vector3d& origin, const Vector3d& direction) const {
    RTCRayHit ray{};
    ray.ray.org_x = float(origin.x());
    ray.ray.org_y = float(origin.y());
    ray.ray.org_z = float(origin.z());
    ray.ray.dir_x = float(direction.x());
    ray.ray.dir_y = float(direction.y());
    ray.ray.dir_z = float(direction.z());
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(tracer_.get(), ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<double>::infinity()
                                                     : ray.ray.tfar;
  }

 private:
  Device device_;
  Tracer tracer_;
  Eigen::AlignedBox3d bounds_;
};

CasterRays::CasterRays(const Scene& scene, bool cullFrontFaces)
    : implementation_(std::make_unique<Implementation>(scene, cullFrontFaces)) {}
CasterRays::~CasterRays() = default;
CasterRays::CasterRays(CasterRays&&) noexcept = default;
CasterRays& CasterRays::operator=(CasterRays&&) noexcept = default;

LightRays CasterRays::raysOf(const LightFrame& frame) const {
  LightRays rays;
  rays.kind = frame.kind;
  rays.nearDistance = frame.nearDistance;
  rays.farDistance = frame.farDistance;
  if (frame.kind == LightKind::Spot) {
    rays.fixed = frame.position;
    const auto through = [&](double u, double v) -> Vector3d {
      const Vector3d ray = frame.unproject(u, v, 1.0) - frame.position;
      return ray / ray.dot(frame.direction);
    };
    rays.first = through(0.0, 0.0);
    rays.perU = through(1.0, 0.0) - rays.first;
    rays.perV = through(0.0, 1.0) - rays.first;
    return rays;
  }
  rays.fixed = frame.direction;
  const Eigen::AlignedBox3d& bounds = implementation_->bounds();
  if (!bounds.isEmpty()) {
    for (int corner = 0; corner < 8; ++corner)
      rays.lead = std::max(
          rays.lead, frame.nearDistance -
                         frame.distance(bounds.corner(Eigen::AlignedBox3d::CornerType(corner))));
    // This is more than rounding the origin to single precision moves it.
    if (rays.lead > 0.0) rays.lead += 1e-5 * (bounds.diagonal().norm() + rays.lead);
  }
  const Vector3d back = rays.lead * frame.direction;
  rays.first = frame.unproject(0.0, 0.0, 0.0) - back;
  rays.perU = frame.unproject(1.0, 0.0, 0.0) - back - rays.first;
  rays.perV = frame.unproject(0.0, 1.0, 0.0) - back - rays.first;
  return rays;
}

double CasterRays::depth(const LightRays& rays, double u, double v) const {
  const Vector3d moved = rays.first + u * rays.perU + v * rays.perV;
  const double distance =
      rays.kind == LightKind::Spot
          ? implementation_->distance(rays.fixed, moved.normalized())
          : implementation_->distance(moved, rays.fixed) - rays.lead + rays.nearDistance;
  return std::clamp((distance - rays.nearDistance) / (rays.farDistance - rays.nearDistance), 0.0,
                    1.0);
}

}  // namespace umbra
