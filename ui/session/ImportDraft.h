// How the open file is read, or one that could not be read as it was asked for: what is chosen
// becomes the session's as soon as the reading works.
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "datasets/maps/RawDepths.h"
#include "datasets/session/Workspace.h"

namespace umbra {

class RawDepthLoader;
class SessionController;
struct Document;

class ImportDraft : public QObject {
  Q_OBJECT

 public:
  explicit ImportDraft(SessionController& controller, QObject* parent = nullptr);

  // The source as it was chosen last, whether or not it could be read.
  const SceneSource& source() const;
  // Whether its file is the one that is open.
  bool fileIsOpen() const;
  // Why the source cannot be read, without the file's name and the command line's options; empty
  // where it can, or is being read.
  const QString& refusal() const { return refusal_; }
  // What the depth file holds. None of it while nobody watches, nor while it is being counted.
  const std::optional<RawDepths>& raw() const { return raw_; }

  // One step for undo, once it is read.
  void change(const std::function<void(SceneSource&)>& edit);

  // While somebody watches, the file's values are counted. What nobody watches and could not be
  // read is forgotten.
  void setWatched(bool watched);

 signals:
  void changed();
  // A refusal is told here: `wanted` where nobody may be watching, since a file was refused that a
  // choice can make readable.
  void refused();
  void wanted();

 private:
  // Which values are counted.
  struct Counted {
    std::string file, channel;
    bool operator==(const Counted&) const = default;
  };

  void follow(const Document& before, const Document& after);
  void takeRefusal(const Workspace& asked, const QString& message);
  void takeRaw(const std::optional<RawDepths>& raw);
  void countValues();
  void settle();

  SessionController& controller_;
  RawDepthLoader* loader_;
  bool watched_ = false;
  std::optional<Workspace> asked_;  // where its source is not the session's
  QString refusal_;                 // of asked_
  std::optional<RawDepths> raw_;
  Counted counted_;  // raw_, or what will become it
  // A refused file until its values show whether it can be read at all.
  std::optional<Workspace> pending_;
  QString pendingRefusal_;
};

}  // namespace umbra
