#include "ui/widgets/tables/PlainTable.h"

#include <QHeaderView>
#include <QTableView>

#include "ui/widgets/base/Style.h"

namespace umbra {

void makePlain(QTableView& table, const QColor& heading) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setShowGrid(false);
  table.setFrameShape(QFrame::NoFrame);
  table.verticalHeader()->hide();
  table.verticalHeader()->setMinimumSectionSize(10);
  QHeaderView& header = *table.horizontalHeader();
  header.setMinimumSectionSize(10);
  header.setHighlightSections(false);
  header.setSectionsClickable(false);
  const QString colour = heading.isValid() ? QString("color: %1;").arg(heading.name()) : QString();
  header.setStyleSheet(QString("QHeaderView { background: transparent; } QHeaderView::section { "
                               "border: none; border-bottom: 1px solid %1; background: "
                               "transparent; %2 padding: 2px 3px; }")
                           .arg(style::border.name(), colour));
}

}  // namespace umbra
