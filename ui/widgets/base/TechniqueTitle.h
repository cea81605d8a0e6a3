// What a technique is called where there is little room.
#pragma once

#include <QString>

#include "filters/core/technique/Technique.h"

namespace umbra {

// "Variance (VSM)" is VSM to those who have read its title in the list.
QString shortTitle(const Technique& technique);

}  // namespace umbra
