// Rows of a form: a label beside its editor.
#pragma once

#include <QString>
#include <functional>
#include <initializer_list>
#include <utility>

class QComboBox;
class QVBoxLayout;
class QWidget;

namespace umbra {

class NumberControl;
struct SliderScale;

// A label at the left, the editor at the right end. The result holds both.
QWidget* row(QVBoxLayout* body, const QString& text, QWidget* editor, const QString& toolTip);

// Number and slider. `parent` owns the control.
NumberControl* sliderRow(QVBoxLayout* body, QWidget* parent, const QString& text,
                         const SliderScale& scale, const QString& unit, const QString& toolTip);

// The same for a control that there is. The result holds all of it, so that it can be hidden.
QWidget* sliderGroup(QVBoxLayout* body, const QString& text, NumberControl* control,
                     const QString& toolTip);

// A box of values, each with its text.
QComboBox* choices(std::initializer_list<std::pair<QString, int>> items);
// Adds the value where the box has it not.
void select(QComboBox* box, int value, const QString& textWhereAbsent);
// Greys out the values for which `why` gives a reason, which becomes their tool tip.
void refuseItems(QComboBox* box, const std::function<QString(int)>& why);

}  // namespace umbra
