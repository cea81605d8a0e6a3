#include "ui/probe/ExplainPane.h"

#include <QComboBox>
#include <QMetaObject>
#include <QVBoxLayout>
#include <exception>

#include "datasets/scenes/SceneCatalogue.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/Controls.h"
#include "ui/widgets/plots/PlotPane.h"

namespace umbra {
namespace {

constexpr int pointerStillFor = 200;  // ms

}  // namespace

ExplainPane::ExplainPane(SessionController& controller, Prober& prober, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      prober_(prober),
      chooser_(new QComboBox),
      plot_(new PlotPane) {
  for (const ExplainingPlot& each : explainingPlots())
    chooser_->addItem(style::text(each.title), style::text(each.name));
  chooser_->setToolTip(tr("Which plot of the probe to show"));
  ignoreWheelWithoutFocus(chooser_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(chooser_);
  layout->addWidget(plot_, 1);
  still_.setSingleShot(true);
  still_.setInterval(pointerStillFor);
  connect(&prober_, &Prober::reported, this, &ExplainPane::refresh);
  connect(&still_, &QTimer::timeout, this, &ExplainPane::computeBeside);
  connect(chooser_, QOverload<int>::of(&QComboBox::activated), this, &ExplainPane::refresh);
  show(std::nullopt);
}

ExplainPane::~ExplainPane() = default;

void ExplainPane::setWatched(bool watched) {
  watched_ = watched;
  if (watched) refresh();
}

const ExplainingPlot& ExplainPane::chosen() const {
  return explainingPlots()[std::size_t(std::max(chooser_->currentIndex(), 0))];
}

ExplainingInput ExplainPane::inputFor(const ProbeRequest& request, const Probe& probe) const {
  const Session& session = controller_.session();
  ExplainingInput input{request, probe, session.technique, {}};
  if (session.source.kind == SourceKind::Catalogue)
    input.planes = planeDepthsOf(session.source.name, session.source.parameters);
  return input;
}

void ExplainPane::refresh() {
  ++asked_;  // what is being computed is of an older probe
  thread_.request_stop();
  still_.stop();
  const auto& report = prober_.report();
  if (!watched_) return;
  if (!report || !report->request) {
    show(std::nullopt);
  } else if (!chosen().slow) {
    show(explainingPlot(chosen().name, inputFor(*report->request, report->probe)));
  } else {
    still_.start();
  }
}

void ExplainPane::computeBeside() {
  const auto& report = prober_.report();
  if (!report) return;  // its end is announced, and empties the plot
  const auto request = report->request;
  const Probe probe = report->probe;
  const ExplainingInput described = inputFor(*request, probe);
  thread_ = std::jthread([this, request, probe, described, number = asked_,
                          name = chosen().name](const std::stop_token& stop) {
    struct Stopped {};
    std::optional<Plot> plot;
    try {
      plot = explainingPlot(name, {*request, probe, described.selected, described.planes}, [&] {
        if (stop.stop_requested()) throw Stopped{};
      });
    } catch (const Stopped&) {
      return;
    } catch (const std::exception&) {
      // Nothing to show: the probe's own panes say why.
    }
    QMetaObject::invokeMethod(
        this, [this, number, plot] { finished(number, plot); }, Qt::QueuedConnection);
  });
}

void ExplainPane::finished(int number, const std::optional<Plot>& plot) {
  if (number == asked_) show(plot);
}

void ExplainPane::show(const std::optional<Plot>& plot) {
  if (plot) {
    plot_->setPlot(*plot);
    return;
  }
  plot_->setTitle(style::text(chosen().title));
  if (!prober_.veil().isEmpty())
    plot_->clear(prober_.veil());
  else if (!prober_.report())
    plot_->clear(tr("Point at a shadow: the plot of its region appears here."));
  else
    plot_->clear(tr("This plot has nothing to show of this region."));
}

}  // namespace umbra
