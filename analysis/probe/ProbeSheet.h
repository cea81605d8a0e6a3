// A table of several probes: what every technique makes of each.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/probe/Probe.h"

namespace umbra {

struct SheetFigures {
  struct Entry {
    std::string technique;  // id
    double visibility = 0.0, error = 0.0;
  };

  double receiver = 0.0, reference = 0.0;
  std::vector<Entry> techniques;  // in the probe's order

  const Entry* of(std::string_view technique) const;  // null where there is none
};

// `truth` is the reference to take errors against in place of the probe's own, such as the
// ray-traced one.
SheetFigures figuresOf(const Probe& probe, const std::optional<double>& truth = {});

struct SheetRow {
  std::string name;
  std::vector<double> place;  // x, y, z of a point in the world; x, y of a texel
  std::optional<SheetFigures> figures;
  std::string reason;  // why there are no figures
};

// A line for each row under "name", "x", "y", "z", "receiver", "truth" (the reference), for each of
// `techniques` (ids) its visibility and its error, and "note". Numbers have every digit; absent
// ones are empty. A field that holds the separator or a quotation mark is quoted (RFC 4180).
std::string sheetText(std::span<const SheetRow> rows, std::span<const std::string> techniques,
                      char separator);

}  // namespace umbra
