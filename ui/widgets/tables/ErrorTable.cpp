#include "ui/widgets/tables/ErrorTable.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>

#include "ui/widgets/base/Style.h"
#include "ui/widgets/tables/PlainTable.h"

namespace umbra {
namespace {

enum Column { Title, Frame, Selection, ColumnCount };
constexpr int pixelRow = errorPartCount + 1;  // below the whole error and its parts

std::optional<ErrorPart> partOf(int row) {
  return row == 0 ? std::nullopt : std::optional(ErrorPart(row - 1));
}

double meanOf(const ErrorSums& sums, std::optional<ErrorPart> part) {
  return part ? sums.means[std::size_t(*part)] : sums.error;
}

}  // namespace

QString titleOf(std::optional<ErrorPart> part) {
  if (!part) return ErrorTable::tr("Whole error");
  switch (*part) {
    case ErrorPart::Bleeding:
      return ErrorTable::tr("Bleeding");
    case ErrorPart::ContactLeak:
      return ErrorTable::tr("Contact leak");
    case ErrorPart::OverDarkening:
      return ErrorTable::tr("Over-darkening");
    case ErrorPart::Reduction:
      return ErrorTable::tr("Reduction");
    case ErrorPart::Precision:
      return ErrorTable::tr("Precision");
    case ErrorPart::Small:
      return ErrorTable::tr("Too small");
  }
  return {};
}

QString meaningOf(std::optional<ErrorPart> part) {
  if (!part)
    return ErrorTable::tr(
        "The visibility in the picture less that of exact percentage-closer filtering: red is too "
        "light, blue too dark.");
  switch (*part) {
    case ErrorPart::Bleeding:
      return ErrorTable::tr(
          "Too light: light comes through occluders that are far from the surface.");
    case ErrorPart::ContactLeak:
      return ErrorTable::tr(
          "Too light: light comes through occluders that almost touch the "
          "surface.");
    case ErrorPart::OverDarkening:
      return ErrorTable::tr("Too dark, already without any light-bleeding reduction.");
    case ErrorPart::Reduction:
      return ErrorTable::tr(
          "What light-bleeding reduction takes away, where light bleeds and where it does not.");
    case ErrorPart::Precision:
      return ErrorTable::tr(
          "What the storage format and the GPU's arithmetic change, against the "
          "same technique in double precision.");
    case ErrorPart::Small:
      return ErrorTable::tr("Errors below one grey level, 1/255, which are not taken apart.");
  }
  return {};
}

ErrorTable::ErrorTable(QWidget* parent) : QTableWidget(pixelRow + 1, ColumnCount, parent) {
  setHorizontalHeaderLabels({tr("Show"), tr("frame"), tr("lasso")});
  horizontalHeaderItem(Title)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  horizontalHeaderItem(Frame)->setToolTip(tr("Mean over all pixels that receive shadow"));
  horizontalHeaderItem(Selection)->setToolTip(
      tr("Mean over those inside the lasso: drag with the mouse over the picture"));
  for (int column : {Frame, Selection})
    horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (int row = 0; row <= pixelRow; ++row) {
    auto* title = new QTableWidgetItem(row < pixelRow ? titleOf(partOf(row)) : tr("Pixels"));
    title->setToolTip(row < pixelRow ? meaningOf(partOf(row))
                                     : tr("How many pixels receive shadow"));
    setItem(row, Title, title);
    for (int column : {Frame, Selection}) {
      auto* figure = new QTableWidgetItem;
      figure->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      figure->setFont(style::figures(font()));
      setItem(row, column, figure);
    }
    if (row == pixelRow)
      for (int column = 0; column < ColumnCount; ++column)
        item(row, column)->setFlags(Qt::ItemIsEnabled);
  }
  makePlain(*this, style::muted);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(Title, QHeaderView::Stretch);
  setStyleSheet(QString("QTableView { border: none; background: transparent; outline: 0; } "
                        "QTableView::item:selected { background: %1; color: %2; }")
                    .arg(style::tint(style::accent).name(), style::ink.name()));
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 3);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* copyAction = new QAction(tr("Copy table"), this);
  addAction(copyAction);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(copyAction, &QAction::triggered, this, &ErrorTable::copy);
  connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!quiet_ && row >= 0 && row < pixelRow) emit partChosen(partOf(row));
  });
  setPart(std::nullopt);
  clearSums();
}

