#include "ui/window/MessageBanner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/widgets/base/Style.h"

namespace umbra {

MessageBanner::MessageBanner(QWidget* parent)
    : QFrame(parent), label_(new QLabel), close_(new QToolButton) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 6, 6, 6);
  label_->setTextFormat(Qt::PlainText);  // a file's name may look like markup
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setText(QChar(0x2715));
  close_->setAutoRaise(true);
  layout->addWidget(label_, 1);
  layout->addWidget(close_, 0, Qt::AlignTop);
  connect(close_, &QToolButton::clicked, this, [this] {
    if (isProgress_)
      emit stopAsked();
    else
      dismiss();
  });
  hide();
}

void MessageBanner::showError(const QString& text) {
  isProgress_ = false;
  showText(text, style::error);
}
void MessageBanner::showNotice(const QString& text) {
  isProgress_ = false;
  showText(text, style::accent);
}
void MessageBanner::showProgress(const QString& text) {
  isProgress_ = true;
  showText(text, style::accent);
}
QString MessageBanner::text() const {
  return isHidden() ? QString() : label_->text();
}

void MessageBanner::dismiss() {
  label_->clear();
  hide();
}

void MessageBanner::showText(const QString& text, const QColor& edge) {
  setStyleSheet(QString("umbra--MessageBanner { background: white; border: 1px solid %1; "
                        "border-left: 4px solid %2; border-radius: 4px; }")
                    .arg(style::border.name(), edge.name()));
  label_->setText(text);
  close_->setToolTip(isProgress_ ? tr("Stop this") : tr("Put this message away"));
  close_->setAccessibleName(close_->toolTip());
  show();
}

}  // namespace umbra
