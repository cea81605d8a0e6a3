// The middle of the window: messages, the picture or the depth file, and what its colours mean.
#pragma once

#include <QTimer>
#include <QWidget>
#include <string>

class QLabel;
class QSlider;
class QStackedWidget;

namespace umbra {

class ColourBar;
class ComparisonPanes;
class MessageBanner;
class Prober;
class SceneView;
class SessionController;
class ShadowMapView;

class CentrePane : public QWidget {
  Q_OBJECT

 public:
  // Takes `view` over.
  CentrePane(SessionController& controller, SceneView& view, Prober& prober,
             QWidget* parent = nullptr);

  MessageBanner& banner() { return *banner_; }
  // The picture of a scene, or several.
  ComparisonPanes& comparison() { return *comparison_; }
  // The depth file as a picture to probe; shown where the session's source is one.
  ShadowMapView& depthView() { return *depth_; }

 private:
  QWidget* makeDepthPage();
  void refresh();
  void showNotices();
  void showReport();
  std::size_t paneAtProbe() const;

  SessionController& controller_;
  SceneView& view_;
  Prober& prober_;
  MessageBanner* banner_;
  QTimer opening_;  // what is being read takes longer than one wants to wait without a word
  QStackedWidget* pages_;
  ComparisonPanes* comparison_;
  ColourBar* legend_;
  ShadowMapView* depth_;
  QSlider* receiver_;  // ten-thousandths
  QLabel* receiverText_;
  std::string shownFile_;             // whose map depth_ shows
  const void* shownDepth_ = nullptr;  // the map that depth_ shows, to tell a new one
};

}  // namespace umbra
