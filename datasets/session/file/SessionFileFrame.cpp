#include "datasets/session/file/SessionFileFrame.h"

#include <bit>
#include <nlohmann/json.hpp>
#include <string>

#include "filters/core/support/Error.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;

void readPoint(JsonObject& object, std::string_view key, Eigen::Vector3d& target) {
  double values[3] = {target.x(), target.y(), target.z()};
  object.readVector(key, values);
  target = {values[0], values[1], values[2]};
}

Json pointJson(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

Json cameraJson(const Camera& camera) {
  return {{"position", pointJson(camera.position)},
          {"target", pointJson(camera.target)},
          {"up", pointJson(camera.up)},
          {"viewAngle", camera.viewAngle}};
}

Camera cameraFrom(JsonObject& object) {
  Camera camera;
  readPoint(object, "position", camera.position);
  readPoint(object, "target", camera.target);
  readPoint(object, "up", camera.up);
  object.read("viewAngle", camera.viewAngle, Camera::smallestViewAngle, Camera::largestViewAngle);
  validate(camera, object.where());
  return camera;
}

namespace {

Json cascadesJson(const CascadeSettings& cascades) {
  Json json{
      {"count", cascades.count}, {"splitLambda", cascades.splitLambda}, {"seam", cascades.seam}};
  if (cascades.frozen) json["frozen"] = cameraJson(*cascades.frozen);
  return json;
}

void readCascades(JsonObject& object, CascadeSettings& cascades) {
  object.read("count", cascades.count, 1, CascadeSettings::largestCount);
  object.read("splitLambda", cascades.splitLambda, 0.0, 1.0);
  object.read("seam", cascades.seam, 0.0, CascadeSettings::largestSeam);
  object.readObject("frozen", [&](JsonObject& camera) { cascades.frozen = cameraFrom(camera); });
}

void readTable(JsonObject& object, ReadSettings& read) {
  object.readName("size", [&](const std::string& name, const std::string& where) {
    read.satSize = satSizeFrom(name, where);
  });
  object.readName("precision", [&](const std::string& name, const std::string& where) {
    read.satPrecision = satPrecisionFrom(name, where);
  });
  object.read("distance", read.satDistance, 0.0, ReadSettings::largestSatDistance);
}

void readSamples(JsonObject& object, int& samples) {
  object.read("msaa", samples, 1, MapSettings::largestSamples);
  if (!std::has_single_bit(unsigned(samples)))
    throw Error(ErrorKind::BadInput, object.where() + ".msaa: " + std::to_string(samples) +
                                         " is not right, it takes 1, 2, 4 or 8");
}

}  // namespace

Json frameJson(const FrameSettings& frame) {
  return {{"mapSize", frame.map.size},
          {"format", nameOf(frame.map.format)},
          {"filter", nameOf(frame.read.filter)},
          {"anisotropy", frame.read.anisotropy},
          {"sat",
           {{"size", nameOf(frame.read.satSize)},
            {"precision", nameOf(frame.read.satPrecision)},
            {"distance", frame.read.satDistance}}},
          {"msaa", frame.map.samples},
          {"cascades", cascadesJson(frame.map.cascades)},
          {"view", nameOf(frame.view)},
          {"kernel",
           {{"shape", nameOf(frame.kernel.shape)},
            {"radius", frame.kernel.radius},
            {"sigma", frame.kernel.sigma}}},
          {"bias",
           {{"constant", frame.bias.constant},
            {"slope", frame.bias.slope},
            {"receiverPlane", frame.bias.receiverPlane},
            {"cullFrontFaces", frame.bias.cullFrontFaces}}}};
}

void readFrame(JsonObject& object, FrameSettings& frame) {
  readMapAndReads(object, frame);
  object.readName("view", [&](const std::string& name, const std::string& where) {
    frame.view = viewModeFrom(name, where);
  });
}

void readMapAndReads(JsonObject& object, FrameSettings& frame) {
  object.read("mapSize", frame.map.size, MapSettings::smallest, MapSettings::largest);
  object.readName("format", [&](const std::string& name, const std::string& where) {
    frame.map.format = storageFormatFrom(name, where);
  });
  object.readName("filter", [&](const std::string& name, const std::string& where) {
    frame.read.filter = readFilterFrom(name, where);
  });
  object.read("anisotropy", frame.read.anisotropy, 1, ReadSettings::largestAnisotropy);
  object.readObject("sat", [&](JsonObject& sat) { readTable(sat, frame.read); });
  readSamples(object, frame.map.samples);
  object.readObject("cascades",
                    [&](JsonObject& cascades) { readCascades(cascades, frame.map.cascades); });
  object.readObject("kernel", [&](JsonObject& kernel) {
    kernel.readName("shape", [&](const std::string& name, const std::string& where) {
      frame.kernel.shape = kernelShapeFrom(name, where);
    });
    kernel.read("radius", frame.kernel.radius, 0, Kernel::largestRadius);
    kernel.read("sigma", frame.kernel.sigma, 0.0, Kernel::largestSigma);
    if (const double sigma = frame.kernel.sigma; sigma != 0.0 && sigma < Kernel::smallestSigma)
      throw Error(ErrorKind::BadInput, kernel.where() + ".sigma: " + toText(sigma) +
                                           " is not right, it takes 0 or a number from " +
                                           shortNumber(Kernel::smallestSigma) + " to " +
                                           shortNumber(Kernel::largestSigma));
  });
  object.readObject("bias", [&](JsonObject& bias) {
    bias.read("constant", frame.bias.constant, 0.0, Bias::largestConstant);
    bias.read("slope", frame.bias.slope, 0.0, Bias::largestSlope);
    bias.read("receiverPlane", frame.bias.receiverPlane);
    bias.read("cullFrontFaces", frame.bias.cullFrontFaces);
  });
}

}  // namespace umbra
