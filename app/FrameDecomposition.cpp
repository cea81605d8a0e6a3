#include "app/FrameDecomposition.h"

#include <vector>

#include "analysis/ReceiverPixels.h"
#include "app/Cancellation.h"
#include "app/EveryCore.h"
#include "app/FrameReads.h"

namespace umbra {
namespace {

// The reads of all pixels that are worth it. OpenGL answers to one thread only, so they are
// gathered first.
struct Reads {
  std::vector<ProbeRequest> requests;
  Image<int> places;  // in `requests`, by pixel
};

Reads gather(HeadlessFrame& frame, const FrameSettings& settings, const Image<float>& surfaces,
             const Image<float>& reference,
             const std::vector<std::shared_ptr<const Technique>>& techniques,
             const DecompositionSettings& how) {
  Reads reads{{}, Image<int>(surfaces.width(), surfaces.height())};
  for (int y = 0; y < surfaces.height(); ++y) {
    throwIfCancelled();
    for (int x = 0; x < surfaces.width(); ++x) {
      if (!receivesShadow(surfaces.pixel(x, y))) continue;
      if (!worthDecomposing(surfaces(x, y, 3), reference(x, y), techniques.size() > 1, how))
        continue;
      reads.places(x, y) = int(reads.requests.size());
      reads.requests.push_back(
          requestAt(frame, settings, surfaceAt(frame, settings, surfaces, x, y)));
      reads.requests.back().format = StorageFormat::Double;
      reads.requests.back().techniques = techniques;
    }
  }
  return reads;
}

}  // namespace

ErrorDecomposition decomposeFrame(HeadlessFrame& frame, const FrameSettings& settings,
                                  const Technique& technique, const DecompositionSettings& how) {
  const Image<float> surfaces = frame.surfaces(), reference = frame.reference();
  const std::shared_ptr<Technique> adapted = technique.clone();
  adapted->adapt(frame.depthMap(0));
  const auto techniques = decompositionTechniques(adapted);
  const Reads reads = gather(frame, settings, surfaces, reference, techniques, how);
  ErrorDecomposition result = emptyDecomposition(surfaces.width(), surfaces.height());
  onEveryCore(surfaces.height(), [&](int y) {
    decomposeRow(
        surfaces, reference, y, techniques.size() > 1,
        [&](int x, int row) { return takeProbe(reads.requests[reads.places(x, row)]); }, how,
        result);
  });
  return result;
}

}  // namespace umbra
