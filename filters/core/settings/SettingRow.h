// Makes the rows of a table of settings from pointers to members.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "filters/core/scene/Camera.h"
#include "filters/core/settings/Setting.h"

namespace umbra::detail {

// A camera is ten numbers; no camera is an empty list.
std::vector<double> numbersOf(const std::optional<Camera>& camera);
std::optional<Camera> cameraFrom(const std::vector<double>& numbers);

template <class C, class T>
C ownerOf(T C::*);
template <class C, class T>
T memberOf(T C::*);

// Follows the pointers from the outermost structure inwards to a member.
template <auto first, auto... rest>
constexpr auto& memberAt(auto& values) {
  if constexpr (sizeof...(rest) == 0)
    return values.*first;
  else
    return memberAt<rest...>(values.*first);
}

template <auto first, auto... rest>
struct Last : Last<rest...> {};
template <auto only>
struct Last<only> {
  using Type = decltype(memberOf(only));
};

template <class T>
constexpr SettingKind kindOf() {
  if constexpr (std::is_same_v<T, bool>)
    return SettingKind::Switch;
  else if constexpr (std::is_same_v<T, int>)
    return SettingKind::Whole;
  else if constexpr (std::is_same_v<T, double>)
    return SettingKind::Number;
  else if constexpr (std::is_enum_v<T>)
    return SettingKind::Choice;
  else if constexpr (std::is_same_v<T, Eigen::Vector3d>)
    return SettingKind::Point;
  else
    return SettingKind::Camera;
}

template <class T>
SettingValue toValue(const T& member, const SettingInfo& info) {
  if constexpr (std::is_enum_v<T>)
    return std::string(info.choices[std::size_t(member)]);
  else if constexpr (std::is_same_v<T, Eigen::Vector3d>)
    return std::vector<double>{member.x(), member.y(), member.z()};
  else if constexpr (kindOf<T>() == SettingKind::Camera)
    return numbersOf(member);
  else
    return member;
}

template <class T>
void fromValue(T& member, const SettingValue& value, const SettingInfo& info) {
  if constexpr (std::is_enum_v<T>) {
    for (std::size_t i = 0; i < info.choices.size(); ++i)
      if (info.choices[i] == std::get<std::string>(value)) member = T(i);
  } else if constexpr (std::is_same_v<T, Eigen::Vector3d>) {
    member = Eigen::Map<const Eigen::Vector3d>(std::get<std::vector<double>>(value).data());
  } else if constexpr (kindOf<T>() == SettingKind::Camera) {
    member = cameraFrom(std::get<std::vector<double>>(value));
  } else {
    member = std::get<T>(value);
  }
}

// An enumeration has to count up from 0, and `choices` names its values in that order.
template <auto first, auto... rest>
constexpr auto settingRow(SettingInfo info,
                          std::string_view (*whyIdle)(const decltype(ownerOf(first))&) = nullptr,
                          Stage (*staleBy)(const decltype(ownerOf(first))&,
                                           const decltype(ownerOf(first))&) = nullptr) {
  using P = decltype(ownerOf(first));
  using T = typename Last<first, rest...>::Type;
  info.kind = kindOf<T>();
  return SettingRow<P>{info,
                       [](const P& values, const SettingInfo& row) {
                         return toValue<T>(memberAt<first, rest...>(values), row);
                       },
                       [](P& values, const SettingInfo& row, const SettingValue& value) {
                         fromValue<T>(memberAt<first, rest...>(values), value, row);
                       },
                       whyIdle, staleBy};
}

}  // namespace umbra::detail
