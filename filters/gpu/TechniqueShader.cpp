#include "filters/gpu/TechniqueShader.h"

#include <algorithm>
#include <type_traits>

#include "ShadowMapRead_glsl.h"

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

}  // namespace

int layersFor(int channels) {
  return (channels + 3) / 4;
}

ChannelRange rangeOf(const Channel& channel, StorageFormat format) {
  if (!isNormalised(format)) return {};
  return {float(channel.low), float(channel.high - channel.low)};
}

std::string techniqueSource(const Technique& technique) {
  const std::string count = std::to_string(technique.channels().size());
  return "#define UMBRA_CHANNELS " + count + "\n" + ShadowMapRead_glsl + "\n" +
         std::string(technique.glsl()) + "\n";
}

std::string computeSource(const Technique& technique, const std::string& body) {
  return "#version 430\n" + techniqueSource(technique) + body;
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

void setReadUniforms(GLuint program, const Kernel& kernel, ReadFilter read) {
  gl::setUniform(program, "umbraBilinear", read == ReadFilter::Bilinear ? 1 : 0);
  gl::setUniform(program, "umbraRadius", kernel.effectiveRadius());
  gl::setUniform(program, "umbraWeights", halfWeights(kernel));
}

std::vector<float> halfWeights(const Kernel& kernel) {
  const std::vector<double> weights = kernel.weights();
  return {weights.begin() + kernel.effectiveRadius(), weights.end()};
}

}  // namespace umbra
