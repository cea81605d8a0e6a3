// What the tables of figures have in common.
#pragma once

class QColor;
class QTableView;

namespace umbra {

// Whole rows are chosen, one at a time; there is no grid, no frame and no row numbers, and a thin
// line under the headings. Headings have the colour `heading`; where that is no valid colour, the
// model's.
void makePlain(QTableView& table, const QColor& heading);

}  // namespace umbra
