// What a frame's mean error consists of, over the frame and over a selection; its rows choose which
// part is looked at.
#pragma once

#include <QTableWidget>
#include <optional>

#include "analysis/errors/ErrorDecomposition.h"

namespace umbra {

// A part's name and what it is, in a sentence; without one, of the whole error.
QString titleOf(std::optional<ErrorPart> part);
QString meaningOf(std::optional<ErrorPart> part);

class ErrorTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ErrorTable(QWidget* parent = nullptr);

  // `technique` heads the copied text.
  void setSums(const QString& technique, const ErrorSums& frame,
               const std::optional<ErrorSums>& selection);
  void clearSums();
  // Fades figures that no longer count.
  void setFaded(bool faded);
  void setPart(std::optional<ErrorPart> part);

  // Tab separated with a header line, numbers in full precision; "" without sums.
  QString asText() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;  // a few rows: it scrolls where there is no room

 public slots:
  void copy() const;

 signals:
  // Emitted after a click or an arrow key, never by setPart.
  void partChosen(std::optional<umbra::ErrorPart> part);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void setFigure(int row, int column, const QString& text, const QString& toolTip);
  void setColumn(int column, const std::optional<ErrorSums>& sums);

  QString technique_;
  std::optional<ErrorSums> frame_, selection_;
  bool quiet_ = false;  // while setPart moves the selection
};

}  // namespace umbra
