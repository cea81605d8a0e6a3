// A technique with one parameter of every kind, for forms to show.
#pragma once

#include <array>

#include "filters/core/technique/Technique.h"

namespace umbra {

enum class ExampleMode { Offset, Scale };

struct ExampleParameters {
  double variance = 1e-6;
  double amount = 0.25;
  int layers = 4;
  ExampleMode mode = ExampleMode::Offset;
  std::vector<double> splits{0.25, 0.5};

  static constexpr std::array<std::string_view, 2> modes{"offset", "scale"};
  static constexpr auto fields() {
    using P = ExampleParameters;
    Field<P, ExampleMode> mode{&P::mode,           "mode",         "", "", ExampleMode::Offset,
                               ExampleMode::Scale, "Which series."};
    mode.choices = modes;
    return std::tuple{
        Field<P, double>{&P::variance, "min-variance", "σ²min", "depth²", 1e-12, 1e-2,
                         "Smallest variance.", Scale::Logarithmic},
        Field<P, double>{&P::amount, "bleed-reduction", "a", "", 0.0, 0.99, "Cut off."},
        Field<P, int>{&P::layers, "layers", "N", "", 1, 16, "How many layers."}, mode,
        Field<P, std::vector<double>>{&P::splits, "splits", "s", "", 0.0, 1.0, "Interior splits."}};
  }
};

class ExampleTechnique final : public TechniqueWith<ExampleTechnique, ExampleParameters> {
 public:
  explicit ExampleTechnique(std::string_view id = "example", std::string_view title = "Example",
                            std::string_view colour = "#2563c9")
      : info_{.id = id,
              .title = title,
              .citation = "Lauritzen 2008, eq. 3.3",
              .summary = "Stores depth and its square.",
              .formula = "v = σ² / (σ² + (z_r − μ)²) for z_r > μ, else 1",
              .colour = colour} {}

  const TechniqueInfo& info() const override { return info_; }
  std::vector<Channel> channels() const override { return {{"M1"}}; }
  void encode(double z, std::span<double> channels) const override { channels[0] = z; }
  double visibility(const Fetch& fetch, double receiver) const override {
    return fetch.channels[0] >= receiver ? 1.0 : 0.0;
  }
  Trace explain(const Fetch& fetch, double receiver) const override {
    Trace trace;
    const TraceRecorder record(trace);
    record("M1", "mean of the region", "", fetch.channels[0]);
    record("v", "visibility", "1 for M1 ≥ z_r, else 0", visibility(fetch, receiver));
    return trace;
  }
  std::string_view glsl() const override { return ""; }
  std::string_view page() const override { return ""; }

 private:
  TechniqueInfo info_;
};

}  // namespace umbra
