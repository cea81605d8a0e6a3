#include "ui/session/SessionController.h"

#include <QUndoCommand>
#include <exception>
#include <utility>

#include "datasets/session/DepthReading.h"
#include "filters/core/technique/Composition.h"
#include "ui/session/SourceLoader.h"
#include "ui/widgets/base/Style.h"

namespace umbra {

// One step: the documents on its two sides.
class DocumentCommand : public QUndoCommand {
 public:
  DocumentCommand(SessionController& controller, const QString& text, Document after,
                  const QString& mergeKey)
      : QUndoCommand(text),
        controller_(controller),
        before_(controller.document()),
        after_(std::move(after)),
        mergeKey_(mergeKey),
        group_(controller.mergeGroup_) {}

  void undo() override {
    controller_.endMerge();  // what follows an undo is never merged into what was undone
    controller_.show(before_);
  }
  void redo() override { controller_.show(after_); }
  int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const DocumentCommand&>(*other);
    if (next.mergeKey_ != mergeKey_ || next.group_ != group_) return false;
    after_ = next.after_;
    return true;
  }

 private:
  SessionController& controller_;
  Document before_, after_;
  QString mergeKey_;
  int group_;
};

SessionController::SessionController(const Workspace& workspace, QObject* parent,
                                     TechniqueCatalogue catalogue)
    : QObject(parent),
      catalogue_(std::move(catalogue)),
      document_{workspace, loadSource(workspace.shared.source)},
      loader_(new SourceLoader(this)) {
  rebuildTechniques(session());
  for (QUndoStack* stack : {&undo_, &visitUndo_}) {
    stack->setUndoLimit(500);
    history_.addStack(stack);
  }
  history_.setActiveStack(&undo_);
  connect(loader_, &SourceLoader::failed, this,
          [this](const Workspace& asked, const QString& message) {
            emit failed(message);
            if (!visitAsked_) emit unread(asked, message);
          });
  connect(loader_, &SourceLoader::finished, this, [this] { emit loadingChanged(false); });
  connect(loader_, &SourceLoader::progressed, this, &SessionController::loadingProgressed);
  connect(loader_, &SourceLoader::loaded, this,
          [this](const Document& loaded) { visitAsked_ ? arrive(loaded) : openRead(loaded); });
}

const Technique& SessionController::technique() const {
  for (const auto& technique : techniques_)
    if (technique->info().id == session().technique) return *technique;
  return *techniques_.front();  // never: rebuildTechniques refuses an unknown one
}

QMap<QString, QString> SessionController::refusals() const {
  return refusals(readSettingsOf(session()));
}

QMap<QString, QString> SessionController::refusals(const FrameSettings& frame) const {
  QMap<QString, QString> reasons;
  for (const auto& technique : techniques_) {
    std::string reason = whyImpossible(frame, *technique);
    if (document_.content.scene && frame.map.format == StorageFormat::Double)
      reason = "format double: the GPU stores 32 bits at most, take float";
    if (!reason.empty())
      reasons.insert(style::text(technique->info().id), QString::fromStdString(reason));
  }
  return reasons;
}

bool SessionController::loading() const {
  return loader_->busy();
}

void SessionController::edit(const QString& text, const std::function<void(Session&)>& change,
                             const QString& mergeKey) {
  editPanes(
      text, [&](Workspace& workspace) { editSession(workspace, change); }, mergeKey);
}

void SessionController::editPanes(const QString& text,
                                  const std::function<void(Workspace&)>& change,
                                  const QString& mergeKey) {
  Workspace after = workspace();
  try {
    change(after);
  } catch (const std::exception& problem) {
    emit failed(QString::fromUtf8(problem.what()));
    return;
  }
  if (after == workspace()) return;
  push(text, {std::move(after), document_.content}, mergeKey);
}

void SessionController::amend(const std::function<void(Session&)>& change) {
  Workspace after = workspace();
  editSession(after, change);
  if (!(after == workspace())) show({std::move(after), document_.content});
}

