#include "ui/probe/EvidencePanes.h"

#include <QEvent>
#include <algorithm>
#include <exception>

#include "analysis/plots/ProbePlots.h"
#include "analysis/probe/Explain.h"
#include "datasets/session/PaneChoice.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/probe/RayTracedTruth.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/widgets/tables/ProbeTable.h"
#include "ui/widgets/tables/RegionTable.h"
#include "ui/widgets/tables/TracePane.h"

namespace umbra {
namespace {

const char* const depthChannel = "depth";

}  // namespace

EvidencePanes::EvidencePanes(SessionController& controller, SceneView& view, Prober& prober,
                             QObject* parent)
    : QObject(parent),
      controller_(controller),
      view_(view),
      prober_(prober),
      rays_(new RayTracedTruth(controller, view, prober, this)),
      map_(new ShadowMapView),
      region_(new RegionTable),
      curves_(new PlotPane),
      cdf_(new PlotPane),
      histogram_(new PlotPane),
      lastPlot_(curves_),
      table_(new ProbeTable),
      trace_(new TracePane) {
  connect(&prober_, &Prober::reported, this, &EvidencePanes::refreshProbe);
  connect(rays_, &RayTracedTruth::traced, this, &EvidencePanes::refreshTable);
  connect(&view_, &SceneView::frameDrawn, this, &EvidencePanes::refreshMap);
  connect(map_, &ShadowMapView::channelChosen, this, &EvidencePanes::showChannel);
  connect(table_, &ProbeTable::techniqueChosen, this, [this](const QString& id) {
    controller_.editPanes(tr("Choose technique"), [&](Workspace& workspace) {
      chooseTechnique(workspace, id.toStdString());
    });
  });
  for (PlotPane* plot : plots()) follow(*plot);
  showHints();
  refreshMap();
}

void EvidencePanes::follow(PlotPane& plot) {
  plot.installEventFilter(this);
  plot.setMinimumSize(200, 150);
  connect(&plot, &PlotPane::message, this, &EvidencePanes::message);
  connect(&plot, &PlotPane::depthDragged, this, &EvidencePanes::dragReceiver);
  connect(&plot, &PlotPane::depthDragFinished, this, [this] { controller_.endMerge(); });
}

PlotPane& EvidencePanes::currentPlot() {
  return lastPlot_->isVisible() ? *lastPlot_ : *curves_;
}

bool EvidencePanes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter || event->type() == QEvent::Show)
    if (auto* plot = qobject_cast<PlotPane*>(watched)) lastPlot_ = plot;
  return QObject::eventFilter(watched, event);
}

void EvidencePanes::showHints() {
  const QString& veil = prober_.veil();
  const auto hint = [&](const QString& text) { return veil.isEmpty() ? text : veil; };
  curves_->clear(
      hint(tr("Point at a shadow: the visibility that every technique\n"
              "gives this pixel appears here, over all depths.")));
  cdf_->clear(hint(tr("Point at a shadow: how its region's depths add up appears here.")));
  histogram_->clear(hint(tr("Point at a shadow: the depths in its filter region appear here.")));
  curves_->setTitle(tr("Visibility of the region, every technique"));
  cdf_->setTitle(tr("Distribution of the region's depths"));
  histogram_->setTitle(tr("Depths in the region"));
  table_->clear(veil);
  trace_->clear(veil);
  region_->clear();
  map_->clearRegion();
  regionShown_ = false;
}

