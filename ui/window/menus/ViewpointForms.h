// The light and the camera in numbers: a row for each setting of their tables. The picture lets one
// drag both.
#pragma once

class QWidget;

namespace umbra {

class SessionController;

QWidget* makeLightForm(SessionController& controller);
QWidget* makeCameraForm(SessionController& controller);

}  // namespace umbra
