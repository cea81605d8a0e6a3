#include "filters/gpu/TechniqueShader.h"

#include <algorithm>
#include <type_traits>

#include "ReadLevels_glsl.h"
#include "ReadPixel_glsl.h"
#include "ReadTexels_glsl.h"
#include "SatRead_glsl.h"
#include "ShadowMapRead_glsl.h"
#include "filters/gpu/SummedAreaTable.h"

namespace umbra {
namespace {

std::string uniformName(std::string_view parameter) {
  std::string name = "umbra_" + std::string(parameter);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

void setList(GLuint program, const std::string& name, const std::vector<double>& values) {
  const std::vector<float> floats(values.begin(), values.end());
  gl::setUniform(program, (name + "_count").c_str(), int(floats.size()));
  if (!floats.empty()) gl::setUniform(program, name.c_str(), floats);
}

void setParameter(GLuint program, const Parameter& parameter) {
  const std::string name = uniformName(parameter.name);
  const ParameterValue value = parameter.get();
  if (const auto* real = std::get_if<double>(&value)) {
    gl::setUniform(program, name.c_str(), float(*real));
  } else if (const auto* integer = std::get_if<int>(&value)) {
    gl::setUniform(program, name.c_str(), *integer);
  } else if (const auto* choice = std::get_if<std::string>(&value)) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), *choice);
    gl::setUniform(program, name.c_str(), int(found - parameter.choices.begin()));
  } else {
    setList(program, name, std::get<std::vector<double>>(value));
  }
}

// The number by which ShadowMapRead.glsl knows it.
int filterNumber(ReadFilter filter) {
  switch (filter) {
    case ReadFilter::Point:
      return 0;
    case ReadFilter::Bilinear:
      return 1;
    case ReadFilter::Trilinear:
    case ReadFilter::Anisotropic:
      return 2;
    case ReadFilter::SummedArea:
      return 3;
  }
  return 0;
}

const char* filterSource(ReadFilter filter) {
  if (readsLevels(filter)) return ReadLevels_glsl;
  return filter == ReadFilter::SummedArea ? SatRead_glsl : ReadTexels_glsl;
}

// The weights of all taps up to each distance from the centre: radius + 1 floats, the last 1.
std::vector<float> windowWeights(const Kernel& kernel) {
  const std::vector<double> weights = kernel.weights();
  const int r = kernel.effectiveRadius();
  std::vector<float> sums;
  double sum = 0.0;
  for (int i = 0; i <= r; ++i) {
    sum += i == 0 ? weights[r] : 2.0 * weights[r + i];
    sums.push_back(i == r ? 1.0f : float(sum));
  }
  return sums;
}

}  // namespace

int layersFor(int channels) {
  return (channels + 3) / 4;
}

ChannelRange rangeOf(const Channel& channel, StorageFormat format) {
  if (!isNormalised(format)) return {};
  return {float(channel.low), float(channel.high - channel.low)};
}

bool readsLevels(ReadFilter filter) {
  return filter == ReadFilter::Trilinear || filter == ReadFilter::Anisotropic;
}

StorageFormat readFormat(StorageFormat stored, const MapReads& reads) {
  const bool fractions =
      reads.filter == ReadFilter::SummedArea && reads.satPrecision == SatPrecision::Integer;
  return fractions ? StorageFormat::Unorm16 : stored;
}

std::string techniqueSource(const Technique& technique, const MapReads& reads) {
  const auto define = [](const char* name, std::size_t value) {
    return std::string("#define UMBRA_") + name + " " + std::to_string(value) + "\n";
  };
  return define("CHANNELS", technique.channels().size()) +
         define("PREFILTERED", technique.info().prefilterable) +
         define("LAYER_CHANNELS", std::size_t(technique.info().layerChannels)) +
         define("FILTER", filterNumber(reads.filter)) + define("SAMPLES", reads.samples) +
         define("CASCADES", reads.cascades) + define("LARGEST_BOX", ReadSettings::largestSatWidth) +
         define("SAT_PRECISION", satPrecisionNumber(reads.satPrecision)) + ShadowMapRead_glsl +
         filterSource(reads.filter) + ReadPixel_glsl + "\n" + std::string(technique.glsl()) + "\n";
}

std::string computeSource(const Technique& technique, const MapReads& reads,
                          const std::string& body) {
  return "#version 430\n" + techniqueSource(technique, reads) + body;
}

void setTechniqueUniforms(GLuint program, Technique& technique, StorageFormat format) {
  for (const Parameter& parameter : technique.parameters()) setParameter(program, parameter);
  for (const Uniform& uniform : technique.derivedUniforms())
    std::visit([&](const auto& value) { gl::setUniform(program, uniform.name.c_str(), value); },
               uniform.value);
  std::vector<float> low, span;
  for (const Channel& channel : technique.channels()) {
    const ChannelRange range = rangeOf(channel, format);
    low.push_back(range.low);
    span.push_back(range.span);
  }
  gl::setUniform(program, "umbraLow", low);
  gl::setUniform(program, "umbraSpan", span);
}

void setReadUniforms(GLuint program, const MapReads& reads) {
  gl::setUniform(program, "umbraRadius", reads.kernel.effectiveRadius());
  if (readsLevels(reads.filter))
    gl::setUniform(program, "umbraWindow", windowWeights(reads.kernel));
  else
    gl::setUniform(program, "umbraWeights", halfWeights(reads.kernel));
  if (reads.cascades > 1)
    gl::setUniform3(program, "umbraCascadeWindows",
                    {reads.windows[0].data(), 3 * reads.windows.size()});
}

std::vector<float> halfWeights(const Kernel& kernel) {
  const std::vector<double> weights = kernel.weights();
  return {weights.begin() + kernel.effectiveRadius(), weights.end()};
}

}  // namespace umbra