void SessionController::push(const QString& text, Document after, const QString& mergeKey) {
  try {
    rebuildTechniques(after.session);  // refuses what is wrong before it becomes a step
    undoStack().push(new DocumentCommand(*this, text, std::move(after), mergeKey));
  } catch (const std::exception& problem) {
    rebuildTechniques(session());
    emit failed(QString::fromUtf8(problem.what()));
  }
}

void SessionController::show(const Document& document) {
  const Document before = document_;
  document_ = document;
  rebuildTechniques(document_.session);
  emit changed(before, document_);
}

// An instance stays while its technique's parameters and format stay, so that what was found out
// about it holds.
void SessionController::rebuildTechniques(const Session& session) {
  if (!catalogue_.has(session.technique)) catalogue_.make(session.technique);  // throws
  std::vector<Made> made;
  std::vector<std::shared_ptr<const Technique>> techniques;
  QStringList notices;
  for (const Technique* technique : catalogue_.all()) {
    const std::string id(technique->info().id);
    Made next{id, parametersOf(session, id), session.frame.map.format, {}, {}};
    for (const Made& known : made_)
      if (known.id == id && known.values == next.values && known.format == next.format)
        next = known;
    if (!next.technique) next.technique = techniqueOf(session, catalogue_, id, &next.limited);
    if (id == session.technique) {
      for (const std::string& notice : next.limited) notices << QString::fromStdString(notice);
      if (const std::string loss = whyReadInexactly(session, *next.technique); !loss.empty())
        notices << QString::fromStdString(loss);
    }
    techniques.push_back(next.technique);
    made.push_back(std::move(next));
  }
  made_ = std::move(made);
  techniques_ = std::move(techniques);
  notices_ = notices;
}

void SessionController::open(const Workspace& workspace) {
  visitAsked_ = rereadAsked_ = false;
  step_.clear();
  read(workspace);
}

void SessionController::reread(const SceneSource& source, const QString& step) {
  Workspace next = workspace();
  next.shared.source = source;
  visitAsked_ = false;
  rereadAsked_ = true;
  step_ = step;
  read(next);
}

void SessionController::read(const Workspace& workspace) {
  loader_->load(workspace);
  emit loadingChanged(true);
}

void SessionController::openRead(const Document& read) {
  Workspace next = read.workspace;
  const SceneSource &source = next.shared.source, &open = session().source;
  if (rereadAsked_) {
    if (source.kind != open.kind || source.name != open.name) return;  // undone in the meantime
    Workspace now = workspace();
    now.shared.source = source;
    next = std::move(now);
  }
  const QString opened = tr("Open %1").arg(QString::fromStdString(titleOf(next.shared.source)));
  endMerge();
  push(step_.isEmpty() ? opened : step_, {next, read.content}, {});
}

void SessionController::stopOpening() {
  if (!visitAsked_) loader_->drop();
}

void SessionController::visit(const Workspace& workspace) {
  if (workspace.shared.source == session().source) {
    loader_->drop();
    return arrive({workspace, document_.content});
  }
  visitAsked_ = true;
  read(workspace);
}

void SessionController::arrive(const Document& document) {
  try {
    rebuildTechniques(document.session);  // refuses what is wrong while all is as it was
  } catch (const std::exception& problem) {
    rebuildTechniques(session());
    emit failed(QString::fromUtf8(problem.what()));
    return;
  }
  if (!own_) own_ = document_;
  visitUndo_.clear();
  history_.setActiveStack(&visitUndo_);
  endMerge();
  show(document);
}

void SessionController::leave() {
  loader_->drop();
  if (!own_) return;
  const Document own = *std::exchange(own_, std::nullopt);
  visitUndo_.clear();
  history_.setActiveStack(&undo_);
  endMerge();
  show(own);
}

void SessionController::openSource(const SceneSource& source) {
  Session next = session();
  next.source = source;
  chooseFormatFor(next);
  next.light.reset();
  next.camera.reset();
  next.probe.reset();
  next.probes.clear();  // places of the source that was
  next.keptProbe.clear();
  next.receiver.reset();
  Workspace opened = workspace();
  setSession(opened, next);
  open(opened);
}

}  // namespace umbra
