// Each setting is declared once, as a row of a table. Its option and help, its key in a session's
// file, the file's schema, its row in a form, a pane's label, an attribute of an EXR file, the axis
// of a sweep and the stage that a change makes stale are all derived from that row.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "filters/core/settings/Stage.h"
#include "filters/core/support/Parameters.h"

namespace umbra {

enum class SettingKind {
  Switch,  // bool
  Whole,   // int
  Number,  // double
  Choice,  // std::string, one of SettingInfo::choices
  Point,   // three doubles
  Size,    // two whole doubles, width and height
  Camera,  // position, target, up and view angle, ten doubles; or none at all
};

using SettingValue = std::variant<bool, int, double, std::string, std::vector<double>>;

// A pane has each of these groups of settings either for itself or in common with other panes.
enum class PaneSetting { Parameters, Kernel, Read, Format, MapSize, Samples, Cascades, Bias };
inline constexpr PaneSetting paneSettings[] = {
    PaneSetting::Parameters, PaneSetting::Kernel,  PaneSetting::Read,     PaneSetting::Format,
    PaneSetting::MapSize,    PaneSetting::Samples, PaneSetting::Cascades, PaneSetting::Bias};

// The columns of a row that are the same whatever type the setting has. A row leaves out the
// columns that do not concern it.
struct SettingInfo {
  std::string_view name;    // "bias.receiver-plane": in lists, and as the axis of a sweep
  std::string_view key;     // "frame.bias.receiverPlane": where the session's file has it
  std::string_view option;  // "--bias-receiver-plane"; rows that share one are set by it together
  std::string_view takes;   // what the option's help says that it takes: "N", "on|off"
  std::string_view group;   // heading in the help
  std::string_view title;   // what a form writes beside it: "Receiver-plane bias"
  std::string_view noun;    // within a sentence: "receiver plane"
  std::string_view symbol, unit;
  double low = 0.0, high = 1.0;  // inclusive; of a list, for every number in it
  std::span<const int> values;   // the only ones of a whole number, ascending; any where empty
  // Says what 0 stands for where the program then chooses the value: "half the radius". 0 is then
  // legal even if `low` is above it.
  std::string_view automatic;
  std::span<const std::string_view> choices;
  std::string_view doc;  // one line

  // These columns shape the row of a form.
  Scale scale = Scale::Linear;
  double reach = 0.0;              // where its slider ends, if before `high`, which its box takes
  std::span<const int> offered;    // whole numbers that it lets one choose from
  std::string_view offeredAs;      // how it writes them, # for the number: "×#"
  std::size_t offeredChoices = 0;  // the first so many, where it leaves the others out
  std::span<const std::string_view> choiceTitles;
  bool greyedWhenIdle = false;  // stays to be seen where it does nothing

  // A pane says with these texts what it differs in. A switch has one for off and one for on, a
  // choice has one for each value, and a number has a single text in which # stands for it. A text
  // that begins with a blank continues the text of the row before.
  std::span<const std::string_view> labels;
  std::optional<PaneSetting> pane;  // what a pane has of its own with it, where it can

  Stage stage = Stage::Depth;  // the first that it makes stale
  SettingKind kind = SettingKind::Number;
};

// Says what the setting takes, for messages: "a whole number from 0 to 64", "1, 2, 4 or 8".
std::string rightValues(const SettingInfo& info);
// The same for lists and help: "0 to 64 texels", "none, box, gaussian". It is empty where the kind
// of setting says everything.
std::string rangeText(const SettingInfo& info);
// Writes a default as "3", or as "0: half the radius".
std::string defaultText(const SettingInfo& info, const SettingValue& value);

// Writes a value as the command line takes it: "on", "0.5", "1,2,3", "1280x720".
std::string toText(const SettingInfo& info, const SettingValue& value);

// Returns the value, in the type of the setting's kind, if it is right. Otherwise this throws
// BadInput with "WHERE: FOUND is not right, it takes …", which is the same sentence wherever the
// value comes from. `found` is the value as it was written there.
SettingValue checked(const SettingInfo& info, const SettingValue& value, std::string_view where,
                     std::string_view found);
// Does the same for a text that is written as on the command line.
SettingValue checkedText(const SettingInfo& info, std::string_view text, std::string_view where);
[[noreturn]] void refuseSetting(const SettingInfo& info, std::string_view where,
                                std::string_view found);

// One row of the table for structure P.
template <class P>
struct SettingRow {
  SettingInfo info;
  SettingValue (*get)(const P& values, const SettingInfo& info);
  // Stores a value that `checked` has returned.
  void (*put)(P& values, const SettingInfo& info, const SettingValue& value);
  // Says why the setting does nothing while the others are as in `values`; "" if it does something.
  std::string_view (*whyIdle)(const P& values) = nullptr;
  // Finds the first stage that a change from `before` to `after` makes stale, where other settings
  // bear on that. A row without this function always uses `info.stage`.
  Stage (*staleBy)(const P& before, const P& after) = nullptr;

  SettingValue valueIn(const P& values) const { return get(values, info); }
  SettingValue defaultValue() const {
    static const P defaults;
    return valueIn(defaults);
  }
  bool idleIn(const P& values) const { return whyIdle && !whyIdle(values).empty(); }
  void putInto(P& values, const SettingValue& value) const { put(values, info, value); }
};

// A row that is bound to values, and does not show their type.
struct Setting {
  SettingInfo info;
  SettingValue defaultValue;
  std::function<SettingValue()> get;
  std::function<void(const SettingValue&)> put;  // stores what `checked` returned
  std::function<std::string_view()> whyIdle;     // as SettingRow's

  std::string text() const { return toText(info, get()); }
  // Both throw BadInput, with a message that begins with `where`.
  void set(const SettingValue& value, std::string_view where) const;
  void setFromText(std::string_view text, std::string_view where) const;
};

// Binds the row to `values`, which must outlive the result.
template <class P>
Setting bound(const SettingRow<P>& row, P& values) {
  return {row.info, row.defaultValue(), [&row, &values] { return row.valueIn(values); },
          [&row, &values](const SettingValue& value) { row.putInto(values, value); },
          [&row, &values] { return row.whyIdle ? row.whyIdle(values) : std::string_view(); }};
}

// Finds a setting by its name. Throws BadInput, and suggests the nearest name.
const Setting& settingNamed(std::span<const Setting> settings, std::string_view name,
                            std::string_view where);

}  // namespace umbra
