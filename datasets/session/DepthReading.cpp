#include "datasets/session/DepthReading.h"

namespace umbra {

FrameSettings readSettingsOf(const Session& session) {
  FrameSettings frame = session.frame;
  if (session.source.kind == SourceKind::DepthFile) frame.read.filter = ReadFilter::Point;
  return frame;
}

void chooseFormatFor(Session& session) {
  StorageFormat& format = session.frame.map.format;
  const bool onFile = session.source.kind == SourceKind::DepthFile;
  if (onFile && format == StorageFormat::Float) format = StorageFormat::Double;
  if (!onFile && format == StorageFormat::Double) format = StorageFormat::Float;
}

}  // namespace umbra
