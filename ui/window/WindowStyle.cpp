#include "ui/window/WindowStyle.h"

#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QPalette>
#include <QStyleFactory>
#include <QSurfaceFormat>

#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

QPalette lightPalette() {
  QPalette palette;
  palette.setColor(QPalette::Window, style::ground);
  palette.setColor(QPalette::WindowText, style::ink);
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor(0xf8, 0xf9, 0xfa));
  palette.setColor(QPalette::Text, style::ink);
  palette.setColor(QPalette::Button, QColor(0xfa, 0xfb, 0xfc));
  palette.setColor(QPalette::ButtonText, style::ink);
  palette.setColor(QPalette::ToolTipBase, style::ink);
  palette.setColor(QPalette::ToolTipText, Qt::white);
  palette.setColor(QPalette::Highlight, style::accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, style::accent);
  palette.setColor(QPalette::PlaceholderText, style::muted);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, QColor(0xa5, 0xae, 0xb8));
  return palette;
}

QString windowSheet() {
  return QString(R"(
    QMenuBar { background: white; border-bottom: 1px solid %1; padding: 1px 4px; }
    QMenuBar::item { padding: 4px 9px; border-radius: 3px; background: transparent; }
    QMenuBar::item:selected { background: %2; }
    QToolBar { background: white; border: none; border-bottom: 1px solid %1; spacing: 6px;
               padding: 6px 8px; }
    QToolBar QToolButton { border: 1px solid #cfd5dc; border-radius: 4px; padding: 4px 11px;
                           background: white; color: %3; }
    QToolBar QToolButton:hover { background: %2; }
    QToolBar QToolButton:checked { background: %3; border-color: %3; color: white; }
    QToolBar QToolButton:disabled { color: #a5aeb8; }
    QToolBar QToolButton[popupMode="2"] { padding-right: 20px; }
    QToolBar QToolButton::menu-indicator { subcontrol-position: right center; right: 6px; }
    QToolBar QLabel { color: %4; padding: 0 2px 0 8px; }
    QMainWindow::separator { background: transparent; width: 3px; height: 3px; }
    QMainWindow::separator:hover { background: %1; }
    QStatusBar { background: white; border-top: 1px solid %1; color: %4; }
    QStatusBar QLabel { color: %4; padding: 0 6px; }
    QStatusBar::item { border: none; }
    QTabBar::tab { padding: 4px 8px; border: 1px solid transparent; color: %4; background: transparent;
                   border-bottom: 2px solid transparent; }
    QTabBar::tab:hover { color: %3; }
    QTabBar::tab:selected { color: %3; border-bottom: 2px solid %3; }
    QScrollArea { background: transparent; }
    QWidget#controls, QWidget#centre { background: transparent; }
    QScrollBar:vertical { width: 9px; margin: 0; background: transparent; }
    QScrollBar:horizontal { height: 9px; margin: 0; background: transparent; }
    QScrollBar::handle { background: #cfd5dc; border-radius: 3px; margin: 1px 1px 1px 2px; }
    QScrollBar::handle:vertical { min-height: 28px; }
    QScrollBar::handle:horizontal { min-width: 28px; }
    QScrollBar::handle:hover { background: #a5aeb8; }
    QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
    QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
    QToolTip { border: none; padding: 5px 7px; background: %3; color: white; }
  )")
      .arg(style::border.name(), style::ground.name(), style::ink.name(), style::muted.name());
}

}  // namespace

void prepareApplication() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
  QCoreApplication::setOrganizationName("Umbrascope");
  QCoreApplication::setApplicationName("Umbrascope");
}

void applyStyle(QApplication& application) {
  application.setStyle(QStyleFactory::create("Fusion"));
  application.setPalette(lightPalette());
  QFont font = application.font();
  if (font.pointSizeF() > 9.5) font.setPointSizeF(9.5);  // many figures have to fit a projector
  application.setFont(font);
  application.setStyleSheet(windowSheet());
}

}  // namespace umbra
