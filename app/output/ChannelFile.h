// An EXR file that explains itself: named float channels, and in its attributes the program's
// version, the session, every setting by its name in the table and every parameter.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "datasets/maps/ExrFile.h"
#include "datasets/session/Session.h"
#include "filters/core/maps/Image.h"

namespace umbra {

class ChannelFile {
 public:
  explicit ChannelFile(const Session& session);

  // Texels keep the depth file's own count.
  void setOrigin(const ExrOrigin& origin) { origin_ = origin; }
  void addDepth(const DepthMap& map);  // "Z"
  // Interleaved in the order of technique.channels(): "vsm.M1", "vsm.M2". Also its parameters.
  void addTechnique(const Technique& technique, const Image<double>& channels);
  void addTechnique(const Technique& technique, const Image<float>& channels);
  void addParameters(const Technique& technique);
  void add(const std::string& name, Image<float> channel);
  void note(const std::string& name, const std::string& text);  // a further attribute

  // All that was added, as one of several parts of a file.
  ExrPart part(const std::string& name) const { return {name, channels_, attributes_}; }

  // Throws BadOutput; nothing half-written.
  void write(const std::filesystem::path& file) const;

 private:
  std::map<std::string, Image<float>> channels_;
  std::map<std::string, std::string> attributes_;
  ExrOrigin origin_;
};

// One channel of an interleaved image.
template <class T>
Image<float> channelOf(const Image<T>& image, int channel) {
  Image<float> single(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) single(x, y) = float(image(x, y, channel));
  return single;
}

}  // namespace umbra
