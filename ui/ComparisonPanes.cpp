#include "ui/ComparisonPanes.h"

#include <QGridLayout>
#include <algorithm>

#include "ui/PaneHeader.h"
#include "ui/Prober.h"
#include "ui/SceneView.h"
#include "ui/SessionController.h"
#include "ui/TechniquePicture.h"
#include "ui/WipeHandle.h"
#include "ui/widgets/Style.h"

namespace umbra {
namespace {

constexpr QSize viewAlone{240, 180}, viewInGrid{140, 90};  // smallest, logical pixels
constexpr int paneGap = 4;

}  // namespace

ComparisonPanes::ComparisonPanes(SessionController& controller, SceneView& view, Prober& prober,
                                 QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      view_(view),
      prober_(prober),
      grid_(new QGridLayout(this)),
      wipe_(nullptr) {
  setObjectName("comparison");
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(0);
  view_.setParent(this);
  wipe_ = new WipeHandle(&view_);
  makePanes();
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &ComparisonPanes::drawNext);
  connect(wipe_, &WipeHandle::moved, this, [this](double at) {
    controller_.edit(
        tr("Move wipe"), [&](Session& session) { session.comparison.wipe = at; }, "wipe");
  });
  connect(wipe_, &WipeHandle::released, this, [this] { controller_.endMerge(); });
  connect(&controller_, &SessionController::changed, this, &ComparisonPanes::refresh);
  connect(&view_, &SceneView::frameDrawn, this, &ComparisonPanes::schedule);
  connect(&prober_, &Prober::reported, this, [this] {
    showErrors();
    showPictures();
  });
  arrange();
}

ComparisonPanes::~ComparisonPanes() = default;

void ComparisonPanes::makePanes() {
  for (std::size_t i = 0; i < Comparison::most; ++i) {
    auto* header = new PaneHeader(controller_.catalogue().all(), this);
    auto* picture = new TechniquePicture(this);
    picture->setMinimumSize(viewInGrid);
    connect(header, &PaneHeader::techniqueChosen, this, [this, i](const QString& id) {
      controller_.edit(tr("Choose technique"), [&](Session& session) {
        if (i == 0 && mode() == ComparisonMode::Wipe)
          chooseTechnique(session, id.toStdString());
        else
          choosePane(session, shown_[i], id.toStdString());
      });
    });
    connect(picture, &TechniquePicture::chosen, this, [this, i] {
      controller_.edit(tr("Choose pane"), [&](Session& session) { session.technique = shown_[i]; });
    });
    connect(picture, &TechniquePicture::hovered, &prober_, &Prober::hover);
    headers_.push_back(header);
    pictures_.push_back(picture);
  }
}

ComparisonMode ComparisonPanes::mode() const {
  const Document& document = controller_.document();
  return document.content.scene ? document.session.comparison.mode : ComparisonMode::Single;
}

void ComparisonPanes::refresh() {
  arrange();
  showErrors();
  wipe_->setPosition(controller_.session().comparison.wipe);
  showPictures();
  schedule();
}

void ComparisonPanes::arrange() {
  const Session& session = controller_.session();
  std::vector<std::string> panes{session.technique};
  if (mode() == ComparisonMode::Wipe) panes.push_back(wipeTechniqueOf(session));
  if (mode() == ComparisonMode::Grid) panes = panesOf(session);
  const bool moved = panes.size() != shown_.size() || mode() != arranged_ ||
                     (mode() == ComparisonMode::Grid &&
                      std::find(panes.begin(), panes.end(), session.technique) - panes.begin() !=
                          std::find(shown_.begin(), shown_.end(), live_) - shown_.begin());
  arranged_ = mode();
  live_ = session.technique;
  shown_ = std::move(panes);
  if (moved) takeApart();
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    headers_[i]->setTechnique(style::text(shown_[i]));
    headers_[i]->setActive(shown_[i] == live_);
  }
  if (!moved) return;
  view_.setMinimumSize(arranged_ == ComparisonMode::Grid ? viewInGrid : viewAlone);
  wipe_->setVisible(arranged_ == ComparisonMode::Wipe);
  if (arranged_ == ComparisonMode::Grid) return arrangeGrid();
  const int columns = int(shown_.size());
  for (int i = 0; columns > 1 && i < columns; ++i) {
    grid_->addWidget(headers_[std::size_t(i)], 0, i);
    headers_[std::size_t(i)]->show();
  }
  for (int i = 0; i < columns; ++i) grid_->setColumnStretch(i, 1);
  grid_->setRowStretch(1, 1);
  grid_->addWidget(&view_, 1, 0, 1, columns);
}

void ComparisonPanes::arrangeGrid() {
  const int count = int(shown_.size()), columns = count <= 4 ? 2 : 3;
  grid_->setHorizontalSpacing(paneGap);
  for (int i = 0; i < count; ++i) {
    const int row = i / columns * 2, column = i % columns;
    const auto pane = std::size_t(i);
    QWidget* body = pictures_[pane];
    if (shown_[pane] == live_) body = &view_;
    grid_->addWidget(headers_[pane], row, column);
    grid_->addWidget(body, row + 1, column);
    grid_->setRowStretch(row + 1, 1);
    grid_->setColumnStretch(column, 1);
    headers_[pane]->show();
    body->show();
  }
}

// The view stays in sight all the while: its OpenGL context goes on.
void ComparisonPanes::takeApart() {
  while (QLayoutItem* item = grid_->takeAt(0)) delete item;
  for (int row = 0; row < grid_->rowCount(); ++row) grid_->setRowStretch(row, 0);
  for (int column = 0; column < grid_->columnCount(); ++column) grid_->setColumnStretch(column, 0);
  grid_->setHorizontalSpacing(0);
  for (PaneHeader* header : headers_) header->hide();
  for (TechniquePicture* picture : pictures_) picture->hide();
}

void ComparisonPanes::showErrors() {
  const auto& report = prober_.report();
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const TechniqueResult* result = report ? resultOf(report->probe, shown_[i]) : nullptr;
    headers_[i]->setError(result ? std::optional(result->error) : std::nullopt);
  }
}

void ComparisonPanes::showPictures() {
  if (mode() != arranged_) return;  // of another document, to which refresh() is about to come
  const auto pictureOf = [this](const std::string& id) {
    const auto found = drawn_.find(id);
    return found == drawn_.end() ? nullptr : &found->second;
  };
  if (arranged_ == ComparisonMode::Wipe) {
    const Drawn* right = pictureOf(shown_.back());
    view_.setCurtain(right ? right->picture : QImage(), controller_.session().comparison.wipe,
                     right ? right->problem : QString());
    return;
  }
  view_.setCurtain({}, 1.0, {});
  if (arranged_ != ComparisonMode::Grid) return;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    if (shown_[i] == live_) continue;
    const Drawn* drawn = pictureOf(shown_[i]);
    if (!drawn || drawn->picture.isNull())
      pictures_[i]->setMessage(drawn ? drawn->problem : QString());
    else
      pictures_[i]->setPicture(drawn->picture);
    // Over an older picture stays the probe of then.
    if (isCurrent(shown_[i])) pictures_[i]->setContents(view_.overlayContents());
  }
}

}  // namespace umbra
