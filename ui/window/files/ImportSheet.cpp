#include "ui/window/files/ImportSheet.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "ui/session/ImportDraft.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/ElidedLabel.h"
#include "ui/widgets/base/Style.h"
#include "ui/widgets/forms/DepthImportForm.h"
#include "ui/widgets/plots/PlotPane.h"
#include "ui/window/files/RawDepthPlot.h"

namespace umbra {
namespace {

constexpr int sheetWidth = 410, plotHeight = 200, roomAround = 60;  // logical pixels

QLabel* wrappedLine(const QColor& colour, const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);  // a file's name may look like markup
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QPalette palette = label->palette();
  palette.setColor(QPalette::WindowText, colour);
  label->setPalette(palette);
  return label;
}

QLabel* boldLine(QLabel* label) {
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  return label;
}

}  // namespace

ImportSheet::ImportSheet(QWidget& window, SessionController& controller)
    : QDialog(&window),
      controller_(controller),
      draft_(new ImportDraft(controller, this)),
      name_(new ElidedLabel),
      size_(wrappedLine(style::muted, "size")),
      problem_(wrappedLine(style::error, "problem")),
      notes_(wrappedLine(style::ink, "notes")),
      guessTitle_(new QLabel(tr("Guesses from the values"))),
      depthPart_(makeDepthPart()),
      meshPart_(makeMeshPart()) {
  setObjectName("importSheet");
  setWindowTitle(tr("How the file is read"));
  boldLine(name_);
  auto* content = new QWidget;
  auto* lines = new QVBoxLayout(content);
  lines->setContentsMargins(14, 12, 14, 12);
  lines->setSpacing(8);
  for (QWidget* part :
       {static_cast<QWidget*>(name_), static_cast<QWidget*>(size_), static_cast<QWidget*>(problem_),
        depthPart_, meshPart_, static_cast<QWidget*>(notes_)})
    lines->addWidget(part);
  lines->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  // Return takes what stands in a field; it must not close the sheet as well.
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 8);
  all->addWidget(scroll, 1);
  buttons->setContentsMargins(0, 0, 14, 0);
  all->addWidget(buttons);

  connect(draft_, &ImportDraft::changed, this, &ImportSheet::refresh);
  connect(draft_, &ImportDraft::refused, this, &ImportSheet::refused);
  connect(draft_, &ImportDraft::wanted, this, [this] {
    showSheet();
    emit refused();
  });
  refresh();
}

QWidget* ImportSheet::makeDepthPart() {
  plot_ = new PlotPane;
  form_ = new DepthImportForm;
  guesses_ = new QVBoxLayout;
  auto* part = new QWidget;
  auto* lines = new QVBoxLayout(part);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(8);
  plot_->setFixedHeight(plotHeight);
  // Guesses follow the refusal that they may settle, in sight also in a low window.
  lines->addWidget(boldLine(guessTitle_));
  lines->addLayout(guesses_);
  lines->addWidget(plot_);
  lines->addWidget(form_);
  connect(form_, &DepthImportForm::edited, this, &ImportSheet::take);
  return part;
}

QWidget* ImportSheet::makeMeshPart() {
  up_ = new QComboBox;
  up_->setObjectName("up");
  up_->addItem(tr("y, as most programs write it"), int(UpAxis::Y));
  up_->addItem(tr("z, as CAD and map programs write it"), int(UpAxis::Z));
  auto* part = new QWidget;
  auto* rows = new QFormLayout(part);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  rows->addRow(tr("Up in the file is"), up_);
  connect(up_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    draft_->change([this](SceneSource& source) { source.up = UpAxis(up_->currentData().toInt()); });
  });
  return part;
}

bool ImportSheet::available() const {
  return controller_.session().source.kind != SourceKind::Catalogue;
}

// Over the controls at the window's left edge, so that the picture stays in sight.
void ImportSheet::showSheet() {
  if (isHidden()) {
    const QWidget& window = *parentWidget();
    const int height = std::clamp(window.height() - 2 * roomAround, 240, 800);
    const bool isMesh = draft_->source().kind == SourceKind::MeshFile;
    resize(sheetWidth, isMesh ? 240 : height);
    move(window.mapToGlobal(QPoint(8, roomAround)));
  }
  show();
  raise();
  activateWindow();
}

void ImportSheet::showEvent(QShowEvent* event) {
  draft_->setWatched(true);
  refresh();
  QDialog::showEvent(event);
}

// What was chosen and could not be read is put away with the sheet.
void ImportSheet::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  shown_.reset();
  formProblem_.clear();
  draft_->setWatched(false);
}

