#include "app/bench/FrameRounds.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "analysis/cost/TechniqueCost.h"

namespace umbra {
namespace {

constexpr Motion motions[] = {Motion::Light, Motion::Camera};
constexpr int leastForASpread = 3;
// A software renderer compiles shaders to machine code, of which on llvmpipe about one in twenty
// comes to lie so badly that it takes half as long again in every frame. New contexts compile
// anew, so that medians over several are not about one of those.
constexpr int roundsOfAContext = 2;
constexpr Baseline baselines[] = {Baseline::NoShadow, Baseline::VtkShadowMapPass};

class FrameRounds {
 public:
  FrameRounds(Display& display, const FrameRoundsRequest& request)
      : display_(display), request_(request) {
    result_.passes.resize(request.cases.size());
    renewContexts();
    result_.renderer = frames_->renderer();
    result_.clock = frames_->clock();
    for (const Drawing& drawing : request.cases) {
      const FrameSettings frame = settingsOf(drawing);
      result_.bytes.push_back({bytesStoredPerTexel(*drawing.technique, frame.map.format),
                               frames_->bytesUsed(frame, *drawing.technique)});
    }
  }

  FrameRoundsResult run() {
    spdlog::info(
        "{} on {}: {} and two baselines, first once without measuring",
        result_.clock == CostClock::Gpu ? "GPU time" : "processor time", result_.renderer,
        request_.cases.size() == 1 ? "one case" : std::to_string(request_.cases.size()) + " cases");
    const RoundLimits& limits = request_.limits;
    while (result_.rounds < limits.most && !result_.settled) {
      if (result_.rounds % roundsOfAContext == 0) {
        if (result_.rounds > 0) renewContexts();
        drawRound(false);
      }
      drawRound(true);
      ++result_.rounds;
      const double spread = largestError();
      result_.settled = result_.rounds >= limits.least && spread <= limits.part;
      if (result_.rounds < leastForASpread)
        spdlog::info("round {}", result_.rounds);
      else
        spdlog::info("round {}: the medians of whole frames are known to {:.1f} %", result_.rounds,
                     100.0 * spread);
    }
    return std::move(result_);
  }

 private:
  // The picture is shaded, whatever view the session is saved with.
  static FrameSettings settingsOf(const Drawing& drawing) {
    FrameSettings frame = drawing.session.frame;
    frame.view = ViewMode::Shaded;
    return frame;
  }

  void renewContexts() {
    frames_.reset();  // the memory of the last ones is free before the new ones need theirs
    frames_ = display_.makeBench(request_.view, request_.mapSize, request_.clock);
  }

  void pause() const {
    if (request_.between) request_.between();
  }

  void drawRound(bool counts) {
    for (Baseline baseline : baselines) {
      // Its textures have left the caches since its last frame, as those of a case have.
      pause();
      frames_->drawBaseline(baseline, Motion::Light);
      for (Motion motion : motions) {
        pause();
        const double milliseconds = frames_->drawBaseline(baseline, motion);
        if (counts) add(nameOf(baseline), nameOf(motion), milliseconds);
      }
    }
    for (std::size_t i = 0; i < request_.cases.size(); ++i) drawCase(i, counts);
  }

  void drawCase(std::size_t i, bool counts) {
    const Drawing& drawing = request_.cases[i];
    pause();
    frames_->show(settingsOf(drawing), *drawing.technique);
    drawMotion(drawing, Motion::Light, counts);
    pause();
    for (const PassTime& time : frames_->drawPasses()) {
      std::vector<std::string>& passes = result_.passes[i];
      if (std::find(passes.begin(), passes.end(), time.pass) == passes.end())
        passes.push_back(time.pass);
      if (counts) add(drawing.name, time.pass, time.milliseconds);
    }
    drawMotion(drawing, Motion::Camera, counts);
  }

  void drawMotion(const Drawing& drawing, Motion motion, bool counts) {
    pause();
    const double milliseconds = frames_->draw(motion);
    if (counts) add(drawing.name, nameOf(motion), milliseconds);
  }

  void add(std::string_view name, std::string_view part, double milliseconds) {
    result_.samples.add(std::string(name) + " " + std::string(part), milliseconds);
  }

  // How far any median of whole frames may be off, relative to it.
  double largestError() const {
    double largest = 0.0;
    const auto look = [&](std::string_view name) {
      for (Motion motion : motions) {
        const Spread spread =
            result_.samples.spread(std::string(name) + " " + std::string(nameOf(motion)));
        if (spread.median > 0.0) largest = std::max(largest, medianError(spread) / spread.median);
      }
    };
    for (Baseline baseline : baselines) look(nameOf(baseline));
    for (const Drawing& drawing : request_.cases) look(drawing.name);
    return largest;
  }

  Display& display_;
  const FrameRoundsRequest& request_;
  std::unique_ptr<BenchFrames> frames_;
  FrameRoundsResult result_;
};

}  // namespace

std::string_view nameOf(Motion motion) {
  return motion == Motion::Camera ? "camera" : "light";
}

std::string_view nameOf(Baseline baseline) {
  return baseline == Baseline::NoShadow ? "noShadow" : "vtkShadowMapPass";
}

std::vector<CostRatio> ratiosOfFrames(const CostSamples& samples, std::string_view name) {
  const std::string camera = std::string(name) + " camera", light = std::string(name) + " light";
  return {ratioOf(samples, {camera, "noShadow camera"}, false),
          ratioOf(samples, {light, "vtkShadowMapPass light"}, false)};
}

FrameRoundsResult measureFrames(Display& display, const FrameRoundsRequest& request) {
  return FrameRounds(display, request).run();
}

}  // namespace umbra
