// What a shaded frame depends on beside scene, light, camera and technique.
#pragma once

#include <string_view>

#include "filters/core/Kernel.h"
#include "filters/core/StorageFormat.h"

namespace umbra {

struct MapSettings {
  static constexpr int smallest = 16, largest = 8192;

  int size = 1024;  // texels a side, smallest … largest
  StorageFormat format = StorageFormat::Float;

  bool operator==(const MapSettings&) const = default;
};

// How the shaded frame reads the prefiltered channels.
enum class ReadFilter { Point, Bilinear };

// Lowers the receiver's depth before any technique sees it, so that a surface does not shadow
// itself. All terms add up; the sum is subtracted from z and the result clamped to [0,1].
struct Bias {
  static constexpr double largestConstant = 1.0, largestSlope = 100.0;

  double constant = 5e-4;  // normalised depth
  // Depth that the receiver's plane gains over this many texels of the map.
  double slope = 1.0;
  // Also over the half width of the filter region, so that no tap of a plane blocks the plane.
  bool receiverPlane = true;
  // Casters' faces towards the light leave no depth: closed bodies shadow with their far side.
  bool cullFrontFaces = false;

  bool operator==(const Bias&) const = default;
};

enum class ViewMode { Shaded, Visibility, Error, Depth, Layers };

struct FrameSettings {
  MapSettings map;
  Kernel kernel;
  ReadFilter read = ReadFilter::Bilinear;
  Bias bias;
  ViewMode view = ViewMode::Shaded;

  bool operator==(const FrameSettings&) const = default;
};

std::string_view nameOf(ReadFilter read);
std::string_view nameOf(ViewMode view);
// Both throw BadCommandLine for an unknown name and list the right ones. `where` is what the
// message begins with: an option, or a file and key.
ReadFilter readFilterFrom(std::string_view name, std::string_view where);
ViewMode viewModeFrom(std::string_view name, std::string_view where);

}  // namespace umbra
