#include "analysis/probe/ProbeSheet.h"

#include "filters/core/support/Parameters.h"

namespace umbra {
namespace {

std::string quoted(const std::string& field, char separator) {
  if (field.find(separator) == std::string::npos && field.find('"') == std::string::npos)
    return field;
  std::string text = "\"";
  for (char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string lineOf(const std::vector<std::string>& fields, char separator) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i)
    line += (i ? std::string(1, separator) : std::string()) + quoted(fields[i], separator);
  return line + "\n";
}

}  // namespace

const SheetFigures::Entry* SheetFigures::of(std::string_view technique) const {
  for (const Entry& entry : techniques)
    if (entry.technique == technique) return &entry;
  return nullptr;
}

SheetFigures figuresOf(const Probe& probe, const std::optional<double>& truth) {
  SheetFigures figures{probe.receiver, truth.value_or(probe.reference), {}};
  for (const TechniqueResult& result : probe.techniques)
    figures.techniques.push_back({std::string(result.technique->info().id), result.visibility,
                                  result.visibility - figures.reference});
  return figures;
}

std::string sheetText(std::span<const SheetRow> rows, std::span<const std::string> techniques,
                      char separator) {
  std::vector<std::string> heading{"name", "x", "y", "z", "receiver", "truth"};
  for (const std::string& id : techniques) heading.insert(heading.end(), {id, id + " error"});
  heading.push_back("note");
  std::string text = lineOf(heading, separator);
  for (const SheetRow& row : rows) {
    std::vector<std::string> fields{row.name};
    for (std::size_t i = 0; i < 3; ++i)
      fields.push_back(i < row.place.size() ? toText(row.place[i]) : std::string());
    const SheetFigures* figures = row.figures ? &*row.figures : nullptr;
    fields.push_back(figures ? toText(figures->receiver) : std::string());
    fields.push_back(figures ? toText(figures->reference) : std::string());
    for (const std::string& id : techniques) {
      const SheetFigures::Entry* entry = figures ? figures->of(id) : nullptr;
      fields.push_back(entry ? toText(entry->visibility) : std::string());
      fields.push_back(entry ? toText(entry->error) : std::string());
    }
    fields.push_back(row.reason);
    text += lineOf(fields, separator);
  }
  return text;
}

}  // namespace umbra
