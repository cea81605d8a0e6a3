#include "app/output/ChannelFile.h"

#include <nlohmann/json.hpp>

#include "datasets/session/SessionSettings.h"
#include "datasets/session/file/SessionInExr.h"

namespace umbra {
namespace {

template <class T>
void addAll(ChannelFile& file, const Technique& technique, const Image<T>& channels) {
  const std::vector<Channel> layout = technique.channels();
  for (std::size_t c = 0; c < layout.size(); ++c)
    file.add(std::string(technique.info().id) + "." + layout[c].name, channelOf(channels, int(c)));
  file.addParameters(technique);
}

}  // namespace

ChannelFile::ChannelFile(const Session& session)
    : attributes_(sessionAttributes(Workspace{session}, UMBRA_VERSION)) {
  Session copy = session;
  for (const Setting& setting : settingsOf(copy)) {
    const bool isLight = setting.info.name.starts_with("light.");
    // The light and camera of the scene are not known here.
    if (isOfScene(setting.info) &&
        !(isLight ? session.light.has_value() : session.camera.has_value()))
      continue;
    attributes_[std::string(setting.info.name)] = setting.text();
  }
}

void ChannelFile::addDepth(const DepthMap& map) {
  add("Z", channelOf(map, 0));
}

void ChannelFile::addTechnique(const Technique& technique, const Image<double>& channels) {
  addAll(*this, technique, channels);
}

void ChannelFile::addTechnique(const Technique& technique, const Image<float>& channels) {
  addAll(*this, technique, channels);
}

void ChannelFile::addParameters(const Technique& technique) {
  for (const ParameterView& parameter : technique.parameters())
    attributes_[std::string(technique.info().id) + "." + std::string(parameter.name)] =
        parameter.text();
}

void ChannelFile::add(const std::string& name, Image<float> channel) {
  channels_[name] = std::move(channel);
}

void ChannelFile::note(const std::string& name, const std::string& text) {
  attributes_[name] = text;
}

void ChannelFile::write(const std::filesystem::path& file) const {
  writeExr(file, channels_, attributes_, ExrPixel::Float, origin_);
}

}  // namespace umbra
