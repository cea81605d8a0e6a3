#include "ui/probe/SavedProbes.h"

#include <algorithm>
#include <exception>

#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

constexpr int restsAfter = 80;  // ms

QString reasonOf(NotRead why) {
  switch (why) {
    case NotRead::NoSurface:
      return SavedProbes::tr("no surface is there");
    case NotRead::OutsideMap:
      return SavedProbes::tr("outside the shadow map");
    case NotRead::NotInSight:
      break;
  }
  return SavedProbes::tr("not in sight");
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

}  // namespace

SavedProbes::SavedProbes(SessionController& controller, SceneView& view, Prober& prober,
                         QObject* parent)
    : QObject(parent), controller_(controller), view_(view), prober_(prober) {
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, &SavedProbes::readNext);
  connect(&view_, &SceneView::frameDrawn, this, &SavedProbes::start);
  connect(&controller_, &SessionController::changed, this, &SavedProbes::sessionChanged);
  sessionChanged({}, controller_.document());
}

// Rows keep what was read of them under whatever name and in whatever place.
void SavedProbes::sessionChanged(const Document& before, const Document& after) {
  const std::vector<NamedProbe>& probes = after.session.probes;
  std::vector<Row> rows;
  std::vector<std::optional<HeldPoint>> held;
  for (const NamedProbe& probe : probes) {
    const auto same = std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) {
      NamedProbe renamed = row.probe;
      renamed.name = probe.name;
      return renamed == probe;
    });
    const bool known = same != rows_.end();
    rows.push_back(known ? *same : Row{});
    rows.back().probe = probe;
    held.push_back(known         ? held_[std::size_t(same - rows_.begin())]
                   : probe.point ? std::optional(HeldPoint(*probe.point))
                                 : std::nullopt);
  }
  const Session &old = before.session, &now = after.session;
  const bool sameRows = std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                                   [](const Row& a, const Row& b) { return a.probe == b.probe; });
  rows_ = std::move(rows);
  held_ = std::move(held);
  // What else they depend on, such as the light, makes another frame.
  if (!sameRows || !(before.content == after.content) || !(old.frame == now.frame) ||
      !(old.parameters == now.parameters))
    start();
  emit changed();
}

void SavedProbes::start() {
  next_ = 0;
  if (rows_.empty()) return rest_.stop();
  rest_.start(restsAfter);
}

void SavedProbes::readNext() {
  const bool onScene = controller_.document().content.scene != nullptr;
  if (onScene && !view_.upToDate()) return;  // the frame that follows starts again
  if (next_ >= rows_.size()) return;
  read(next_++);
  if (next_ < rows_.size()) rest_.start(0);
  emit changed();
}

void SavedProbes::read(std::size_t index) {
  Row& row = rows_[index];
  const Document& document = controller_.document();
  row.figures.reset();
  row.reason.clear();
  row.hidden = false;
  try {
    if (document.content.depth) {
      const auto report =
          row.probe.texel ? prober_.taker().at(*row.probe.texel, row.probe.receiver) : std::nullopt;
      if (report)
        row.figures = figuresOf(report->probe);
      else
        row.reason = tr("outside the depth map");
      return;
    }
    if (!held_[index]) return void(row.reason = reasonOf(NotRead::NoSurface));
    const auto found = held_[index]->find(view_, document);
    if (const auto* why = std::get_if<NotRead>(&found)) return void(row.reason = reasonOf(*why));
    const auto& place = std::get<SurfacePlace>(found);
    row.hidden = !place.inSight;
    row.figures = figuresOf(prober_.taker().at(place, row.probe.receiver).probe);
  } catch (const std::exception& problem) {
    row.reason = QString::fromUtf8(problem.what());
  }
}

std::vector<ProbeMark> SavedProbes::marks() const {
  std::vector<ProbeMark> marks;
  int number = 0;
  for (const Row& row : rows_)
    if (++number; row.probe.point && number - 1 != current())
      marks.push_back({number, style::text(row.probe.name), *row.probe.point, row.hidden});
  return marks;
}