void ImportSheet::refresh() {
  const SceneSource& source = draft_->source();
  if (source.kind == SourceKind::Catalogue) return void(close());
  depthPart_->setVisible(source.kind == SourceKind::DepthFile);
  meshPart_->setVisible(source.kind == SourceKind::MeshFile);
  showFile();
  if (source.kind == SourceKind::DepthFile)
    showDepth();
  else
    up_->setCurrentIndex(up_->findData(int(source.up)));
  showProblem(formProblem_.isEmpty() ? draft_->refusal() : formProblem_);
  showNotes();
}

void ImportSheet::showFile() {
  name_->setText(style::text(titleOf(draft_->source())));
  name_->setToolTip(style::plainTip(style::text(draft_->source().name)));
  QString size;
  const auto& raw = draft_->raw();
  if (raw && !raw->counts.empty()) {
    const RasterInfo& info = raw->info;
    size = tr("%1 × %2 texels, %3")
               .arg(info.width)
               .arg(info.height)
               .arg(style::text(nameOf(info.number)));
    const auto all = std::size_t(info.width) * std::size_t(info.height);
    const std::size_t plotted =
        std::accumulate(raw->counts.begin(), raw->counts.end(), std::size_t(0));
    if (info.originX != 0 || info.originY != 0)
      size += tr(", counted from %1, %2").arg(info.originX).arg(info.originY);
    if (plotted < all) size += tr(" · %1 not in the plot").arg(qulonglong(all - plotted));
  }
  if (!draft_->fileIsOpen()) size += size.isEmpty() ? tr("not open yet") : tr(" · not open yet");
  size_->setText(size);
  size_->setVisible(!size.isEmpty());
}

void ImportSheet::showProblem(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
}

void ImportSheet::showDepth() {
  const DepthImport& import = draft_->source().depth;
  const auto& raw = draft_->raw();
  QStringList channels;
  if (raw)
    for (const std::string& channel : raw->channels) channels << style::text(channel);
  form_->setChannels(channels);
  if (shown_ != import) {
    formProblem_.clear();
    form_->setImport(import);
  }
  shown_ = import;
  if (!raw)
    plot_->clear(tr("The values are being counted."));
  else if (raw->counts.empty())
    plot_->clear(tr("Choose the channel that holds the depths."));
  else if (raw->finite == 0)
    plot_->clear(tr("No value is a finite number."));
  else
    plot_->setPlot(rawDepthPlot(*raw, import));
  showGuesses();
}

// A guess that asks for planes is put away while somebody gives them.
void ImportSheet::showGuesses() {
  while (QLayoutItem* item = guesses_->takeAt(0)) {
    item->widget()->deleteLater();
    item->widget()->hide();
    delete item;
  }
  const auto& raw = draft_->raw();
  const bool counted = raw && !raw->counts.empty();
  const auto said = form_->import();
  const auto found =
      counted ? depthGuesses(*raw, draft_->source().depth) : std::vector<DepthGuess>{};
  for (const DepthGuess& guess : found) {
    if (guess.needsPlanes && !said) continue;
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    QLabel* reason = wrappedLine(style::ink, "reason");
    reason->setText(style::text(guess.reason));
    auto* button = new QPushButton(style::text(guess.action));
    button->setAutoDefault(false);
    button->setStyleSheet("padding: 3px 8px");
    line->addWidget(reason, 1);
    line->addWidget(button);
    guesses_->addWidget(row);
    connect(button, &QPushButton::clicked, this, [this, guess] { apply(guess); });
  }
  guessTitle_->setVisible(guesses_->count() > 0);
}

void ImportSheet::showNotes() {
  QStringList notes;
  const QString name = style::text(draft_->source().name) + ": ";
  if (draft_->fileIsOpen() && draft_->refusal().isEmpty())
    for (const std::string& notice : controller_.document().content.notices) {
      QString note = style::text(notice);
      if (note.startsWith(name)) note.remove(0, name.size());
      notes << note;
    }
  notes_->setText(notes.join("\n"));
  notes_->setVisible(!notes.isEmpty());
}

// What is not complete is not read; the sheet says what is missing.
void ImportSheet::take() {
  const auto import = form_->import(&formProblem_);
  if (!import) return refresh();
  shown_ = *import;
  draft_->change([&](SceneSource& source) { source.depth = *import; });
  refresh();
}

void ImportSheet::apply(const DepthGuess& guess) {
  form_->setImport(guess.import);
  take();
  if (guess.needsPlanes) form_->askForPlanes();
}

}  // namespace umbra
