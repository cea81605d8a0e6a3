// The one workspace of the window and every change to it.
#pragma once

#include <QMap>
#include <QObject>
#include <QUndoGroup>
#include <QUndoStack>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/session/Document.h"

namespace umbra {

class SourceLoader;

class SessionController : public QObject {
  Q_OBJECT

 public:
  // Throws what loadSource throws.
  explicit SessionController(const Workspace& workspace, QObject* parent = nullptr,
                             TechniqueCatalogue catalogue = allTechniques());

  // What the active pane shows: all there is where nothing is compared.
  const Session& session() const { return document_.session; }
  // What panes share, and what each has of its own.
  const Workspace& workspace() const { return document_.workspace; }
  const Document& document() const { return document_; }
  const TechniqueCatalogue& catalogue() const { return catalogue_; }
  // All of the catalogue, in its order, with the session's parameters; not adapted to a map.
  const std::vector<std::shared_ptr<const Technique>>& techniques() const { return techniques_; }
  const Technique& technique() const;  // the session's
  // A sentence for each parameter of the session's technique that its format limits.
  const QStringList& notices() const { return notices_; }
  // Why techniques cannot be composed with the session's format, kernel or read, by the technique's
  // id; those that can are not listed.
  QMap<QString, QString> refusals() const;
  QMap<QString, QString> refusals(const FrameSettings& frame) const;  // with other settings
  // The history of the session that is shown: the person's own, or the visited one.
  QUndoStack& undoStack() { return visiting() ? visitUndo_ : undo_; }
  QUndoGroup& history() { return history_; }
  bool loading() const;

  // One step for undo. Edits in a row with the same `mergeKey` become one step, until `endMerge`.
  // The source must stay as it is: `open` changes it.
  // `edit` changes what the active pane shows; `editPanes` everything about panes: which ones there
  // are, their techniques, how they are laid out, and what is their own.
  void edit(const QString& text, const std::function<void(Session&)>& change,
            const QString& mergeKey = {});
  void editPanes(const QString& text, const std::function<void(Workspace&)>& change,
                 const QString& mergeKey = {});
  void endMerge() { ++mergeGroup_; }
  // Changes the session without a step for undo: for what follows from an edit, such as where the
  // first probe is put.
  void amend(const std::function<void(Session&)>& change);

  // Reads the workspace's source beside this thread; what is open stays until it is there. One step
  // for undo.
  void open(const Workspace& workspace);
  // Reads the open source in another way, or with other parameters: one step for undo, named
  // `step` where that is not empty, which keeps what else is edited in the meantime.
  void reread(const SceneSource& source, const QString& step = {});
  // Gives up what is being read for either.
  void stopOpening();
  // Opens another source with the same technique and frame settings, and with the light and camera
  // that the source brings.
  void openSource(const SceneSource& source);

  // Shows another workspace, such as a lesson's step, while the person's own waits with its
  // history. Its source is read beside this thread unless it is open already. Changes to it have a
  // history of their own, which ends with the visit or with the next one.
  void visit(const Workspace& workspace);
  // Brings the person's own session back as it was, at once. Does nothing where none waits.
  void leave();
  bool visiting() const { return own_.has_value(); }
  const Workspace& ownWorkspace() const { return own_ ? own_->workspace : document_.workspace; }

 signals:
  void changed(const umbra::Document& before, const umbra::Document& after);
  void loadingChanged(bool loading);
  void loadingProgressed(double part);  // of what is being read, from 0 to 1
  // Says to people, in one line, what could not be done and why. What was open stays open.
  void failed(const QString& message);
  // The source of a workspace that was to be opened cannot be read; `failed` has said so.
  void unread(const umbra::Workspace& asked, const QString& message);

 private:
  friend class DocumentCommand;
  // A technique with what it was made of.
  struct Made {
    std::string id;
    ParameterValues values;
    StorageFormat format;
    std::shared_ptr<const Technique> technique;
    std::vector<std::string> limited;  // a sentence for each parameter that the format limits
  };

  void push(const QString& text, Document after, const QString& mergeKey);
  void show(const Document& document);  // undo, redo and every edit end here
  void rebuildTechniques(const Session& session);
  void read(const Workspace& workspace);
  void openRead(const Document& read);
  void arrive(const Document& document);

  TechniqueCatalogue catalogue_;
  Document document_;
  std::vector<Made> made_;                                    // in the catalogue's order
  std::vector<std::shared_ptr<const Technique>> techniques_;  // of made_
  QStringList notices_;
  QUndoStack undo_, visitUndo_;
  QUndoGroup history_;
  std::optional<Document> own_;  // while another one is visited
  bool visitAsked_ = false;      // what is being read is to be visited
  bool rereadAsked_ = false;     // what is being read is the open source
  QString step_;                 // then the name of the step, or empty
  SourceLoader* loader_;
  int mergeGroup_ = 0;
};

}  // namespace umbra
