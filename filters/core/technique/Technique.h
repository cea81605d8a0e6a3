// A technique: what it stores per texel, how that is reduced over a region, and how it estimates
// visibility from the reduced channels.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "filters/core/maps/Image.h"
#include "filters/core/maps/Region.h"
#include "filters/core/settings/StorageFormat.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/technique/Trace.h"

namespace umbra {

enum class Reduction { Mean, Min, Max };

struct Channel {
  std::string name;  // as in an exported EXR: "M1", "min", "C01"
  Reduction reduction = Reduction::Mean;
  // The range that a normalised format stores; meaningless for the floating ones.
  double low = 0.0, high = 1.0;
};

struct TechniqueInfo {
  std::string_view id;        // "power-cdf", as on the command line and in files
  std::string_view title;     // "Power CDF", for lists and legends
  std::string_view citation;  // "Gumbau et al. 2011, eq. 1–4"
  std::string_view summary;   // one sentence: what it stores
  std::string_view formula;   // one line, as plain text, for tooltips
  int order = 100;            // place in lists: simple before complicated
  bool upperBound = false;    // never below the reference, in exact arithmetic and at its defaults
  // How many channels each depth layer has, for a technique that stores several; 0 otherwise. Such
  // a technique's GLSL has no umbraVisibility but
  //   vec2 umbraLayer(float receiver);  the layer that holds it, and the weight of the next one
  //   float umbraVisibilityIn(int layer, float channels[UMBRA_LAYER_CHANNELS], float receiver);
  // so that a pixel reads the channels of one layer, or of two where they overlap, and no others.
  int layerChannels = 0;
  constexpr bool layered() const { return layerChannels > 0; }
  bool prefilterable = true;  // false: visibility reads the region's raw texels
  // An upper limit of the roundings in visibility()'s GLSL, including the scaling of its stored
  // channels: one for an operation, two for a division (reciprocal and product), none for a power
  // of two.
  int roundings = 32;
  std::string_view colour;  // "#rrggbb", the same in every plot, table and pane
};

// What a technique reads to estimate visibility.
struct Fetch {
  std::span<const double> channels;  // reduced over the region, as stored; in channels() order
  const Region& region;              // raw texels, for techniques that are not prefilterable
};

// A value that the technique's GLSL declares as `uniform float NAME`, `uniform int NAME` or
// `uniform float NAME[N]`.
struct Uniform {
  std::string name;
  std::variant<float, int, std::vector<float>> value;
};

// Instances are cheap, mutable values; a catalogue makes them and `clone` copies them.
//
// The C++ is the reference, in double. The GLSL is written apart from it and defines
//   void umbraEncode(float z, inout float channels[UMBRA_CHANNELS]);
//   float umbraVisibility(float channels[UMBRA_CHANNELS], float receiver);
// Its host defines UMBRA_CHANNELS before it and, for techniques that are not prefilterable,
//   float umbraNearestDepth();
//   float umbraPercentageCloser(float receiver);
//   ivec2 umbraNearestTexel();               the texel that holds the read's position
//   float umbraCloser(ivec2 texel, float receiver);  part of its samples at or behind the receiver
//   ivec2 umbraReach();                      Region::reachX, reachY
//   float umbraKernelAt(ivec2 offset);       the kernel's weight of a texel beside the nearest
class Technique {
 public:
  virtual ~Technique() = default;
  virtual std::unique_ptr<Technique> clone() const = 0;

  virtual const TechniqueInfo& info() const = 0;
  // The channels in storage order, four to a texture. They may depend on the parameters.
  virtual std::vector<Channel> channels() const = 0;
  // Bound to this instance: they are invalid once it is gone.
  virtual std::vector<Parameter> parameters() = 0;
  virtual std::vector<ParameterView> parameters() const = 0;

  // Sets what depends on the data, such as LVSM's splits. It is called once per depth map.
  virtual void adapt(const DepthMap&) {}
  // How many splits of the depth range follow the map's second occluders (Lauritzen 2008, §4.1.3):
  // whoever has found them, adapt() or the GPU, gives them to setAdaptedSplits, ascending. With 0
  // adapt() does nothing.
  virtual int adaptedSplitCount() const { return 0; }
  virtual void setAdaptedSplits(std::span<const double>) {}
  // Why channels cannot be stored in this format; empty where they can.
  virtual std::string refusal(StorageFormat) const { return {}; }
  // Clamps parameters to what the format can hold; returns one sentence for each that it changed.
  virtual std::vector<std::string> limitTo(StorageFormat) { return {}; }

  // z in [0,1] to channels().size() values.
  virtual void encode(double z, std::span<double> channels) const = 0;
  // The result is in [0,1]; `receiver` is the biased depth of the shaded surface.
  virtual double visibility(const Fetch& fetch, double receiver) const = 0;

  // How many times a rounding within visibility() counts in its result, beyond what rounded inputs
  // explain. May depend on the parameters.
  virtual double amplification() const { return 1.0; }

  // The numeric chain that ends in visibility(), and the step that goes wrong, if any does: the
  // last step's value is exactly what visibility() returns.
  virtual Trace explain(const Fetch& fetch, double receiver) const = 0;

  virtual std::string_view glsl() const = 0;
  // Uniforms beyond one for each parameter, which the host sets by itself: parameter `a-b` is
  // `umbra_a_b`, float or int (a choice is its index; a list is float[16] and `umbra_a_b_count`).
  virtual std::vector<Uniform> derivedUniforms() const { return {}; }

  // The technique's page, Markdown.
  virtual std::string_view page() const = 0;
};

// Copies a technique with its parameters. Derive `class Vsm : public TechniqueWith<Vsm, P>`, where
// P has `static constexpr auto fields()`, a tuple of Field.
template <class Derived, class P>
class TechniqueWith : public Technique {
 public:
  std::unique_ptr<Technique> clone() const override {
    return std::make_unique<Derived>(static_cast<const Derived&>(*this));
  }
  std::vector<Parameter> parameters() override { return bindFields(values, P::fields()); }
  std::vector<ParameterView> parameters() const override { return viewFields(values, P::fields()); }

  P values;
};

// For techniques with nothing to set.
struct NoParameters {
  static constexpr std::tuple<> fields() { return {}; }
};

}  // namespace umbra
