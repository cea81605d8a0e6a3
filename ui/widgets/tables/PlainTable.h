// What the tables of figures have in common.
#pragma once

class QColor;
class QTableView;

namespace umbra {

// Whole rows are chosen, one at a time; no grid, no frame and no row numbers, and a thin line under
// the headings. They are in `heading`, or in what the model says where it is no valid colour.
void makePlain(QTableView& table, const QColor& heading);

}  // namespace umbra
