#include "ui/widgets/tables/RegionTable.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

enum RowIndex { Texel, Texels, Mean, Variance, MinMax, Beta, Receiver, Reference };

struct RowText {
  const char* label;
  const char* toolTip;
};

constexpr RowText rowTexts[] = {
    {QT_TRANSLATE_NOOP("RegionTable", "texel"), "x, y of the region's centre in the shadow map"},
    {QT_TRANSLATE_NOOP("RegionTable", "texels"),
     "Taps that the filtered read averages, and the kernel"},
    {QT_TRANSLATE_NOOP("RegionTable", "mean"), "μ = M1 = Σ w z"},
    {"σ²", "σ² = M2 − M1² = Σ w z² − (Σ w z)²"},
    {QT_TRANSLATE_NOOP("RegionTable", "min, max"),
     "The nearest and the farthest depth of the region"},
    {"β", "β = (mean − min) / (max − mean)   (Gumbau et al. 2011, eq. 3)"},
    {QT_TRANSLATE_NOOP("RegionTable", "receiver"), "z_r: the shaded surface's depth, biased"},
    {QT_TRANSLATE_NOOP("RegionTable", "reference"),
     "v_ref = Σ w [z ≥ z_r]: exact percentage-closer filtering, the reference for every "
     "technique"}};

QFrame* separator() {
  auto* line = new QFrame;
  line->setFixedHeight(1);
  line->setStyleSheet("background: " + style::border.name());
  return line;
}

}  // namespace

RegionTable::RegionTable(QWidget* parent) : Card(tr("Region"), parent) {
  auto* grid = new QGridLayout;
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (const RowText& text : rowTexts) {
    auto* label = new QLabel(tr(text.label));
    auto* figure = new QLabel;
    figure->setFont(style::figures(font()));
    figure->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    figure->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setToolTip(tr(text.toolTip));
    figure->setToolTip(tr(text.toolTip));
    const int row = 2 * int(rows_.size());
    grid->addWidget(label, row, 0);
    grid->addWidget(figure, row, 1);
    grid->addWidget(separator(), row + 1, 0, 1, 2);
    rows_.append(Row{label, figure});
  }
  QPalette amber = rows_[Receiver].label->palette();
  amber.setColor(QPalette::WindowText, style::probe.darker(130));
  rows_[Receiver].label->setPalette(amber);
  rows_[Receiver].figure->setPalette(amber);
  body()->addLayout(grid);
  body()->addStretch();
  clear();
}

void RegionTable::setProbe(const Probe& probe, const QPoint& origin) {
  const RegionStatistics& s = probe.statistics;
  const Region& region = probe.region;
  set(Texel, QString("%1, %2").arg(region.x + origin.x()).arg(region.y + origin.y()));
  set(Texels, QString("%1 · %2")
                  .arg(region.texels.size())
                  .arg(QString::fromStdString(describe(region.kernel))));
  set(Mean, style::figure(s.mean));
  set(Variance, style::figure(s.variance));
  set(MinMax, style::figure(s.min) + ", " + style::figure(s.max));
  set(Beta, std::isinf(s.beta)   ? QString(QChar(0x221e))
            : std::isnan(s.beta) ? QString(QChar(0x2013))
                                 : style::figure(s.beta));
  set(Receiver, QString::number(probe.receiver, 'f', 4));
  set(Reference, QString::number(probe.reference, 'f', 4));
}

void RegionTable::clear() {
  for (int row = 0; row < rows_.size(); ++row) set(row, QString(QChar(0x2013)));
}

QString RegionTable::asText() const {
  QString text;
  for (const auto& row : rows_) text += row.label->text() + "\t" + row.figure->text() + "\n";
  return text;
}

void RegionTable::set(int row, const QString& figure) {
  rows_[row].figure->setText(figure);
}

}  // namespace umbra
