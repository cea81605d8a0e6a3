#include "ui/widgets/forms/ParameterForm.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/ParameterRow.h"

namespace umbra {
namespace {

QLabel* wrapping(const QColor& colour) {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setMinimumWidth(0);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QPalette palette = label->palette();
  palette.setColor(QPalette::WindowText, colour);
  label->setPalette(palette);
  return label;
}

}  // namespace

ParameterForm::ParameterForm(QWidget* parent)
    : Card(tr("Parameters"), parent),
      empty_(wrapping(style::muted)),
      notices_(wrapping(style::ink)),
      source_(wrapping(style::muted)) {
  empty_->setText(tr("This technique has nothing to set."));
  notices_->hide();
  empty_->hide();
  body()->addWidget(empty_);
  body()->addWidget(notices_);
  body()->addWidget(source_);
  body()->addStretch();
}

ParameterForm::~ParameterForm() = default;

void ParameterForm::setTechnique(const Technique& technique) {
  const bool same = shown_ && shown_->info().id == technique.info().id;
  // The rows still refer to the earlier copy, which must therefore live until they are bound anew.
  const std::unique_ptr<Technique> before = std::move(shown_);
  shown_ = technique.clone();
  const std::vector<Parameter> parameters = shown_->parameters();
  if (!same || parameters.size() != rows_.size()) return rebuild();
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->follow(parameters[i]);
}

void ParameterForm::rebuild() {
  for (ParameterRow* row : rows_) delete row;
  rows_.clear();
  const TechniqueInfo& info = shown_->info();
  setTitle(tr("%1 parameters").arg(style::text(info.title)));
  for (const Parameter& parameter : shown_->parameters()) {
    ParameterRow* row = ParameterRow::make(parameter, this);
    body()->insertWidget(int(rows_.size()), row);
    rows_.push_back(row);
    const QString name = row->name();
    connect(row, &ParameterRow::changed, this,
            [this, name](const ParameterValue& value) { emit parameterChanged(name, value); });
    connect(row, &ParameterRow::finished, this, [this, name] { emit editingFinished(name); });
  }
  empty_->setVisible(rows_.empty());
  source_->setText(style::text(info.citation) + "\n" + style::text(info.formula));
  source_->setToolTip(style::text(info.summary));
}

void ParameterForm::setTools(QWidget* tools) {
  body()->insertWidget(int(rows_.size()), tools);
}

void ParameterForm::setNotices(const QStringList& notices) {
  notices_->setText(notices.join("\n"));
  notices_->setVisible(!notices.isEmpty());
}

}  // namespace umbra
