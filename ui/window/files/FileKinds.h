// The patterns of the files that can be opened, for a dialog's list of kinds.
#pragma once

#include <QString>

namespace umbra {

// "*.obj *.ply".
QString meshPatterns();
QString depthPatterns();
// One entry, such as "Meshes (*.obj *.ply)".
QString meshFilter();
QString depthFilter();
// An entry for all of them, then one for each kind.
QString everyFilter();

}  // namespace umbra
