#include "ui/session/ImportDraft.h"

#include <utility>

#include "ui/session/RawDepthLoader.h"
#include "ui/session/SessionController.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

// Where the file's name stands above, and controls beside it, the sentence needs neither that name
// nor the command line's options.
QString withoutNameAndHint(const QString& message, const SceneSource& source) {
  QString text = message;
  const QString name = style::text(source.name) + ": ";
  if (text.startsWith(name)) text.remove(0, name.size());
  for (const std::string_view hint : {depthMissHint, channelHint})
    if (text.endsWith(style::text(hint))) text.chop(style::text(hint).size());
  return text;
}

}  // namespace

ImportDraft::ImportDraft(SessionController& controller, QObject* parent)
    : QObject(parent), controller_(controller), loader_(new RawDepthLoader(this)) {
  connect(&controller_, &SessionController::changed, this, &ImportDraft::follow);
  connect(&controller_, &SessionController::unread, this, &ImportDraft::takeRefusal);
  connect(loader_, &RawDepthLoader::loaded, this, &ImportDraft::takeRaw);
}

const SceneSource& ImportDraft::source() const {
  return asked_ ? asked_->shared.source : controller_.session().source;
}

bool ImportDraft::fileIsOpen() const {
  const SceneSource& open = controller_.session().source;
  return source().kind == open.kind && source().name == open.name;
}

void ImportDraft::change(const std::function<void(SceneSource&)>& edit) {
  // All but the source is as it is now; a file that is not open yet brings its own.
  Workspace next = asked_ && !fileIsOpen() ? *asked_ : controller_.workspace();
  next.shared.source = source();
  edit(next.shared.source);
  if (next.shared.source == source() && refusal_.isEmpty()) return;
  refusal_.clear();
  if (next.shared.source == controller_.session().source) {
    controller_.stopOpening();
    settle();
    return;
  }
  asked_ = next;
  countValues();
  const QString title = style::text(titleOf(next.shared.source));
  if (fileIsOpen())
    controller_.reread(next.shared.source, tr("Change how %1 is read").arg(title));
  else
    controller_.open(next);
  emit changed();
}

// What is shown is the session's again.
void ImportDraft::settle() {
  asked_.reset();
  refusal_.clear();
  countValues();
  emit changed();
}

void ImportDraft::follow(const Document& before, const Document& after) {
  const bool same =
      before.content == after.content && before.session.source == after.session.source;
  if (!same) settle();
}

void ImportDraft::takeRefusal(const Workspace& asked, const QString& message) {
  const SceneSource& source = asked.shared.source;
  const QString sentence = withoutNameAndHint(message, source);
  if (asked_ && asked_->shared.source == source) {
    refusal_ = sentence;
    emit refused();
    emit changed();
    return;
  }
  if (source.kind != SourceKind::DepthFile) return;
  pending_ = asked;
  pendingRefusal_ = sentence;
  loader_->load(source.name, source.depth.channel);
}

void ImportDraft::takeRaw(const std::optional<RawDepths>& raw) {
  const auto pending = std::exchange(pending_, std::nullopt);
  if (pending) {
    if (!raw) return counted_ = {}, countValues();
    asked_ = pending;
    refusal_ = pendingRefusal_;
    counted_ = {source().name, source().depth.channel};
  }
  raw_ = raw;
  emit changed();
  if (pending) emit wanted();
}

void ImportDraft::countValues() {
  const SceneSource& shown = source();
  const bool needed = watched_ && shown.kind == SourceKind::DepthFile;
  const Counted next = needed ? Counted{shown.name, shown.depth.channel} : Counted{};
  if (next == counted_) return;
  counted_ = next;
  raw_.reset();
  if (needed) loader_->load(next.file, next.channel);
}

void ImportDraft::setWatched(bool watched) {
  if (watched == watched_) return;
  watched_ = watched;
  if (!watched) {
    asked_.reset();
    refusal_.clear();
  }
  countValues();
}

}  // namespace umbra
