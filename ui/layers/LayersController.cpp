#include "ui/layers/LayersController.h"

#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <utility>

#include "ui/picture/SceneView.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int lightStillFor = 150;     // ms: a light that is being dragged makes a map a frame
constexpr int playInterval = 450;      // ms for an iteration: it can be followed by eye
constexpr double smallestDrag = 1e-3;  // depth between two splits that were dragged
constexpr int histogramBins = 60;

LayersController::Occluders occludersOf(const DepthMap& map) {
  LayersController::Occluders occluders;
  occluders.samples = std::make_shared<const SortedSamples>(secondOccluderSamples(map));
  std::vector<double> values, weights;
  for (const WeightedSample& sample : occluders.samples->samples()) {
    values.push_back(sample.value);
    weights.push_back(sample.weight);
  }
  occluders.histogram = histogramOf(values, weights, histogramBins);
  return occluders;
}

std::vector<double> uniformSplits(std::size_t count) {
  std::vector<double> splits;
  for (std::size_t k = 1; k <= count; ++k) splits.push_back(double(k) / double(count + 1));
  return splits;
}

LayerParameters layerParametersOf(const Technique& technique) {
  const std::vector<ParameterView> parameters = technique.parameters();
  const auto value = [&](std::string_view name) {
    return parameterNamed(parameters, name, technique.info().id).get();
  };
  LayerParameters layers;
  layers.layers = std::get<int>(value("layers"));
  const auto placement = std::get<std::string>(value("placement"));
  layers.placement =
      LayerPlacement(std::find(layerPlacementNames.begin(), layerPlacementNames.end(), placement) -
                     layerPlacementNames.begin());
  layers.splits = std::get<std::vector<double>>(value("splits"));
  layers.overlap = std::get<double>(value("overlap"));
  return layers;
}

}  // namespace

LayersController::LayersController(SessionController& controller, SceneView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
  still_.setSingleShot(true);
  still_.setInterval(lightStillFor);
  play_.setInterval(playInterval);
  connect(&still_, &QTimer::timeout, this, &LayersController::lookForOccluders);
  connect(&play_, &QTimer::timeout, this, [this] {
    if (!goOn("lloyd")) setPlaying(false);
  });
  connect(&controller_, &SessionController::changed, this, &LayersController::sessionChanged);
  connect(&view_, &SceneView::frameDrawn, this, &LayersController::refresh);
}

LayersController::~LayersController() = default;

void LayersController::setWatched(bool watched) {
  watched_ = watched;
  if (!watched) return play_.stop();  // perhaps while the window ends, and the session before it
  shownSplits_.clear();
  refresh();
  emit changed();
}

bool LayersController::layered() const {
  return controller_.technique().info().layered();
}

std::optional<Layering> LayersController::layering() const {
  if (!layered()) return std::nullopt;
  const LayerParameters parameters = layerParametersOf(controller_.technique());
  std::vector<double> adapted;
  if (parameters.placement == LayerPlacement::Lloyd) {
    ShadowRenderer* frame = view_.lastFrame();
    if (controller_.document().content.depth)
      adapted = relaxed_;
    else if (frame)
      adapted = frame->adaptedSplits();
  }
  return layeringOf(parameters, keptApart(adapted));
}

std::vector<double> LayersController::splits() const {
  const std::optional<Layering> layers = layering();
  if (!layers) return {};
  return {layers->bounds.begin() + 1, layers->bounds.begin() + layers->count};
}

void LayersController::sessionChanged(const Document& before, const Document& after) {
  if (!(before.content == after.content)) {
    occluders_.reset();
    known_.reset();
  }
  if (!placing_) setPlaying(false);
  if (!watched_) return;
  followSplits();
  if (after.content.depth) refresh();  // a scene's map follows with its frame
  emit changed();
}

// Names the map: equal maps have equal occluders. Null where there is no map yet.
std::shared_ptr<const void> LayersController::presentMap() const {
  if (const auto& depth = controller_.document().content.depth) return depth;
  return view_.lastFrame() ? view_.baked().firstMap : nullptr;
}

void LayersController::refresh() {
  if (!watched_ || !layered()) return;
  if (presentMap() != known_) still_.start();
  if (splits() == shownSplits_) return;
  followSplits();
  emit changed();
}

void LayersController::lookForOccluders() {
  const Content& content = controller_.document().content;
  if (searching_ || !watched_ || (content.scene && !view_.upToDate())) return;
  try {
    std::shared_ptr<const DepthMap> map = content.depth;
    if (!map) {
      view_.makeCurrent();
      map = std::make_shared<const DepthMap>(view_.lastFrame()->depthMap());
    }
    asked_ = presentMap();
    searching_ = true;
    thread_ = std::jthread([this, map] {
      try {
        const auto occluders = std::make_shared<const Occluders>(occludersOf(*map));
        QMetaObject::invokeMethod(
            this, [this, occluders] { found(*occluders); }, Qt::QueuedConnection);
      } catch (const std::exception& problem) {  // memory, for the largest maps
        const QString message = QString::fromUtf8(problem.what());
        QMetaObject::invokeMethod(
            this,
            [this, message] {
              searching_ = false;
              emit failed(message);
            },
            Qt::QueuedConnection);
      }
    });
  } catch (const std::exception& problem) {
    searching_ = false;
    emit failed(QString::fromUtf8(problem.what()));
  }
}

