#include "app/FrameDecomposition.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "analysis/ReceiverPixels.h"
#include "app/Cancellation.h"
#include "app/FrameReads.h"

namespace umbra {
namespace {

// A point or bilinear read of the only map is known from the picture of surfaces; every other one
// needs the pixel's footprint or cascade, which is read back for it alone.
SurfacePoint surfaceAt(HeadlessFrame& frame, const FrameSettings& settings,
                       const Image<float>& surfaces, int x, int y) {
  const ReadFilter filter = settings.read.filter;
  const bool plain = filter == ReadFilter::Point || filter == ReadFilter::Bilinear;
  if (!plain || frame.cascades().size() > 1) return frame.surfaceAt(x, y).value();
  SurfacePoint point;
  point.u = surfaces(x, y, 0);
  point.v = surfaces(x, y, 1);
  point.receiver = surfaces(x, y, 2);
  point.visibility = surfaces(x, y, 3);
  return point;
}

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

// Calls `work` for 0 … count − 1 on every core, in any order; the first exception ends it. Only the
// calling thread looks for an interruption.
void onEveryCore(int count, const std::function<void(int)>& work) {
  std::atomic<int> next = 0;
  std::exception_ptr problem;
  std::mutex mutex;
  const auto run = [&](bool calling) {
    try {
      for (int i = next++; i < count; i = next++) {
        if (calling) throwIfCancelled();
        work(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!problem) problem = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
      threads.emplace_back(run, false);
    run(true);
  }
  if (problem) std::rethrow_exception(problem);
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
