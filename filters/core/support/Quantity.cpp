#include "filters/core/support/Quantity.h"

#include <string>
#include <vector>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// The entries stand in the order of the enumeration.
constexpr QuantityInfo infos[] = {
    {Quantity::Reference, "reference", "exact percentage-closer filtering"},
    {Quantity::Receiver, "receiver", "the receiver's depth"},
    {Quantity::Mean, "mean", "mean of the region's depths"},
    {Quantity::Variance, "variance", "variance of the region's depths"},
    {Quantity::Minimum, "minimum", "nearest depth of the region"},
    {Quantity::Maximum, "maximum", "farthest depth of the region"},
    {Quantity::Taps, "taps", "depths in the region"},
    {Quantity::Visibility, "visibility", "visibility", true},
    {Quantity::Error, "error", "visibility minus reference", true},
    {Quantity::Channels, "channels", "numbers stored per texel", true},
    {Quantity::Rmse, "rmse", "root mean square error of the frame", true, true},
    {Quantity::Bleeding, "bleeding", "mean light bleeding of the frame", true, true},
    {Quantity::Darkening, "darkening", "mean over-darkening of the frame", true, true},
    {Quantity::UmbraBleeding, "umbra-bleeding", "mean light in full shadow", true, true},
};

}  // namespace

const QuantityInfo& infoOf(Quantity quantity) {
  return infos[std::size_t(quantity)];
}

Quantity quantityFrom(std::string_view name, std::string_view where) {
  std::vector<std::string> names;
  for (const QuantityInfo& info : infos) {
    if (info.name == name) return info.quantity;
    names.emplace_back(info.name);
  }
  throw Error(ErrorKind::BadCommandLine, std::string(where) + ": there is no quantity '" +
                                             std::string(name) + "'; there are " + joined(names));
}

}  // namespace umbra