QSize ErrorTable::sizeHint() const {
  const QFontMetrics metrics(style::figures(font()));
  const int figure = metrics.horizontalAdvance("+0.000") + 10;
  return {fontMetrics().horizontalAdvance(tr("Over-darkening")) + 10 + 2 * figure,
          horizontalHeader()->sizeHint().height() + rowCount() * rowHeight(0) + 2};
}

QSize ErrorTable::minimumSizeHint() const {
  return {sizeHint().width(), horizontalHeader()->sizeHint().height() + 2 * rowHeight(0)};
}

void ErrorTable::setFigure(int row, int column, const QString& text, const QString& toolTip) {
  item(row, column)->setText(text);
  item(row, column)->setToolTip(toolTip);
}

void ErrorTable::setColumn(int column, const std::optional<ErrorSums>& sums) {
  for (int row = 0; row < pixelRow; ++row) {
    if (!sums || sums->pixels == 0) {
      setFigure(row, column, sums ? QString(QChar(0x2013)) : QString(), {});
      continue;
    }
    const double mean = meanOf(*sums, partOf(row));
    setFigure(row, column, style::signedFigure(mean), style::figure(mean));
  }
  QString pixels;
  if (sums) pixels = QLocale(QLocale::English).toString(qulonglong(sums->pixels));
  setFigure(pixelRow, column, pixels.replace(',', QChar(0x202f)), {});
}

void ErrorTable::setSums(const QString& technique, const ErrorSums& frame,
                         const std::optional<ErrorSums>& selection) {
  technique_ = technique;
  frame_ = frame;
  selection_ = selection;
  setColumn(Frame, frame_);
  setColumn(Selection, selection_);
}

void ErrorTable::clearSums() {
  technique_.clear();
  frame_.reset();
  selection_.reset();
  setColumn(Frame, frame_);
  setColumn(Selection, selection_);
}

void ErrorTable::setFaded(bool faded) {
  for (int row = 0; row <= pixelRow; ++row)
    for (int column : {Frame, Selection})
      item(row, column)->setForeground(faded ? QColor(0xa5, 0xae, 0xb8) : style::ink);
}

void ErrorTable::setPart(std::optional<ErrorPart> part) {
  quiet_ = true;
  setCurrentCell(part ? int(*part) + 1 : 0, Title);
  quiet_ = false;
}

QString ErrorTable::asText() const {
  if (!frame_) return {};
  const auto line = [this](const QString& title, auto figure) {
    return title + "\t" + figure(*frame_) + (selection_ ? "\t" + figure(*selection_) : QString()) +
           "\n";
  };
  QString text = tr("%1: mean signed error").arg(technique_) + "\t" + tr("frame") +
                 (selection_ ? "\t" + tr("lasso") : QString()) + "\n";
  for (int row = 0; row < pixelRow; ++row)
    text += line(titleOf(partOf(row)), [row](const ErrorSums& sums) {
      return QString::number(meanOf(sums, partOf(row)), 'g', 17);
    });
  return text + line(tr("Pixels"), [](const ErrorSums& sums) {
           return QString::number(qulonglong(sums.pixels));
         });
}

void ErrorTable::copy() const {
  if (frame_) QGuiApplication::clipboard()->setText(asText());
}

// The key must be taken here, or the window's own shortcut would copy a plot.
bool ErrorTable::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
    event->accept();
  return QTableWidget::event(event);
}

void ErrorTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return copy();
  QTableWidget::keyPressEvent(event);
}

}  // namespace umbra
