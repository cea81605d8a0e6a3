// Reads the options of a command into variables. It hides the parsing library, so that the files of
// the commands compile quickly.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace umbra {

// Says how an option is shown in the help.
struct OptionHelp {
  std::string_view group;  // its heading; "" for the usual one
  std::string takes;       // "N"; "" where nothing is to be said
  std::string text;        // one sentence, without a full stop
};

// A parser stands for a command or for the program itself. Variables must outlive the parsing.
class OptionParser {
 public:
  // Names are such as "--bins", or "-o,--output".
  void add(const std::string& names, std::optional<std::string>& value, const OptionHelp& help);
  // Its help tells the value that stands in the variable as the default.
  void add(const std::string& names, std::string& value, const OptionHelp& help);
  void addRepeatable(const std::string& names, std::vector<std::string>& values,
                     const OptionHelp& help);
  void addFlag(const std::string& names, bool& value, const OptionHelp& help);
  // An argument has no name on the command line. It cannot be given together with the option
  // `excluded`.
  void addArgument(const std::string& name, std::optional<std::string>& value,
                   const OptionHelp& help, const std::string& excluded = {});
  // Takes any number of them.
  void addArguments(const std::string& name, std::vector<std::string>& values,
                    const OptionHelp& help);
  void addRequired(const std::string& name, std::string& value, const OptionHelp& help);

  // The help ends with this text.
  void setFooter(const std::string& text);
  // Adds a command below this one.
  OptionParser addCommand(const std::string& name, const std::string& text,
                          const std::string& group = {});
  void requireCommand();

  // These tell what was found, after the parsing.
  bool wasAsked() const;
  bool hasOption() const;  // any at all, arguments aside
  std::string name() const;
  std::vector<std::string> commandNames() const;

 protected:
  explicit OptionParser(CLI::App& app) : app_(&app) {}

  CLI::App* app_;
};

// The program itself, which runs at most one command.
class ProgramParser : public OptionParser {
 public:
  ProgramParser(const std::string& name, const std::string& description,
                const std::string& version);
  ~ProgramParser();
  ProgramParser(const ProgramParser&) = delete;
  ProgramParser& operator=(const ProgramParser&) = delete;

  // Returns the text of the help or version if that was asked for; nothing else is to be done then.
  // Throws BadCommandLine. If a word is unexpected and no command was asked for, `explainWord` is
  // called first and may throw a better explanation.
  std::optional<std::string> parse(int argc, char** argv, const std::function<void()>& explainWord);

 private:
  explicit ProgramParser(std::unique_ptr<CLI::App> app);

  std::unique_ptr<CLI::App> program_;
};

}  // namespace umbra
