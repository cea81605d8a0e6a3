// The options that mean the same for every command. They edit a Session and nothing else.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "datasets/session/Session.h"

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
  void addTo(CLI::App& command);

  // The session that the options describe, checked: the one of --session or the default, with the
  // options laid over it. Throws BadCommandLine (option), BadInput (session file, scene).
  Session session(const TechniqueCatalogue& catalogue) const;
  // The same with another base, such as the scene or file that a positional argument names.
  Session over(Session base, const TechniqueCatalogue& catalogue) const;

  // The ids of --technique in the order given, each once. `fallback` where the option is absent.
  TechniqueChoice techniques(const TechniqueCatalogue& catalogue,
                             const TechniqueChoice& fallback) const;
  bool namesSource() const { return scene_ || depth_; }
  bool namesSession() const { return session_.has_value(); }
  bool namesFormat() const { return format_.has_value(); }
  // Of any option at all.
  bool given(const CLI::App& command) const;

 private:
  using Text = std::optional<std::string>;

  void addInput(CLI::App& command);
  void addTechnique(CLI::App& command);
  void addMap(CLI::App& command);
  void addRead(CLI::App& command);
  void addView(CLI::App& command);

  void editSource(Session& session) const;
  void editTechniques(Session& session, const TechniqueCatalogue& catalogue) const;
  void editMap(Session& session) const;
  void editRead(ReadSettings& read) const;
  void editBias(Bias& bias) const;
  void editView(Session& session) const;

  Text scene_, depth_, depthRange_, session_;
  std::vector<std::string> sceneSettings_, settings_;
  Text techniques_, kernel_, radius_, sigma_;
  Text mapSize_, format_, filter_, anisotropy_, msaa_;
  Text cascades_, splitLambda_, cascadeSeam_, satSize_, satDistance_, satPrecision_;
  Text biasConstant_, biasSlope_, biasReceiverPlane_, cullFrontFaces_;
  Text light_, camera_, size_, view_;
};

// Every id of the catalogue, in its order.
std::vector<std::string> idsOf(const TechniqueCatalogue& catalogue);

}  // namespace umbra
