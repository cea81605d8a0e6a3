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
  close_->setToolTip(tr("Put this message away"));
  layout->addWidget(label_, 1);
  layout->addWidget(close_, 0, Qt::AlignTop);
  connect(close_, &QToolButton::clicked, this, &MessageBanner::dismiss);
  hide();
}

void MessageBanner::showError(const QString& text) {
  showText(text, style::error, true);
}
void MessageBanner::showNotice(const QString& text) {
  showText(text, style::accent, true);
}
void MessageBanner::showProgress(const QString& text) {
  showText(text, style::accent, false);
}
QString MessageBanner::text() const {
  return isHidden() ? QString() : label_->text();
}

void MessageBanner::dismiss() {
  label_->clear();
  hide();
}

void MessageBanner::showText(const QString& text, const QColor& edge, bool closable) {
  setStyleSheet(QString("umbra--MessageBanner { background: white; border: 1px solid %1; "
                        "border-left: 4px solid %2; border-radius: 4px; }")
                    .arg(style::border.name(), edge.name()));
  label_->setText(text);
  close_->setVisible(closable);
  show();
}

}  // namespace umbra
