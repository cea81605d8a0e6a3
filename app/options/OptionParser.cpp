#include "app/options/OptionParser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// Prints what one can do first, then the options, each group under its name.
class HelpLayout final : public CLI::Formatter {
 public:
  HelpLayout() {
    column_width(38);
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
    return withSingleGaps(make_description(app) + "\n" + make_usage(app, name) + "\n" +
                          make_positionals(app) + make_subcommands(app, mode) +
                          make_groups(app, mode) + make_footer(app));
  }

 private:
  // CLI11 separates some groups by two empty lines.
  static std::string withSingleGaps(const std::string& text) {
    std::string result;
    for (char c : text)
      if (c != '\n' || !result.ends_with("\n\n")) result += c;
    return result;
  }
};

CLI::Option* described(CLI::Option* option, const OptionHelp& help) {
  if (!help.takes.empty()) option->type_name(help.takes);
  if (!help.group.empty()) option->group(std::string(help.group));
  return option;
}

// Returns the command that was asked for, or else the program itself.
const CLI::App& asked(const CLI::App& program) {
  const std::vector<CLI::App*> commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

// Explains a word that nothing takes.
std::string unexpected(const CLI::App& program) {
  const CLI::App& command = asked(program);
  std::vector<std::string> words = command.remaining(true);
  if (words.empty()) {
    // Then the word stands before the command's name.
    words = program.remaining();
    if (command.get_parent() && !words.empty())
      return words.front() + ": is not expected before `" + command.get_name() +
             "`, options go after the command's name";
  }
  const std::string word = words.empty() ? "" : words.front();
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::string nearest = nearestWord(word.substr(0, word.find('=')), known);
  std::string name = program.get_name();
  if (command.get_parent()) name += " " + command.get_name();
  return word + ": is not expected here; " +
         (nearest.empty() ? "`" + name + " --help` lists what is"
                          : "did you mean '" + nearest + "'?");
}

}  // namespace

void OptionParser::add(const std::string& names, std::optional<std::string>& value,
                       const OptionHelp& help) {
  described(app_->add_option(names, value, help.text), help);
}

void OptionParser::add(const std::string& names, std::string& value, const OptionHelp& help) {
  described(app_->add_option(names, value, help.text), help)->capture_default_str();
}

void OptionParser::addRepeatable(const std::string& names, std::vector<std::string>& values,
                                 const OptionHelp& help) {
  described(app_->add_option(names, values, help.text), help)->take_all()->expected(1);
}

void OptionParser::addFlag(const std::string& names, bool& value, const OptionHelp& help) {
  described(app_->add_flag(names, value, help.text), help);
}

void OptionParser::addArgument(const std::string& name, std::optional<std::string>& value,
                               const OptionHelp& help, const std::string& excluded) {
  CLI::Option* option = described(app_->add_option(name, value, help.text), help);
  if (!excluded.empty()) option->excludes(excluded);
}

void OptionParser::addArguments(const std::string& name, std::vector<std::string>& values,
                                const OptionHelp& help) {
  described(app_->add_option(name, values, help.text), help);
}

void OptionParser::addRequired(const std::string& name, std::string& value,
                               const OptionHelp& help) {
  app_->add_option(name, value, help.text)->required()->type_name(help.takes);
}

void OptionParser::setFooter(const std::string& text) {
  app_->footer(text);
}

OptionParser OptionParser::addCommand(const std::string& name, const std::string& text,
                                      const std::string& group) {
  CLI::App* command = app_->add_subcommand(name, text);
  if (!group.empty()) command->group(group);
  return OptionParser(*command);
}

void OptionParser::requireCommand() {
  app_->require_subcommand(1);
}

bool OptionParser::wasAsked() const {
  return app_->parsed();
}

bool OptionParser::hasOption() const {
  const std::vector<const CLI::Option*> options = std::as_const(*app_).get_options();
  return std::any_of(options.begin(), options.end(), [](const CLI::Option* option) {
    return option->count() > 0 && !option->get_positional();
  });
}

std::string OptionParser::name() const {
  return app_->get_name();
}

std::vector<std::string> OptionParser::commandNames() const {
  std::vector<std::string> names;
  for (const CLI::App* command :
       std::as_const(*app_).get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

ProgramParser::ProgramParser(const std::string& name, const std::string& description,
                             const std::string& version)
    : ProgramParser(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", name + " " + version);
  app_->set_help_flag("-h,--help", "Print this help and exit");
  app_->require_subcommand(0, 1);
  app_->formatter(std::make_shared<HelpLayout>());
}

ProgramParser::ProgramParser(std::unique_ptr<CLI::App> app)
    : OptionParser(*app), program_(std::move(app)) {}

ProgramParser::~ProgramParser() = default;

std::optional<std::string> ProgramParser::parse(int argc, char** argv,
                                                const std::function<void()>& explainWord) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    app_->exit(help, text, std::cerr);
    return text.str();
  } catch (const CLI::ExtrasError&) {
    // A mistyped command is also an argument that is not expected, and the better explanation.
    if (asked(*app_).get_parent() == nullptr) explainWord();
    throw Error(ErrorKind::BadCommandLine, unexpected(*app_));
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorKind::BadCommandLine, oneLine(error.what()));
  }
  return std::nullopt;
}

}  // namespace umbra
