#include "app/frames/FrameDecomposition.h"

#include "analysis/errors/FrameDecomposition.h"
#include "app/output/Cancellation.h"

namespace umbra {

ErrorDecomposition decomposeFrame(HeadlessFrame& frame, const DecompositionSettings& how) {
  const auto snapshot = frame.snapshot();
  return decomposeFrame(*snapshot, frame.reference(), snapshot->technique, how, 1,
                        [](double) { throwIfCancelled(); });
}

ChannelFile decompositionFile(const Session& session, const Technique& technique,
                              const ErrorDecomposition& decomposition) {
  ChannelFile file(session);
  file.addParameters(technique);
  for (int i = 0; i < errorPartCount; ++i)
    file.add(std::string(nameOf(ErrorPart(i))), channelOf(decomposition.parts, i));
  file.add("receives", channelOf(decomposition.receives, 0));
  return file;
}

}  // namespace umbra