void LayersController::found(const Occluders& occluders) {
  searching_ = false;
  if (presentMap() != asked_) return refresh();
  known_ = asked_;
  occluders_ = occluders;
  run_.reset();
  relaxed_.clear();
  followSplits();
  emit changed();
}

// Finds the iteration that the session's splits are, since undo and redo go to and fro among the
// iterations. Splits that are none of them begin another run.
void LayersController::followSplits() {
  relaxDepthFile();
  shownSplits_ = splits();
  canStep_ = false;
  if (shownSplits_.empty() || !occluders_ || occluders_->samples->empty()) return run_.reset();
  const auto isShown = [this](const LloydFrame& frame) {
    return keptApart(frame.splits) == shownSplits_;
  };
  if (run_ && !isShown(run_->frames()[shown_])) {
    const auto& frames = run_->frames();
    const auto same = std::find_if(frames.begin(), frames.end(), isShown);
    if (same == frames.end())
      run_.reset();
    else
      shown_ = std::size_t(same - frames.begin());
  }
  if (!run_) {
    run_.emplace(occluders_->samples, shownSplits_);
    shown_ = reached_ = 0;
    uniformCost_ = occluders_->samples->cost(uniformSplits(shownSplits_.size()));
  }
  reached_ = std::max(reached_, shown_);
  canStep_ = shown_ + 1 < run_->frames().size() || run_->advance();
}

void LayersController::place(const QString& text, std::vector<double> splits,
                             const QString& mergeKey) {
  const std::string id = controller_.session().technique;
  placing_ = true;
  controller_.edit(
      text,
      [&](Session& session) {
        editParameters(session, controller_.catalogue(), id, [&](auto parameters) {
          parameterNamed(parameters, "splits", id).set(std::move(splits), id + ".splits");
        });
      },
      mergeKey);
  placing_ = false;
}

// A depth file is drawn in no frame that would find its splits.
void LayersController::relaxDepthFile() {
  if (!controller_.document().content.depth || !layered() || !occluders_) return relaxed_.clear();
  const int count = adaptedSplitCount(layerParametersOf(controller_.technique()));
  if (int(relaxed_.size()) == count) return;
  LloydRun run(occluders_->samples, uniformSplits(std::size_t(count)));
  while (run.advance()) continue;
  relaxed_ = run.frames().back().splits;
}

bool LayersController::goOn(const QString& mergeKey) {
  if (!run_ || !canStep_) return false;
  ++shown_;
  place(tr("Lloyd iteration"), keptApart(run_->frames()[shown_].splits), mergeKey);
  followSplits();
  emit changed();
  return canStep_;
}

void LayersController::dragSplit(int split, double depth) {
  std::vector<double> dragged = splits();
  if (split < 0 || split >= int(dragged.size())) return;
  const auto k = std::size_t(split);
  const double low = (k == 0 ? 0.0 : dragged[k - 1]) + smallestDrag;
  const double high = (k + 1 == dragged.size() ? 1.0 : dragged[k + 1]) - smallestDrag;
  if (low > high) return;
  dragged[k] = std::clamp(depth, low, high);
  place(tr("Drag split"), std::move(dragged), "drag split");
}

void LayersController::endDrag() {
  controller_.endMerge();
}

void LayersController::startUniform() {
  setPlaying(false);
  run_.reset();
  const std::string id = controller_.session().technique;
  controller_.edit(tr("Uniform splits"), [&](Session& session) {
    editParameters(session, controller_.catalogue(), id, [&](auto parameters) {
      parameterNamed(parameters, "placement", id).set(std::string("uniform"), id + ".placement");
    });
  });
  followSplits();
  emit changed();
}

void LayersController::step() {
  setPlaying(false);
  goOn({});
}

void LayersController::setPlaying(bool playing) {
  if (playing == play_.isActive()) return;
  controller_.endMerge();  // what was played is one step for undo
  if (playing && canStep_)
    play_.start();
  else
    play_.stop();
  emit changed();
}

void LayersController::toEnd() {
  setPlaying(false);
  if (!run_ || !canStep_) return;
  while (run_->advance()) continue;
  shown_ = run_->frames().size() - 1;
  place(tr("Lloyd relaxation"), keptApart(run_->frames().back().splits), {});
  followSplits();
  emit changed();
}

}  // namespace umbra
