#include "app/frames/FrameDecomposition.h"

#include "analysis/errors/FrameDecomposition.h"
#include "app/output/Cancellation.h"

namespace umbra {

DecomposedFrame decomposeFrame(HeadlessFrame& frame, const RayTracedReference* rays) {
  const auto snapshot = frame.snapshot();
  const Image<float> reference = frame.reference();
  DecomposedFrame result{
      decomposeFrame(*snapshot, reference, snapshot->technique, {}, rays ? rays->stride : 1,
                     [](double) { throwIfCancelled(); }),
      {},
      {}};
  if (!rays) return result;
  result.map = mapErrorsOf(result.parts, reference, rays->visibility);
  result.meanOfMap = meanOf(*result.map, result.parts);
  return result;
}

ChannelFile decompositionFile(const Session& session, const Technique& technique,
                              const DecomposedFrame& decomposed) {
  const ErrorDecomposition& decomposition = decomposed.parts;
  ChannelFile file(session);
  file.addParameters(technique);
  for (int i = 0; i < errorPartCount; ++i)
    file.add(std::string(nameOf(ErrorPart(i))), channelOf(decomposition.parts, i));
  if (decomposed.map) file.add("map", channelOf(*decomposed.map, 0));
  file.add("receives", channelOf(decomposition.receives, 0));
  return file;
}

}  // namespace umbra
