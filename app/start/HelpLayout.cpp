#include "app/start/HelpLayout.h"

namespace umbra {
namespace {

// CLI11 separates some groups by two empty lines.
std::string withSingleGaps(const std::string& text) {
  std::string result;
  for (char c : text)
    if (c != '\n' || !result.ends_with("\n\n")) result += c;
  return result;
}

}  // namespace

HelpLayout::HelpLayout() {
  column_width(38);
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpLayout::make_help(const CLI::App* app, std::string name,
                                  CLI::AppFormatMode mode) const {
  if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
  return withSingleGaps(make_description(app) + "\n" + make_usage(app, name) + "\n" +
                        make_positionals(app) + make_subcommands(app, mode) +
                        make_groups(app, mode) + make_footer(app));
}

}  // namespace umbra
