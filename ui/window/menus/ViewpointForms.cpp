#include "ui/window/menus/ViewpointForms.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <optional>
#include <span>
#include <vector>

#include "filters/core/settings/SettingsTable.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/SettingEditor.h"

namespace umbra {
namespace {

// A light or a camera: where the session and the scene have it, and its words.
template <class T>
struct Subject {
  std::span<const SettingRow<T>> table;
  std::optional<T> Session::*ofSession;
  T Scene::*ofScene;
  QString reset, resetStep, hint;
};

template <class T>
class ViewpointForm : public QWidget {
 public:
  ViewpointForm(SessionController& controller, const Subject<T>& subject)
      : controller_(controller), subject_(subject) {
    auto* lines = new QVBoxLayout(this);
    lines->setContentsMargins(14, 10, 14, 10);
    setStyleSheet(style::sheet());
    for (const auto& declared : subject.table) {
      rows_.push_back(SettingEditor::make(bound(declared, shown_), this));
      lines->addWidget(rows_.back());
      follow(*rows_.back());
    }
    auto* reset = new QPushButton(subject.reset);
    lines->addWidget(reset);
    connect(reset, &QPushButton::clicked, this, [this] {
      controller_.edit(subject_.resetStep,
                       [this](Session& session) { (session.*subject_.ofSession).reset(); });
    });
    auto* hint = new QLabel(subject.hint);
    hint->setStyleSheet(QString("color: %1").arg(style::muted.name()));
    lines->addWidget(hint);
    connect(&controller_, &SessionController::changed, this, &ViewpointForm::refresh);
    refresh();
  }

 private:
  void follow(SettingEditor& row) {
    const QString noun = style::text(row.info().noun);
    connect(&row, &SettingEditor::changed, this, [this, noun] {
      const T wanted = shown_;
      controller_.edit(
          QObject::tr("Change %1").arg(noun),
          [&](Session& session) {
            validate(wanted, noun.toStdString());
            session.*subject_.ofSession = wanted;
          },
          noun);
      refresh();  // one that gives no picture was refused
    });
    connect(&row, &SettingEditor::finished, this, [this] { controller_.endMerge(); });
  }

  void refresh() {
    const Document& document = controller_.document();
    const auto& scene = document.content.scene;
    setEnabled(scene != nullptr);
    shown_ =
        (document.session.*subject_.ofSession).value_or(scene ? (*scene).*subject_.ofScene : T{});
    for (SettingEditor* row : rows_) row->follow();
  }

  SessionController& controller_;
  Subject<T> subject_;
  T shown_;
  std::vector<SettingEditor*> rows_;
};

}  // namespace

QWidget* makeLightForm(SessionController& controller) {
  return new ViewpointForm<Light>(
      controller,
      {lightTable(), &Session::light, &Scene::light, QObject::tr("Back to the scene's light"),
       QObject::tr("Reset light"), QObject::tr("Drag the sun in the picture to move the light.")});
}

QWidget* makeCameraForm(SessionController& controller) {
  return new ViewpointForm<Camera>(
      controller,
      {cameraTable(), &Session::camera, &Scene::camera, QObject::tr("Back to the scene's camera"),
       QObject::tr("Reset camera"), QObject::tr("Drag in the picture to turn the camera.")});
}

}  // namespace umbra
