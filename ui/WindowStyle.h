// The look of the whole application: Fusion, light, restrained.
#pragma once

class QApplication;

namespace umbra {

void applyStyle(QApplication& application);

}  // namespace umbra
