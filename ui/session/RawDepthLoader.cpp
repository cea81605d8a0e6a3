#include "ui/session/RawDepthLoader.h"

#include <QMetaObject>
#include <exception>

namespace umbra {
namespace {

std::optional<RawDepths> rawOrChannels(const std::filesystem::path& file,
                                       const std::string& channel) {
  try {
    return readRawDepths(file, channel);
  } catch (const std::exception&) {
    // Why it cannot be read is told by who reads the depths themselves.
  }
  try {
    RawDepths named;
    named.channels = rasterChannels(file);
    if (named.channels.size() > 1) return named;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

RawDepthLoader::RawDepthLoader(QObject* parent) : QObject(parent) {}

// Events that a thread has posted to this object die with it.
RawDepthLoader::~RawDepthLoader() = default;

void RawDepthLoader::load(const std::filesystem::path& file, const std::string& channel) {
  const int number = ++asked_;
  threads_.emplace(number, [this, number, file, channel] {
    const std::optional<RawDepths> raw = rawOrChannels(file, channel);
    QMetaObject::invokeMethod(
        this,
        [=, this] {
          threads_.erase(number);  // it has only to return
          if (number == asked_) emit loaded(raw);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace umbra