void EvidencePanes::refreshProbe() {
  const auto& report = prober_.report();
  if (!report) {
    showHints();
    // Where it is read may be seen: a veil hides what comes out.
    if (const auto& hidden = prober_.behindVeil(); hidden && hidden->pinned) {
      map_->setRegion(ownRegion(hidden->probe));
      map_->showRegion();
    }
    return;
  }
  const Probe& probe = report->probe;
  const std::string& technique = controller_.session().technique;
  curves_->setPlot(curvesPlot(probe, technique));
  cdf_->setPlot(cdfPlot(probe));
  histogram_->setPlot(histogramPlot(probe));
  refreshTable();
  if (const TechniqueResult* result = resultOf(probe, technique))
    trace_->setTrace(style::text(result->technique->info().title), explain(probe, *result));
  else
    trace_->clear(tr("The technique cannot be evaluated with these settings."));
  const Content& content = controller_.document().content;
  region_->setProbe(probe, originOf(content));
  if (report->cascade != shownCascade_) refreshMap();
  map_->setRegion(ownRegion(probe));
  // The first probe and every pinned one are brought into view, and again with another kernel;
  // hovering leaves the zoom alone.
  if (!(probe.region.kernel == shownKernel_)) regionShown_ = false;
  shownKernel_ = probe.region.kernel;
  if (!regionShown_ && (report->pinned || content.depth)) {
    map_->showRegion();
    regionShown_ = true;
  }
  if (!report->pinned) regionShown_ = false;
}

void EvidencePanes::refreshTable() {
  const auto& report = prober_.report();
  if (!report) return;
  std::optional<RayTracedRow> rays;
  if (rays_->applies()) rays.emplace(RayTracedRow{rays_->visibility()});
  const Session& session = controller_.session();
  std::optional<StorageFormat> stored;  // a depth map's probe has no textures
  if (session.source.kind != SourceKind::DepthFile) stored = session.frame.map.format;
  table_->setProbe(report->probe, style::text(session.technique), rays, stored);
}

QStringList EvidencePanes::channelNames() const {
  QStringList names{depthChannel};
  if (controller_.document().content.depth) return names;
  const std::vector<Channel> channels = controller_.technique().channels();
  if (controller_.technique().info().prefilterable)
    for (const Channel& channel : channels)
      names << tr("%1 filtered").arg(style::text(channel.name));
  for (const Channel& channel : channels) names << tr("%1 encoded").arg(style::text(channel.name));
  return names;
}

void EvidencePanes::refreshMap() {
  const QStringList names = channelNames();
  const QString current = map_->currentChannel();
  map_->setChannels(names, names.contains(current) ? current : QString(depthChannel));
  showChannel();
}

void EvidencePanes::showChannel() {
  try {
    const QString channel = map_->currentChannel();
    const Content& content = controller_.document().content;
    ShadowRenderer* frame = view_.lastFrame();
    map_->setOrigin(originOf(content));
    if (content.depth) {
      if (shownMap_ != content.depth) map_->setImage(*content.depth);
      shownMap_ = content.depth;
    } else if (!frame) {
      map_->clear();
      shownMap_.reset();
    } else {
      const int index = channelNames().indexOf(channel);
      const bool depth = index <= 0;
      const auto& report = prober_.report();
      const int last = int(frame->cascades().size()) - 1;
      shownCascade_ = report ? std::min(report->cascade, last) : 0;
      const QString key = QString("%1 %2").arg(channel).arg(shownCascade_);
      const Baked baked = frame->baked();
      const auto& map = depth ? baked.maps : baked.channels;
      if (map == shownMap_ && key == shownChannel_) return;
      const int count = int(controller_.technique().channels().size());
      const bool filtered = controller_.technique().info().prefilterable && index <= count;
      if (depth)
        map_->setImage(frame->depthMap(shownCascade_));
      else
        map_->setImage(
            frame->channels(filtered ? BakeStage::Prefiltered : BakeStage::Encoded, shownCascade_),
            (index - 1) % count);
      shownMap_ = map;
      shownChannel_ = key;
    }
  } catch (const std::exception& problem) {
    emit failed(QString::fromUtf8(problem.what()));
  }
}

void EvidencePanes::dragReceiver(double depth) {
  const auto& report = prober_.report();
  if (!report) return;
  controller_.edit(
      tr("Drag receiver depth"),
      [&](Session& session) {
        session.receiver = depth;
        // What is being studied no longer follows the pointer.
        if (!session.probe) prober_.place(session, report->pixel);
      },
      "receiver");
}

}  // namespace umbra
