#include "datasets/json/JsonText.h"

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {

using Json = nlohmann::ordered_json;

namespace {

// Levels of objects and lists that any of our files needs are ten; a reader of thousands would need
// as many levels of calls.
constexpr std::size_t deepest = 64;

// Follows a parser into its objects and lists.
class Keys {
 public:
  explicit Keys(std::string_view where) : where_(where) {}

  void follow(Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::object_end || event == Event::array_end) return open_.pop_back();
    if (event == Event::key) return add(parsed.get<std::string>());
    if (!open_.empty() && open_.back().list) ++open_.back().count;  // an element, or its start
    if (event == Event::value) return;
    if (open_.size() == deepest)
      throw Error(ErrorKind::BadInput, std::string(where_) + ": is nested more than " +
                                           std::to_string(deepest) + " levels deep");
    open_.push_back({event == Event::array_start, 0, {}, {}});
  }

 private:
  struct Level {
    bool list = false;      // else an object
    std::size_t count = 0;  // of a list's elements up to the one that the parser is at
    std::set<std::string> keys;
    std::string last;
  };

  void add(const std::string& key) {
    open_.back().last = key;
    if (open_.back().keys.insert(key).second) return;
    throw Error(ErrorKind::BadInput,
                std::string(where_) + ": " + path() + ": is there twice, one has to go");
  }

  // "probes[2].name": lists count from 1.
  std::string path() const {
    std::string path;
    for (const Level& level : open_)
      path += level.list ? "[" + std::to_string(level.count) + "]"
                         : (path.empty() ? "" : ".") + clipped(level.last);
    return path;
  }

  std::string_view where_;
  std::vector<Level> open_;  // those that the parser is in, outermost first
};

}  // namespace

Json jsonFromText(std::string_view text, std::string_view where) {
  Keys keys(where);
  try {
    return Json::parse(text, [&](int, Json::parse_event_t event, Json& parsed) {
      keys.follow(event, parsed);
      return true;
    });
  } catch (const Json::parse_error& error) {
    throw Error(ErrorKind::BadInput, std::string(where) +
                                         ": is not JSON, it breaks off or errs at byte " +
                                         std::to_string(error.byte));
  } catch (const Json::exception& error) {
    // "[json.exception.out_of_range.406] number overflow parsing '1e400'"
    const std::string what = error.what();
    throw Error(ErrorKind::BadInput,
                std::string(where) + ": cannot be read: " + what.substr(what.find(' ') + 1));
  }
}

std::string textOf(const std::filesystem::path& file) {
  return contentOf(file, largestJson);
}

std::string quoted(const Json& value) {
  return clipped(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace umbra
