// Where a picture is taken from.
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace umbra {

struct Camera {
  static constexpr double smallestViewAngle = 1.0, largestViewAngle = 120.0;

  Eigen::Vector3d position{0.0, 2.0, 6.0};  // world
  Eigen::Vector3d target{0.0, 0.0, 0.0};    // world
  Eigen::Vector3d up{0.0, 1.0, 0.0};
  double viewAngle = 30.0;  // degrees, vertical, within the range above

  bool operator==(const Camera&) const = default;
};

// Throws BadInput for a camera that has no picture: a position equal to the target, an up vector of
// no length or along the view, a view angle out of range, a coordinate that is not finite or out of
// reach. `where` is what the message begins with: an option, or a file and key.
void validate(const Camera& camera, std::string_view where);
// Whether the up vector lies along the view, to 1e-6 rad.
bool looksAlongUp(const Camera& camera);

}  // namespace umbra
