// `encode --against`: the channels that an engine stored, held against the exact ones.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "analysis/stored/StoredCheck.h"
#include "app/output/Output.h"
#include "datasets/maps/DepthFile.h"

namespace umbra {

// Which channel of the engine's file is which of the technique's.
struct StoredName {
  std::string channel;  // "M1"
  std::string inFile;   // "vsm.M1", "M1" or "R"; empty in a file that names none
};
// The technique's channels in its order. `named` are names in the file, one for each of them; where
// it is empty the file's own names tell, or R, G, B and A in this order. Throws BadInput that lists
// the file's channels, BadCommandLine for another number of names.
std::vector<StoredName> storedNames(const std::filesystem::path& file, const Technique& technique,
                                    const std::vector<std::string>& named);

struct StoredRow {
  StoredName name;
  StoredFinding finding;
  Image<double> stored;
};

// `format` is the one whose last places count; without it that of the file's numbers, or a coarser
// one that holds them all. `depth` is the map that the technique is adapted to. Throws BadInput for
// a file of another size.
std::vector<StoredRow> storedRows(const std::filesystem::path& file,
                                  const std::vector<StoredName>& names, const DepthFile& depth,
                                  const Technique& technique, const Kernel& kernel,
                                  std::optional<StorageFormat> format,
                                  const std::function<void()>& between);

// "umbrascope-stored/1"; texels in the depth file's own count.
Json storedToJson(const std::vector<StoredRow>& rows, const DepthFile& depth,
                  const std::string& sourceName, const std::string& againstName,
                  const Technique& technique, const Kernel& kernel);
std::string storedText(const std::vector<StoredRow>& rows, const DepthFile& depth);

}  // namespace umbra
