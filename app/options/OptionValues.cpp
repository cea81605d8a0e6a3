#include "app/options/OptionValues.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr double unbounded = std::numeric_limits<double>::max();

[[noreturn]] void refuse(std::string_view option, std::string_view text, const std::string& right) {
  throw Error(ErrorKind::BadCommandLine, std::string(option) + ": '" + std::string(text) +
                                             "' is not right, it takes " + right);
}

std::optional<double> finiteNumber(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<int> wholeNumber(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Exactly `count` numbers, separated by commas; empty where the text is anything else.
std::vector<double> numbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  for (const std::string& part : split(text, ',')) {
    const std::optional<double> value = finiteNumber(part);
    if (!value) return {};
    values.push_back(*value);
  }
  if (values.size() != count || text.back() == ',') return {};
  return values;
}

std::optional<Eigen::Vector3d> point(std::string_view text) {
  const std::vector<double> values = numbers(text, 3);
  if (values.empty()) return std::nullopt;
  return Eigen::Vector3d(values[0], values[1], values[2]);
}

}  // namespace

double numberFrom(std::string_view text, std::string_view option, NumberRange range) {
  const std::optional<double> value = finiteNumber(text);
  if (!value || *value < range.low || *value > range.high) {
    std::string right = "a number";
    if (range.low > -unbounded) right += " from " + shortNumber(range.low);
    if (range.high < unbounded) right += " to " + shortNumber(range.high);
    refuse(option, text, right);
  }
  return *value;
}

int integerFrom(std::string_view text, std::string_view option, int low, int high) {
  const std::optional<int> value = wholeNumber(text);
  if (!value || *value < low || *value > high)
    refuse(option, text,
           "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return *value;
}

void refuseEmpty(std::string_view text, std::string_view option, const std::string& right) {
  if (text.empty()) refuse(option, text, right);
}

bool rayTracedFrom(std::string_view text, std::string_view option) {
  if (text != "pcf" && text != "raytraced") refuse(option, text, "pcf or raytraced");
  return text == "raytraced";
}

Eigen::Vector3d pointFrom(std::string_view text, std::string_view option) {
  const std::optional<Eigen::Vector3d> value = point(text);
  if (!value) refuse(option, text, "three numbers X,Y,Z");
  return *value;
}

Pixel pixelFrom(std::string_view text, std::string_view option) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() == 2 && text.back() != ',') {
    const std::optional<int> x = wholeNumber(parts[0]), y = wholeNumber(parts[1]);
    if (x && y && *x >= 0 && *y >= 0) return {*x, *y};
  }
  refuse(option, text, "X,Y: two whole numbers from 0, y down");
}

std::pair<int, int> texelFrom(std::string_view text, std::string_view option) {
  const std::vector<double> values = numbers(text, 2);
  const auto isTexel = [](double value) {
    return value == std::floor(value) && std::abs(value) < 1e9;
  };
  if (values.empty() || !isTexel(values[0]) || !isTexel(values[1]))
    refuse(option, text, "X,Y: two whole numbers");
  return {int(values[0]), int(values[1])};
}

std::pair<double, double> depthRangeFrom(std::string_view text, std::string_view option) {
  const std::vector<double> values = numbers(text, 2);
  if (values.empty() || values[0] == values[1] || !std::isfinite(values[1] - values[0]))
    refuse(option, text, "NEAR,FAR: two numbers that differ, by what is finite");
  return {values[0], values[1]};
}

std::pair<std::string, std::string> assignmentFrom(std::string_view text, std::string_view option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) refuse(option, text, "NAME=VALUE");
  return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

void asOption(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    throw Error(ErrorKind::BadCommandLine, error.what());
  }
}

Light lightFrom(std::string_view text, std::string_view option, const Light& base) {
  const std::vector<std::string> parts = split(text, ':');
  const bool spot = !parts.empty() && parts[0] == "spot";
  const bool known = spot || (!parts.empty() && parts[0] == "directional");
  if (!known || parts.size() < 2 || parts.size() > (spot ? 4u : 3u))
    refuse(option, text, std::string(lightSyntax));
  Light light = base;
  light.kind = spot ? LightKind::Spot : LightKind::Directional;
  light.position = pointFrom(parts[1], option);
  if (parts.size() > 2) light.target = pointFrom(parts[2], option);
  if (parts.size() > 3)
    light.halfAngle =
        numberFrom(parts[3], option, {Light::smallestHalfAngle, Light::largestHalfAngle});
  asOption([&] { validate(light, option); });
  return light;
}

Camera cameraFrom(std::string_view text, std::string_view option, const Camera& base) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() < 2 || parts.size() > 3) refuse(option, text, std::string(cameraSyntax));
  Camera camera = base;
  camera.position = pointFrom(parts[0], option);
  camera.target = pointFrom(parts[1], option);
  if (parts.size() > 2)
    camera.viewAngle =
        numberFrom(parts[2], option, {Camera::smallestViewAngle, Camera::largestViewAngle});
  // A camera that looks along its own up vector has no picture; any other up will do.
  const Eigen::Vector3d direction = (camera.target - camera.position).normalized();
  if (looksAlongUp(camera))
    camera.up = std::abs(direction.y()) > 0.5 ? Eigen::Vector3d(0.0, 0.0, -1.0)
                                              : Eigen::Vector3d(0.0, 1.0, 0.0);
  asOption([&] { validate(camera, option); });
  return camera;
}

}  // namespace umbra
