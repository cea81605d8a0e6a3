#include "ui/ControlPane.h"

#include <QVBoxLayout>

#include "filters/core/Composition.h"
#include "ui/Prober.h"
#include "ui/ReductionTools.h"
#include "ui/SceneView.h"
#include "ui/SessionController.h"
#include "ui/widgets/FrameSettingsForm.h"
#include "ui/widgets/ParameterForm.h"
#include "ui/widgets/Style.h"
#include "ui/widgets/TechniqueList.h"

namespace umbra {
ControlPane::ControlPane(SessionController& controller, Prober& prober, SceneView& view,
                         QWidget* parent)
    : QScrollArea(parent),
      controller_(controller),
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
  layout->addWidget(techniques_);
  layout->addWidget(parameters_);
  layout->addWidget(frame_);
  layout->addStretch(1);
  setWidget(inside);
  setMinimumWidth(inside->minimumSizeHint().width() + 4);

  techniques_->setTechniques(controller_.catalogue().all());
  connect(&controller_, &SessionController::changed, this, &ControlPane::refresh);
  connect(techniques_, &TechniqueList::techniqueChosen, this, [this](const QString& id) {
    controller_.edit(tr("Choose technique"),
                     [&](Session& session) { chooseTechnique(session, id.toStdString()); });
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

void ControlPane::refresh() {
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