int SavedProbes::current() const {
  const Session& session = controller_.session();
  if (!session.probe) return -1;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].probe.name == session.keptProbe) return int(i);
  return -1;
}

bool SavedProbes::canSave() const {
  if (!prober_.behindVeil()) return false;
  const int at = current();
  return at < 0 || rows_[std::size_t(at)].probe.receiver != controller_.session().receiver;
}

// By what it lies on, where that has a name.
QString SavedProbes::wishedName() const {
  const auto& report = prober_.behindVeil();
  const Document& document = controller_.document();
  const std::string object =
      report->point ? HeldPoint(*report->point).objectName(document) : std::string();
  const std::vector<NamedProbe>& probes = document.session.probes;
  if (whyNotProbeName({}, object).empty())
    return style::text(freeProbeName(probes, capitalised(object)));
  return style::text(freeProbeName(probes, "Probe " + std::to_string(probes.size() + 1)));
}

void SavedProbes::save() {
  const auto& report = prober_.behindVeil();
  if (!canSave()) return;
  controller_.edit(tr("Save probe"), [&](Session& session) {
    NamedProbe probe;
    probe.name = wishedName().toStdString();
    probe.receiver = session.receiver;
    // Held where it was pinned: the pixel's own surface may be a little beside it by now.
    const auto pinned = prober_.pinnedPoint();
    if (report->point)
      probe.point = pinned ? *pinned : *report->point;
    else
      probe.texel = report->pixel;
    // What is saved no longer follows the pointer.
    if (!session.probe) prober_.place(session, report->pixel);
    saveProbe(session, std::move(probe));
  });
  if (current() >= 0)
    emit message(tr("Saved as “%1”: it has a row in the table of probes")
                     .arg(style::text(controller_.session().keptProbe)));
  prober_.refresh();
}

void SavedProbes::rename(int row, const QString& name) {
  const std::string from = rows_.at(std::size_t(row)).probe.name;
  controller_.edit(tr("Rename probe"), [&](Session& session) {
    renameProbe(session, from, name.trimmed().toStdString());
  });
}

void SavedProbes::drop(int row) {
  const std::string name = rows_.at(std::size_t(row)).probe.name;
  controller_.edit(tr("Delete probe"), [&](Session& session) { dropProbe(session, name); });
}

void SavedProbes::goTo(int row) {
  const NamedProbe probe = rows_.at(std::size_t(row)).probe;
  if (row == current()) return;
  prober_.settlePixel();
  const QSize size = view_.pixels();
  controller_.edit(tr("Go to probe"), [&](Session& session) {
    // A point out of the picture has no pixel: the middle's stands for it.
    const Pixel middle{size.width() / 2, size.height() / 2};
    prober_.place(session,
                  probe.texel ? *probe.texel : view_.pixelOf(*probe.point).value_or(middle));
    session.keptProbe = probe.name;
    session.receiver = probe.receiver;
  });
  prober_.refresh();
}

QString SavedProbes::text(char separator) const {
  std::vector<SheetRow> rows;
  for (const Row& row : rows_) {
    SheetRow& sheet = rows.emplace_back();
    sheet.name = row.probe.name;
    if (const auto& point = row.probe.point) sheet.place = {point->x(), point->y(), point->z()};
    if (row.probe.texel) {
      const Pixel texel = texelInFile(controller_.document().content, *row.probe.texel);
      sheet.place = {double(texel.x), double(texel.y)};
    }
    sheet.figures = row.figures;
    sheet.reason = row.reason.toStdString();
  }
  std::vector<std::string> techniques;
  for (const auto& technique : controller_.techniques())
    techniques.emplace_back(technique->info().id);
  return style::text(sheetText(rows, techniques, separator));
}

}  // namespace umbra
