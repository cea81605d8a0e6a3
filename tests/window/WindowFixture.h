// The window as a person uses it.
#pragma once

#include <QEvent>
#include <QObject>
#include <QTemporaryDir>
#include <memory>

#include "ui/picture/ProbeReport.h"
#include "ui/window/MainWindow.h"

namespace umbra {

constexpr int patience = 60000;  // milliseconds; software OpenGL beside other work

class WindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void cleanup();

  void theWorstSpotIsInFullShadow();
  void aFootprintLiesOnItsSurface();
  void aDirectionalLightTurnsAboutItsTarget();
  void theFirstFrameShowsWhereLightBleeds();
  void theTableAgreesWithTheAnalysis();
  void hoveringProbesAndLeavingKeepsTheProbe();
  void aPinnedProbeStaysOnItsPoint();
  void aHiddenProbeFollowsTheParameters();
  void keptProbesStayOnTheirPoints();
  void aKeptProbeIsGoneToRenamedAndDeleted();
  void keptProbesAreSavedAndOpenedAgain();
  void aKeptProbeOutOfSightIsGoneTo();
  void keptTexelsAreOfTheirFile();
  void keptFiguresHideBehindAVeil();
  void aParameterChangeIsUndoneAndRedone();
  void theSmallestReductionOfTheRegionIsSetAndPriced();
  void theSmallestReductionOfThePictureDarkensEveryUmbra();
  void whatAFormatCannotHoldCannotBeChosen();
  void aSliderDragIsOneStep();
  void anotherNumberOfLayersDropsTheSplits();
  void aSplitIsDragged();
  void lloydIsSteppedToItsEndAndUndone();
  void whatLloydPlayedIsOneStep();
  void aTechniqueWithoutLayersNamesThoseThatHaveThem();
  void theErrorIsTakenApartAsByHand();
  void aLassoCountsWhatItCircles();
  void aPixelOfTheErrorIsProbed();
  void theErrorOfAnEarlierPictureFades();
  void withoutAPictureTheErrorSaysWhy();
  void aWipeIsDragged();
  void aWipesSidesStayWhereTheyAre();
  void panesAreLabelledWithTheirErrorAtTheProbe();
  void aClickedPaneIsTheSessions();
  void whatAPaneCannotShowIsSaidThere();
  void aDepthFileTakesThePlaceOfPanes();
  void aDuplicateIsDrawnWithItsOwnSettings();
  void anotherPaneBringsItsSettingsToTheControls();
  void aPanesErrorIsOfItsOwnSettings();
  void aPanesMenuSharesAndCloses();
  void whatPanesShowIsKept();
  void panesWithSettingsAreSavedAndOpened();
  void digitsSwitchTechniques();
  void keysSwitchTheView();
  void draggingTheSunMovesTheLight();
  void draggingTheReceiverIsStudiedUntilReset();
  void aMapChannelCanBeLookedAt();
  void aProbeIsOnTheMapOfItsCascade();
  void whatATableOfSumsCannotServeCannotBeChosen();
  void aDockFloatsAndComesBack();
  void pictureAndPlotsAreWritten();
  void bleedingIsWrittenOntoTheMesh();
  void aCancelledMeshLeavesWhatWasThere();
  void whatHasNoSurfacesIsRefused();
  void aBadFileLeavesTheSceneOpen();
  void droppedFacesAreReported();
  void anotherSceneOpensAndUndoBringsTheFirstBack();
  void aSceneParameterRebuildsTheScene();
  void aDepthFileIsProbedByTexel();
  void aRestartBringsSessionAndLayoutBack();
  void theSmallestScreenHoldsEverything();
  void lightBleedingIsPredictedThenMeasured();
  void aLessonIsWalkedByKeyAndKeepsItsPredictions();
  void aLessonLeavesOnesOwnSessionAsItWas();
  void quittingInALessonRemembersOnesOwnSession();

 private:
  // A window of 1300 × 800 on the session, its first frame drawn.
  MainWindow& open(const Session& session = {});
  // Waits until the last frame shows the present session and every pane follows it.
  void settle();
  void mouse(QEvent::Type type, const QPointF& point, Qt::MouseButton button,
             Qt::MouseButtons buttons);
  // Settles, and waits until the pictures beside the view have followed it.
  void settlePanes();
  // Settles, and waits until every kept probe has been read.
  void settleKept();
  void click(const Pixel& pixel);
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  QPointF pointOf(const Pixel& pixel);
  // The result of technique `id` in the present report.
  const TechniqueResult& result(const char* id);

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace umbra
