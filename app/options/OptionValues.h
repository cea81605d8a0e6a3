// Values of options, read from text: numbers, points, sizes. All throw BadCommandLine with one
// line that names the option and says what it takes.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/session/Session.h"
#include "filters/core/scene/Light.h"
#include "filters/core/scene/Scene.h"

namespace umbra {

struct NumberRange {
  double low, high;  // inclusive
};

// Finite and within the range.
double numberFrom(std::string_view text, std::string_view option, NumberRange range);
int integerFrom(std::string_view text, std::string_view option, int low, int high);
// Throws where the text is empty; `right` is what the option takes.
void refuseEmpty(std::string_view text, std::string_view option, const std::string& right);
// "pcf" or "raytraced": whether rays are the truth.
bool rayTracedFrom(std::string_view text, std::string_view option);

// "X,Y,Z", world.
Eigen::Vector3d pointFrom(std::string_view text, std::string_view option);
// "X,Y", from 0.
Pixel pixelFrom(std::string_view text, std::string_view option);
// "X,Y" in a file's own count, which may begin below 0.
std::pair<int, int> texelFrom(std::string_view text, std::string_view option);
// "NEAR,FAR", which differ by what is finite. NEAR may be the larger one.
std::pair<double, double> depthRangeFrom(std::string_view text, std::string_view option);
// "NAME=VALUE".
std::pair<std::string, std::string> assignmentFrom(std::string_view text, std::string_view option);

// Calls `read`. Any Error that it throws becomes BadCommandLine, since an option is wrong.
void asOption(const std::function<void()>& read);

inline constexpr std::string_view lightSyntax =
    "directional:X,Y,Z[:TO_X,TO_Y,TO_Z] or spot:X,Y,Z[:TO_X,TO_Y,TO_Z[:HALF_ANGLE]]";
inline constexpr std::string_view cameraSyntax = "X,Y,Z:TO_X,TO_Y,TO_Z[:VIEW_ANGLE]";

// What the text leaves out (target, angle, colour, intensity) stays as in `base`.
Light lightFrom(std::string_view text, std::string_view option, const Light& base);
Camera cameraFrom(std::string_view text, std::string_view option, const Camera& base);

}  // namespace umbra
