// The window's docks: which there are, and where they stand at first.
#pragma once

#include <QObject>
#include <vector>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace umbra {

class EvidencePanes;
class WatchedPanes;

class WindowDocks : public QObject {
  Q_OBJECT

 public:
  // Puts the panes into docks of `window`, which then own them.
  WindowDocks(QMainWindow& window, QWidget& controls, EvidencePanes& evidence, QWidget& savedProbes,
              WatchedPanes& watched);

  // In the order of the menu.
  const std::vector<QDockWidget*>& all() const { return docks_; }
  QDockWidget& controls() { return *controls_; }
  // Makes one more dock, which is not among all().
  QDockWidget* makeDock(const QString& title, const QString& name, QWidget& content,
                        Qt::DockWidgetArea area);

 public slots:
  // The arrangement that teaches: nothing floats, nothing is hidden.
  void reset();

 signals:
  void arranged();  // by reset()

 private:
  QDockWidget* add(const QString& title, const QString& name, QWidget& content,
                   Qt::DockWidgetArea area);
  void place(bool tall);
  void resize(bool tall);

  QMainWindow& window_;
  std::vector<QDockWidget*> docks_;
  QDockWidget *controls_, *table_, *map_, *curves_, *histogram_, *cdf_, *trace_, *probes_;
  QDockWidget *layers_, *explain_, *error_;
};

}  // namespace umbra
