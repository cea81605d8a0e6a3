// The look of the whole application: Fusion, light, restrained.
#pragma once

class QApplication;

namespace umbra {

// Must be called before the application is made: it fixes its name and how OpenGL contexts are
// made.
void prepareApplication();

void applyStyle(QApplication& application);

}  // namespace umbra
