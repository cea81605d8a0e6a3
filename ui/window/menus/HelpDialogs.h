// What the program says about itself.
#pragma once

#include <QString>
#include <utility>
#include <vector>

class QWidget;

namespace umbra {

class Technique;

// None of them waits: they close themselves and are gone.
void showTechniquePage(const Technique& technique, QWidget* parent);
// Each pair is what is done, and the key that does it.
void showShortcuts(const std::vector<std::pair<QString, QString>>& shortcuts, QWidget* parent);
void showAbout(QWidget* parent);

}  // namespace umbra
