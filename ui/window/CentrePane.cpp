#include "ui/window/CentrePane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "ui/panes/ComparisonPanes.h"
#include "ui/panes/PaneHeader.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Card.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/base/TechniqueTitle.h"
#include "ui/widgets/maps/ColourBar.h"
#include "ui/widgets/maps/ShadowMapView.h"
#include "ui/window/MessageBanner.h"

namespace umbra {
namespace {

constexpr double receiverSteps = 10000.0;
// What is read faster needs no message, which would push the picture down for a moment.
constexpr int noticedAfter = 300;  // milliseconds

QString openingText() {
  return CentrePane::tr("Opening …");
}

}  // namespace

CentrePane::CentrePane(SessionController& controller, SceneView& view, Prober& prober,
                       QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      view_(view),
      prober_(prober),
      banner_(new MessageBanner),
      pages_(new QStackedWidget),
      comparison_(new ComparisonPanes(controller, view, prober)),
      legend_(new ColourBar),
      depth_(new ShadowMapView),
      receiver_(new QSlider(Qt::Horizontal)),
      receiverText_(new QLabel) {
  setObjectName("centre");
  legend_->setObjectName("legend");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(5, 9, 5, 5);  // the grip of the docks beside it
  layout->setSpacing(6);
  layout->addWidget(banner_);

  auto* picture = new Card;
  picture->layout()->setContentsMargins(4, 4, 4, 4);
  picture->body()->addWidget(comparison_, 1);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(8, 0, 8, 2);
  bar->addWidget(legend_, 1);
  picture->body()->addLayout(bar);
  pages_->addWidget(picture);
  pages_->addWidget(makeDepthPage());
  layout->addWidget(pages_, 1);

  connect(&controller_, &SessionController::changed, this,
          [this](const Document& before, const Document& after) {
            if (!(before.content == after.content)) showNotices();
            refresh();
            if (!(before.workspace.comparison == after.workspace.comparison)) showReport();
          });
  opening_.setSingleShot(true);
  opening_.setInterval(noticedAfter);
  connect(&opening_, &QTimer::timeout, this, [this] { banner_->showProgress(openingText()); });
  connect(&controller_, &SessionController::loadingChanged, this, [this](bool loading) {
    if (loading) return opening_.start();
    opening_.stop();
    if (banner_->isProgress()) banner_->dismiss();
  });
  connect(&controller_, &SessionController::loadingProgressed, this, [this](double part) {
    if (!opening_.isActive() && banner_->isProgress())
      banner_->showProgress(tr("%1 %2 %").arg(openingText()).arg(int(100.0 * part)));
  });
  connect(banner_, &MessageBanner::stopAsked, &controller_, &SessionController::stopOpening);
  connect(comparison_, &ComparisonPanes::figuresChanged, this, &CentrePane::showReport);
  refresh();
  showNotices();
}

QWidget* CentrePane::makeDepthPage() {
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(depth_, 1);
  auto* card = new Card;
  auto* row = new QHBoxLayout;
  receiver_->setRange(0, int(receiverSteps));
  receiverText_->setFont(style::figures(receiverText_->font()));
  receiverText_->setMinimumWidth(60);
  receiverText_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(new QLabel(tr("Receiver depth z<sub>r</sub>")));
  row->addWidget(receiver_, 1);
  row->addWidget(receiverText_);
  card->body()->addLayout(row);
  layout->addWidget(card);

  connect(receiver_, &QSlider::valueChanged, this, [this](int steps) {
    controller_.edit(
        tr("Change receiver depth"), [&](Session& s) { s.receiver = steps / receiverSteps; },
        "receiver");
  });
  connect(receiver_, &QSlider::sliderReleased, this, [this] { controller_.endMerge(); });
  connect(depth_, &ShadowMapView::texelHovered, this, [this](int x, int y) {
    prober_.hover({x, y});
  });
  connect(depth_, &ShadowMapView::texelClicked, this, [this](int x, int y) {
    prober_.pin({x, y});
  });
  return page;
}

namespace {

// Says why the picture of a view is the shaded one, or of one colour; empty where it is not.
QString whyViewShowsNothing(const FrameSettings& frame, const Technique& technique) {
  if (frame.view == ViewMode::Layers && !technique.info().layered())
    return CentrePane::tr("%1 has no layers to show; layered variance (LVSM) has.")
        .arg(shortTitle(technique));
  if (frame.view == ViewMode::Cascades && frame.map.cascades.count == 1)
    return CentrePane::tr("There is one cascade: choose more under Filter and map, Cascades.");
  return {};
}

}  // namespace

void CentrePane::refresh() {
  const Document& document = controller_.document();
  const DepthMap* depth = document.content.depth.get();
  pages_->setCurrentIndex(depth ? 1 : 0);
  legend_->setView(document.session.frame);
  if (const QString why = whyViewShowsNothing(document.session.frame, controller_.technique());
      !why.isEmpty())
    legend_->setNotice(why);
  if (!depth) return;
  if (depth != shownDepth_) {
    depth_->setOrigin(originOf(document.content));
    depth_->setChannels({tr("depth")}, tr("depth"));
    depth_->setTitle(
        tr("Depth map · %1").arg(QString::fromStdString(titleOf(document.session.source))));
    depth_->setImage(*depth);
    // The same file, read otherwise, stays where it was zoomed to.
    const std::string& file = document.session.source.name;
    if (std::exchange(shownFile_, file) != file) depth_->fit();
  }
  shownDepth_ = depth;
  const QSignalBlocker quiet(receiver_);
  const double receiver = document.session.receiver.value_or(0.5);
  receiver_->setValue(int(std::lround(receiver * receiverSteps)));
  receiverText_->setText(QString::number(receiver, 'f', 4));
}

// Says what the opened file has that the window does not show.
void CentrePane::showNotices() {
  QStringList lines;
  for (const std::string& notice : controller_.document().content.notices)
    lines << style::text(notice);
  if (lines.isEmpty())
    banner_->dismiss();
  else
    banner_->showNotice(lines.join("\n"));
}

// The pane whose figures stand beside the probe: in a wipe that of the side on which the probe
// lies, else the active one.
std::size_t CentrePane::paneAtProbe() const {
  const Comparison& comparison = controller_.workspace().comparison;
  const auto& report = prober_.behindVeil();
  if (comparison.mode != ComparisonMode::Wipe || !report || !report->point)
    return comparison_->active();
  const auto pixel = view_.pixelOf(*report->point);
  return pixel && pixel->x + 0.5 > comparison.wipe * view_.pixels().width() ? 1 : 0;
}

void CentrePane::showReport() {
  const auto& report = prober_.behindVeil();
  if (controller_.document().content.depth) {
    if (report)
      depth_->setRegion(report->probe.region);
    else
      depth_->clearRegion();
    return;
  }
  view_.setHint(
      report ? QString()
             : tr("Point at a shadow to take it apart. Click to hold the point, K saves it."));
  const auto& figures = comparison_->figures(paneAtProbe());
  // In a grid the labels of the panes say the figures already.
  const bool said =
      controller_.workspace().comparison.mode == ComparisonMode::Grid && prober_.veil().isEmpty();
  if (report && !prober_.veil().isEmpty())
    return view_.setReport(report, tr("Predict first"), tr("then see what comes out here"), false);
  if (!report || !figures || said) return view_.setReport(report, {}, {}, false);
  const TechniqueResult& result = figures->result;
  std::optional<ProbeReport> shown = report;
  if (!figures->footprint.empty()) shown->footprint = figures->footprint;
  const QString kernel = QString::fromStdString(describe(figures->kernel));
  const bool wrong = std::string_view(verdictOf(result.error)) != verdictOf(0.0);
  view_.setReport(
      shown,
      tr("%1, %2 · lit %3")
          .arg(shortTitle(*result.technique), kernel, QString::number(result.visibility, 'f', 3)),
      tr("reference %1 · %2")
          .arg(QString::number(figures->reference, 'f', 3),
               report->facesLight ? tr(verdictOf(result.error)) : tr("turned away from the light")),
      wrong);
}

}  // namespace umbra
