// The options that mean the same for every command. They edit a Workspace and nothing else.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/options/OptionParser.h"
#include "app/options/SceneSources.h"
#include "datasets/session/Workspace.h"
#include "filters/core/settings/Setting.h"

namespace umbra {

struct TechniqueChoice {
  std::vector<std::string> ids;
  bool all = false;  // of the catalogue, as opposed to named one by one
};

// Every technique there is.
TechniqueChoice everyTechnique(const TechniqueCatalogue& catalogue);

class SessionOptions {
 public:
  SessionOptions() = default;
  SessionOptions(const SessionOptions&) = delete;
  SessionOptions& operator=(const SessionOptions&) = delete;

  // Adds the options to `command`; the object must outlive the parsing.
  void addTo(OptionParser& command);

  // What the options describe, checked: the workspace of --session or the default, with the options
  // laid over its active pane. Throws BadCommandLine (option), BadInput (session file, scene).
  Workspace workspace(const TechniqueCatalogue& catalogue) const;
  // The same with another base, such as the scene or file that a positional argument names.
  Workspace over(Workspace base, const TechniqueCatalogue& catalogue) const;
  // What the active pane of workspace() shows.
  Session session(const TechniqueCatalogue& catalogue) const;

  // The ids of --technique in the order given, each once. `fallback` where the option is absent.
  TechniqueChoice techniques(const TechniqueCatalogue& catalogue,
                             const TechniqueChoice& fallback) const;
  // The scene of a source, which is read once even where an option needed it before the command.
  std::shared_ptr<const Scene> scene(const SceneSource& source) const {
    return scenes_.scene(source);
  }
  bool namesTechniques() const { return techniques_.has_value(); }
  bool namesSource() const { return scene_ || depth_; }
  bool namesSession() const { return session_.has_value(); }
  bool namesFormat() const;

 private:
  using Text = std::optional<std::string>;

  // An option that sets one row of the tables of settings.
  struct OfTable {
    SettingInfo info;
    Text text;
  };

  void addInput(OptionParser& command);
  void addTechnique(OptionParser& command);
  void addView(OptionParser& command);
  // Adds the options of the tables' rows under that heading.
  void addSettings(OptionParser& command, std::string_view group);

  void editSource(Session& session) const;
  void editDepth(SceneSource& source) const;
  void editTechnique(Workspace& workspace, const TechniqueCatalogue& catalogue) const;
  void editParameters(Session& session, const TechniqueCatalogue& catalogue) const;
  void editView(Session& session) const;
  // Sets what the tables' options say. `light` and `camera` are the scene's.
  void editSettings(Session& session, const Light& light, const Camera& camera) const;
  std::string optionOfScene() const;

  Text scene_, up_, depth_, depthRange_, depthProjection_, depthMiss_, session_;
  std::vector<std::string> sceneSettings_, settings_;
  Text techniques_, light_, camera_;
  mutable SceneLoader scenes_;  // what was read stays, nothing else changes
  std::deque<OfTable> table_;   // its elements stay where they are while it grows
};

// Every id of the catalogue, in its order.
std::vector<std::string> idsOf(const TechniqueCatalogue& catalogue);

}  // namespace umbra
