#include "ui/ControlPane.h"

#include <QVBoxLayout>

#include "ui/SessionController.h"
#include "ui/widgets/FrameSettingsForm.h"
#include "ui/widgets/ParameterForm.h"
#include "ui/widgets/Style.h"
#include "ui/widgets/TechniqueList.h"

namespace umbra {

ControlPane::ControlPane(SessionController& controller, QWidget* parent)
    : QScrollArea(parent),
      controller_(controller),
      techniques_(new TechniqueList),
      parameters_(new ParameterForm),
      frame_(new FrameSettingsForm) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget;
  inside->setObjectName("controls");
  auto* layout = new QVBoxLayout(inside);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(8);
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
                     [&](Session& session) { session.technique = id.toStdString(); });
  });
  connect(parameters_, &ParameterForm::parameterChanged, this, &ControlPane::changeParameter);
  connect(parameters_, &ParameterForm::editingFinished, this, [this] { controller_.endMerge(); });
  connect(frame_, &FrameSettingsForm::settingsChanged, this,
          [this](const FrameSettings& settings, const QString& what) {
            controller_.edit(
                tr("Change %1").arg(what),
                [&](Session& session) {
                  const ViewMode view = session.frame.view;
                  session.frame = settings;
                  session.frame.view = view;
                },
                "frame " + what);
          });
  connect(frame_, &FrameSettingsForm::editingFinished, this, [this] { controller_.endMerge(); });
  refresh();
}

void ControlPane::refresh() {
  techniques_->setCurrent(style::text(controller_.session().technique));
  parameters_->setTechnique(controller_.technique());
  parameters_->setNotices(controller_.notices());
  frame_->setSettings(controller_.session().frame);
}

void ControlPane::changeParameter(const QString& name, const ParameterValue& value) {
  const std::string id = controller_.session().technique, key = name.toStdString();
  const std::unique_ptr<Technique> defaults = controller_.catalogue().make(id);
  const std::vector<Parameter> fields = defaults->parameters();
  const bool isDefault = parameterNamed(fields, key, id).defaultValue == value;
  controller_.edit(
      tr("Change %1").arg(style::label(key)),
      [&](Session& session) {
        if (!isDefault) {
          session.parameters[id][key] = value;
        } else if (const auto set = session.parameters.find(id); set != session.parameters.end()) {
          set->second.erase(key);
          if (set->second.empty()) session.parameters.erase(set);
        }
      },
      style::text(id + "." + key));
}

}  // namespace umbra
