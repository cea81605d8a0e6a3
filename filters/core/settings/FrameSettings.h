// What a shaded frame depends on beside scene, light, camera and technique.
#pragma once

#include <optional>
#include <string_view>

#include "filters/core/scene/Camera.h"
#include "filters/core/settings/Kernel.h"
#include "filters/core/settings/StorageFormat.h"

namespace umbra {

// The view cut along its depth, with a shadow map for each part (Zhang 2006, parallel-split shadow
// maps).
struct CascadeSettings {
  static constexpr int largestCount = 4;
  static constexpr double largestSeam = 0.5;

  int count = 1;
  double splitLambda = 0.5;  // 0 cuts evenly, 1 logarithmically
  // The last part of each cascade's depth over which it goes over into the next, 0 … largestSeam.
  double seam = 0.1;
  // Splits this camera's view, where set, and not that of the one which looks.
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

// How wide a box a summed-area table averages, never narrower than the kernel's window: the pixel's
// footprint on the map; wider the nearer the camera is; always the kernel's window.
enum class SatSize { Footprint, Distance, Fixed };

// What the table sums: values less a constant near their mean, in 32-bit floats; fixed-point
// values, in 32-bit integers modulo 2³²; the values as they are, in 32-bit floats, whose sums lose
// digits as the map grows.
enum class SatPrecision { Centred, Integer, Plain };

struct ReadSettings {
  static constexpr int largestAnisotropy = 16;
  static constexpr double largestSatDistance = 1e6;
  // Texels: 16-bit fixed-point values of so large a box still sum up to less than 2³².
  static constexpr int largestSatWidth = 255;

  ReadFilter filter = ReadFilter::Bilinear;
  int anisotropy = 8;  // Anisotropic: reads along the longer axis of the footprint, at most
  SatSize satSize = SatSize::Footprint;
  SatPrecision satPrecision = SatPrecision::Centred;
  // SatSize::Distance: the box is satDistance / distance times the kernel's window, at least once.
  // World units; 0 is the diagonal of what bounds the light.
  double satDistance = 0.0;

  bool operator==(const ReadSettings&) const = default;
};

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

enum class ViewMode { Shaded, Visibility, Error, Depth, Layers, Cascades };

struct FrameSettings {
  MapSettings map;
  Kernel kernel;
  ReadSettings read;
  Bias bias;
  ViewMode view = ViewMode::Shaded;

  bool operator==(const FrameSettings&) const = default;
};

std::string_view nameOf(ReadFilter read);
std::string_view nameOf(SatSize size);
std::string_view nameOf(SatPrecision precision);
std::string_view nameOf(ViewMode view);
// All throw BadCommandLine for an unknown name and list the right ones. `where` is what the
// message begins with: an option, or a file and key.
ReadFilter readFilterFrom(std::string_view name, std::string_view where);
SatSize satSizeFrom(std::string_view name, std::string_view where);
SatPrecision satPrecisionFrom(std::string_view name, std::string_view where);
ViewMode viewModeFrom(std::string_view name, std::string_view where);

}  // namespace umbra
