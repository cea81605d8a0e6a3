#include "ui/widgets/base/Card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/widgets/base/ElidedLabel.h"
#include "ui/widgets/base/Style.h"

namespace umbra {

Card::Card(const QString& title, QWidget* parent)
    : QFrame(parent), title_(new ElidedLabel), header_(new QHBoxLayout), body_(new QVBoxLayout) {
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  header_->addWidget(title_, 1);
  header_->setSpacing(4);
  body_->setSpacing(4);

  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(10, 8, 10, 8);
  outer->setSpacing(6);
  outer->addLayout(header_);
  outer->addLayout(body_, 1);

  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, style::ink);
  colours.setColor(QPalette::Text, style::ink);
  setPalette(colours);
  setStyleSheet(style::sheet());
  setTitle(title);
}

void Card::setTitle(const QString& title) {
  title_->setText(title);
  title_->setVisible(!title.isEmpty());
}

QString Card::title() const {
  return title_->text();
}

void Card::addToHeader(QWidget* widget) {
  header_->addWidget(widget);
}

void Card::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(style::border, 1.0));
  painter.setBrush(Qt::white);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

}  // namespace umbra
