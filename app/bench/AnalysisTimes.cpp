#include "app/bench/AnalysisTimes.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>

#include "analysis/errors/CompareMap.h"
#include "analysis/probe/Probe.h"
#include "app/bench/GoalTable.h"
#include "app/frames/TechniqueSet.h"
#include "filters/core/support/ProcessorTime.h"

namespace umbra {
namespace {

constexpr int comparisons = 3, probes = 15, curveSamples = 512;

DepthMap mapOf(Display& display, Session session, const TechniqueCatalogue& catalogue,
               std::shared_ptr<const Scene> scene, int size) {
  session.frame.map.size = size;
  session.width = session.height = Session::smallestSide;  // the picture does not matter
  const std::unique_ptr<HeadlessFrame> frame = display.makeFrame(std::move(scene), session);
  frame->render(*catalogue.make("hard"), ViewMode::Shaded);
  return frame->depthMap();
}

// A receiver that some of the map's surfaces shadow and others do not: their mean depth.
double receiverIn(const DepthMap& map) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const double depth : map.values()) {
    if (depth >= 1.0) continue;
    sum += depth;
    ++count;
  }
  return count > 0 ? sum / double(count) : 0.5;
}

// All that go with a depth map in double, with the session's parameters.
std::vector<std::shared_ptr<const Technique>> everyTechniqueOn(
    const DepthMap& map, Session session, const TechniqueCatalogue& catalogue) {
  session.frame.map.format = StorageFormat::Double;
  std::vector<std::shared_ptr<const Technique>> techniques;
  for (const auto& technique : makeTechniques(session, catalogue, everyTechnique(catalogue))) {
    technique->adapt(map);
    techniques.push_back(technique);
  }
  return techniques;
}

double processorMillisecondsOf(const std::function<void()>& work) {
  const double before = processorMilliseconds();
  work();
  return processorMilliseconds() - before;
}

void takeWithCurves(const ProbeRequest& request, int samples) {
  const Probe probe = takeProbe(request);
  if (samples > 0) curvesOf(probe, samples);
}

// The probe of a wide region, less one of a single texel without techniques.
double probeMilliseconds(const DepthMap& map,
                         std::span<const std::shared_ptr<const Technique>> techniques) {
  const ReadPoint read = ReadPoint::atTexel(map, map.width() / 2, map.height() / 2);
  const double receiver = receiverIn(map);
  const Kernel wide{KernelShape::Box, 32}, none{KernelShape::None, 0};
  const ProbeRequest full{.map = map,
                          .read = read,
                          .kernel = wide,
                          .receiver = receiver,
                          .techniques = {techniques.begin(), techniques.end()}};
  const ProbeRequest empty{.map = map, .read = read, .kernel = none, .receiver = receiver};
  const double whole = processorMillisecondsOf([&] { takeWithCurves(full, curveSamples); });
  return whole - processorMillisecondsOf([&] { takeWithCurves(empty, 0); });
}

}  // namespace

void measureAnalysis(Display& display, const Session& session, const TechniqueCatalogue& catalogue,
                     std::shared_ptr<const Scene> scene, std::span<const CostGoal> goals,
                     CostSamples& samples, const std::function<void()>& between) {
  const auto compare = [&](int size) {
    const std::string name = "compare-" + std::to_string(size);
    const std::string seconds = name + " seconds", work = name + " processor";
    if (!asksFor(goals, seconds) && !asksFor(goals, work)) return;
    const DepthMap map = mapOf(display, session, catalogue, scene, size);
    for (int i = 0; i < comparisons; ++i) {
      spdlog::info("{}: {} of {}", name, i + 1, comparisons);
      const auto before = std::chrono::steady_clock::now();
      const double milliseconds = processorMillisecondsOf([&] {
        figuresOnMap(map, everyTechniqueOn(map, session, catalogue), session.frame.kernel,
                     StorageFormat::Double, receiverIn(map), between);
      });
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
      samples.add(seconds, passed.count());
      samples.add(work, 1e-3 * milliseconds);
    }
  };
  compare(2048);
  compare(4096);
  if (!asksFor(goals, probe65)) return;
  spdlog::info("probe-65: {} times", probes);
  const DepthMap map = mapOf(display, session, catalogue, scene, 1024);
  const auto techniques = everyTechniqueOn(map, session, catalogue);
  for (int i = 0; i < probes; ++i) {
    between();
    samples.add(std::string(probe65), probeMilliseconds(map, techniques));
  }
}

}  // namespace umbra
