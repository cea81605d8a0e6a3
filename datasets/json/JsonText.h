// JSON as people write it, read strictly.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace umbra {

// `where` is what errors begin with: a file. Throws BadInput for what is no JSON, with the byte;
// for a number that no double holds; for more than 64 levels; for a key that one object has twice,
// of which only one could be meant.
nlohmann::ordered_json jsonFromText(std::string_view text, std::string_view where);

// The whole content. Throws BadInput where there is none to be read, or too much.
std::string textOf(const std::filesystem::path& file);

// A value as a message quotes it: at most about 80 bytes of it.
std::string quoted(const nlohmann::ordered_json& value);

}  // namespace umbra
