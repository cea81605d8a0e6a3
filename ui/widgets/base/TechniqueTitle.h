// What a technique is called where there is little room.
#pragma once

#include <QString>

#include "filters/core/technique/Technique.h"

namespace umbra {

// The abbreviation alone, "VSM" of "Variance (VSM)": the list of techniques shows the whole title.
QString shortTitle(const Technique& technique);

}  // namespace umbra
