#include "ui/window/ControlPane.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "datasets/session/PaneChoice.h"
#include "datasets/session/PaneEditing.h"
#include "filters/core/technique/Composition.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/probe/ReductionTools.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/FrameSettingsForm.h"
#include "ui/widgets/forms/ParameterForm.h"
#include "ui/widgets/forms/TechniqueList.h"

namespace umbra {
ControlPane::ControlPane(SessionController& controller, Prober& prober, SceneView& view,
                         QWidget* parent)
    : QScrollArea(parent),
      controller_(controller),
      scope_(new QLabel),
      techniques_(new TechniqueList),
      parameters_(new ParameterForm),
      frame_(new FrameSettingsForm),
      reduction_(new ReductionTools(controller, prober, view)) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget;
  inside->setObjectName("controls");
  auto* layout = new QVBoxLayout(inside);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
  parameters_->setTools(reduction_);
  scope_->setObjectName("scope");
  scope_->setWordWrap(true);
  scope_->setContentsMargins(6, 4, 6, 0);
  scope_->setStyleSheet(QString("color: %1").arg(style::accent.name()));
  layout->addWidget(scope_);
  layout->addWidget(techniques_);
  layout->addWidget(parameters_);
  layout->addWidget(frame_);
  layout->addStretch(1);
  setWidget(inside);
  setMinimumWidth(inside->minimumSizeHint().width() + 4);

  techniques_->setTechniques(controller_.catalogue().all());
  connect(&controller_, &SessionController::changed, this, &ControlPane::refresh);
  connect(techniques_, &TechniqueList::techniqueChosen, this, [this](const QString& id) {
    controller_.editPanes(tr("Choose technique"), [&](Workspace& workspace) {
      chooseTechnique(workspace, id.toStdString());
    });
  });
  connect(parameters_, &ParameterForm::parameterChanged, this, &ControlPane::changeParameter);
  connect(parameters_, &ParameterForm::editingFinished, this, [this] { controller_.endMerge(); });
  connect(frame_, &FrameSettingsForm::settingsChanged, this,
          [this](const FrameSettings& settings, const QString& what) {
            controller_.edit(
                tr("Change %1").arg(what),
                [&](Session& session) {
                  const ViewMode mode = session.frame.view;
                  session.frame = settings;
                  session.frame.view = mode;
                },
                "frame " + what);
          });
  connect(frame_, &FrameSettingsForm::editingFinished, this, [this] { controller_.endMerge(); });
  connect(reduction_, &ReductionTools::amountFound, this, [this](double amount) {
    controller_.endMerge();
    changeParameter(style::text(bleedReductionName), amount);
    controller_.endMerge();
  });
  connect(&prober, &Prober::reported, reduction_, &ReductionTools::followProbe);
  connect(&view, &SceneView::frameDrawn, this, [this, &view] {
    if (const ShadowRenderer* drawn = view.lastFrame()) frame_->setGivenSamples(drawn->samples());
  });
  refresh();
}

// Says which panes the controls are about; empty where nothing is compared.
QString ControlPane::scope() const {
  const Comparison comparison = comparisonOf(controller_.workspace());
  const std::size_t shown = shownPanes(comparison);
  if (!controller_.document().content.scene || shown < 2) return {};
  const Pane& active = comparison.panes[comparison.active];
  const auto sharesFrame = [](const Pane& pane) {
    for (int i = 0; i <= int(PaneSetting::Bias); ++i)
      if (PaneSetting(i) != PaneSetting::Parameters && hasOwn(pane, PaneSetting(i))) return false;
    return true;
  };
  const auto end = comparison.panes.begin() + std::ptrdiff_t(shown);
  const auto sharing = std::count_if(comparison.panes.begin(), end, sharesFrame);
  if (sharesFrame(active) && sharing > 1)
    return tr("Filter and map are shared by %1 panes").arg(sharing);
  bool alone = true;
  for (int i = 0; i <= int(PaneSetting::Bias); ++i) alone = alone && hasOwn(active, PaneSetting(i));
  return alone || sharesFrame(active) ? tr("Settings of the active pane alone")
                                      : tr("Some settings are of the active pane alone");
}

void ControlPane::refresh() {
  scope_->setText(scope());
  scope_->setVisible(!scope_->text().isEmpty());
  techniques_->setCurrent(style::text(controller_.session().technique));
  techniques_->setRefusals(controller_.refusals());
  parameters_->setTechnique(controller_.technique());
  parameters_->setNotices(controller_.notices());
  frame_->setSettings(controller_.session().frame);
  frame_->setObstacle([this](const FrameSettings& frame) {
    FrameSettings drawn = frame;
    // A depth file's texels are read as they are.
    if (controller_.document().content.depth) drawn.read.filter = ReadFilter::Point;
    return QString::fromStdString(whyImpossible(drawn, controller_.technique()));
  });
  const Document& document = controller_.document();
  if (document.session.camera)
    frame_->setCamera(*document.session.camera);
  else if (document.content.scene)
    frame_->setCamera(document.content.scene->camera);
  reduction_->refresh();
}

void ControlPane::changeParameter(const QString& name, const ParameterValue& value) {
  const std::string id = controller_.session().technique, key = name.toStdString();
  controller_.edit(
      tr("Change %1").arg(style::label(key)),
      [&](Session& session) {
        editParameters(session, controller_.catalogue(), id, [&](auto parameters) {
          parameterNamed(parameters, key, id).set(value, id + "." + key);
        });
      },
      style::text(id + "." + key));
}

}  // namespace umbra
