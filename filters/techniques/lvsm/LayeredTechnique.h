// What techniques that work in depth layers have in common beside the layers themselves.
#pragma once

#include "filters/core/technique/Technique.h"
#include "filters/techniques/lvsm/Layers.h"

namespace umbra {

// Derive `class Lvsm : public LayeredTechnique<Lvsm, P>`, where P derives from LayerParameters and
// has `static constexpr auto fields()`, a tuple of Field.
template <class Derived, class P>
class LayeredTechnique : public TechniqueWith<Derived, P> {
 public:
  using TechniqueWith<Derived, P>::parameters;
  std::vector<Parameter> parameters() override {
    return bindLayerParameters(TechniqueWith<Derived, P>::parameters(), this->values,
                               this->info().id);
  }
  // Must be called again after a change of layers or placement.
  void adapt(const DepthMap& map) override { setAdaptedSplits(relaxedSplits(this->values, map)); }
  int adaptedSplitCount() const override { return umbra::adaptedSplitCount(this->values); }
  void setAdaptedSplits(std::span<const double> splits) override {
    adaptedSplits_ = keptApart(splits);
  }
  std::vector<Uniform> derivedUniforms() const override { return layerUniforms(layering()); }

  Layering layering() const { return layeringOf(this->values, adaptedSplits_); }

 private:
  std::vector<double> adaptedSplits_;
};

}  // namespace umbra
