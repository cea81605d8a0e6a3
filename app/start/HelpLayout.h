// How --help reads: what one can do first, then the options, each group under its name.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace umbra {

class HelpLayout final : public CLI::Formatter {
 public:
  HelpLayout();
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
};

}  // namespace umbra
