// The settings that a shaded frame depends on, beside scene, light, camera and technique.
#pragma once

#include <optional>
#include <string_view>

#include "filters/core/scene/Camera.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/settings/StorageFormat.h"

namespace umbra {

// The view is cut along its depth into parts with a shadow map each (Zhang 2006, parallel-split
// shadow maps).
struct CascadeSettings {
  static constexpr int largestCount = 4;
  static constexpr double largestSeam = 0.5;

  int count = 1;
  double splitLambda = 0.5;  // 0 cuts evenly, 1 logarithmically
  // The last part of each cascade's depth, over which it goes over into the next: 0 … largestSeam.
  double seam = 0.1;
  // Where set, this camera's view is split instead of the view of the camera that draws the
  // picture.
  std::optional<Camera> frozen;

  bool operator==(const CascadeSettings&) const = default;
};

struct MapSettings {
  static constexpr int smallest = 16, largest = 8192;
  static constexpr int largestSamples = 8;

  int size = 1024;  // texels a side, smallest … largest
  StorageFormat format = StorageFormat::Float;
  // Depths per texel, 1, 2, 4 or 8: each is encoded, then their channels are averaged. A driver may
  // give fewer than were asked for.
  int samples = 1;
  CascadeSettings cascades;

  bool operator==(const MapSettings&) const = default;
};

// How the shaded frame reads the prefiltered channels.
enum class ReadFilter { Point, Bilinear, Trilinear, Anisotropic, SummedArea };

// How wide a box a summed-area table averages; it is never narrower than the kernel's window.
// Footprint: as wide as the pixel's footprint on the map. Distance: the wider the nearer the camera
// is. Fixed: the kernel's window.
enum class SatSize { Footprint, Distance, Fixed };

// What the table sums. Centred: values less a constant near their mean, in 32-bit floats. Integer:
// fixed-point values, in 32-bit integers modulo 2³². Plain: the values as they are, in 32-bit
// floats, whose sums lose digits as the map grows.
enum class SatPrecision { Centred, Integer, Plain };

struct ReadSettings {
  static constexpr int largestAnisotropy = 16;
  static constexpr double largestSatDistance = 1e6;
  // Texels. The 16-bit fixed-point values of so large a box still sum up to less than 2³².
  static constexpr int largestSatWidth = 255;

  ReadFilter filter = ReadFilter::Bilinear;
  int anisotropy = 8;  // Anisotropic: the most reads along the footprint's longer axis
  SatSize satSize = SatSize::Footprint;
  SatPrecision satPrecision = SatPrecision::Centred;
  // SatSize::Distance: the box is satDistance / distance times the kernel's window, and at least
  // that window. World units; 0 stands for the diagonal of the bounds that the light's frame holds.
  double satDistance = 0.0;

  bool operator==(const ReadSettings&) const = default;
};

// Lowers the receiver's depth before any technique sees it, so that a surface does not shadow
// itself. All terms add up; the sum is subtracted from z and the result clamped to [0,1].
struct Bias {
  static constexpr double largestConstant = 1.0, largestSlope = 100.0;

  double constant = 5e-4;  // normalised depth
  // The depth that the receiver's plane gains over this many texels of the map is subtracted.
  double slope = 1.0;
  // The gain over the half width of the filter's region is subtracted as well, so that no tap of a
  // plane blocks the plane.
  bool receiverPlane = true;
  // The casters' faces towards the light are left out of the map: closed bodies shadow with their
  // far side.
  bool cullFrontFaces = false;

  bool operator==(const Bias&) const = default;
};

enum class ViewMode { Shaded, Visibility, Error, Depth, Layers, Cascades };

struct FrameSettings {
  static constexpr double smallestErrorRange = 0.001;

  MapSettings map;
  Kernel kernel;
  ReadSettings read;
  Bias bias;
  ViewMode view = ViewMode::Shaded;
  double errorRange = 1.0;  // the size of error that has its full colour in the view of errors

  bool operator==(const FrameSettings&) const = default;
};

std::string_view nameOf(ReadFilter read);
std::string_view nameOf(SatSize size);
std::string_view nameOf(SatPrecision precision);
std::string_view nameOf(ViewMode view);

}  // namespace umbra
