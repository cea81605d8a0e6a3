// The layers of the session's technique over the map's second occluders, and Lloyd's relaxation to
// be played beside its cost.
#pragma once

#include <QWidget>

class QBoxLayout;
class QLabel;
class QPushButton;

namespace umbra {

class LayersController;
class PlotPane;
class SessionController;

class LayersPane : public QWidget {
  Q_OBJECT

 public:
  LayersPane(LayersController& layers, SessionController& controller, QWidget* parent = nullptr);

  PlotPane& histogram() { return *histogram_; }
  PlotPane& cost() { return *cost_; }

 signals:
  void message(const QString& text);  // one line for the status bar

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QPushButton* addButton(const QString& text, const char* name, const QString& toolTip);
  void refresh();
  void refreshPlots();
  void showHints();
  QString progressText() const;

  LayersController& layers_;
  SessionController& controller_;
  PlotPane *histogram_, *cost_;
  QBoxLayout *plots_, *buttons_;
  QPushButton *start_, *step_, *play_, *end_;
  QLabel* progress_;
};

}  // namespace umbra
