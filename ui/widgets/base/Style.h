// Colours, figures and small texts that the widgets share.
#pragma once

#include <QColor>
#include <QFont>
#include <QString>
#include <string_view>

namespace umbra::style {

inline const QColor ink{0x1f, 0x29, 0x33};
inline const QColor muted{0x6b, 0x77, 0x85};
inline const QColor border{0xe1, 0xe5, 0xea};
inline const QColor ground{0xf3, 0xf4, 0xf6};
inline const QColor accent{0x3f, 0x6f, 0xb5};
inline const QColor probe{0xf5, 0x9e, 0x0b};
inline const QColor error{0xd1, 0x34, 0x4b};

// `base` where its digits are equally wide, else a font of its size whose digits are, so that
// figures beneath each other align.
QFont figures(const QFont& base);

// The technique's colour, very light: the background of its row where it is the selected one.
QColor tint(const QColor& colour);

QString text(std::string_view utf8);
// For a tool tip of text that is not ours: shown as it is, whatever markup it looks like.
QString plainTip(const QString& text);
// A parameter's name as a label: "min-variance" becomes "Min variance".
QString label(std::string_view kebabCase);
// With three decimals and a sign that is always there, a true minus: "+0.226", "−0.031".
QString signedFigure(double value);
// Four significant digits, a true minus: "0.4977".
QString figure(double value);

// For sliders, boxes and tables inside a card.
QString sheet();

}  // namespace umbra::style
