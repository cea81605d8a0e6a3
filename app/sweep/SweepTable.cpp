#include "app/sweep/SweepTable.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <vector>

#include "datasets/json/JsonText.h"
#include "datasets/plans/SweepCell.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

constexpr const char* partFormat = "umbrascope-sweep-part/1";
constexpr const char* tableFormat = "umbrascope-sweep-table/1";
constexpr std::uintmax_t largestTable = std::uintmax_t(4) << 30;

// Every figure of a row under its name; those of objects within objects as "a.b".
void flatten(const Json& value, const std::string& name,
             std::vector<std::pair<std::string, std::string>>& fields) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items())
      flatten(inner, name.empty() ? key : name + "." + key, fields);
    return;
  }
  if (!value.is_array()) return void(fields.emplace_back(name, textOfValue(value)));
  std::string list;  // with blanks between, which no field has to be quoted for
  for (const Json& one : value) list += (list.empty() ? "" : " ") + textOfValue(one);
  fields.emplace_back(name, list);
}

// The figures of a comparison are the table's own; others have their measure's name.
std::vector<std::pair<std::string, std::string>> fieldsOf(const Json& row) {
  std::vector<std::pair<std::string, std::string>> fields;
  for (const auto& [key, value] : row.items())
    flatten(value, key == "settings" || key == "compare" ? "" : key, fields);
  return fields;
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) (out += c) += c == '"' ? "\"" : "";
  return out + "\"";
}

}  // namespace

SweepTable::SweepTable(const SweepPlan& plan, const SweepRange& range, fs::path folder)
    : plan_(plan), range_(range), folder_(std::move(folder)) {
  checkWritable(folder_ / "cells.csv");
  std::error_code problem;
  fs::create_directories(folder_, problem);
  if (problem) throw Error(ErrorKind::BadOutput, folder_.string() + ": " + problem.message());
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".jsonl") && (name.starts_with("cells-") || name.starts_with("kept-")))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const bool isKept = file.filename().string().starts_with("kept-");
    try {
      readRows(file, isKept);
    } catch (const Error&) {
      // Another process that measures a part has finished it in the meantime.
      if (!isKept || fs::exists(file)) throw;
    }
  }
  const fs::path table = folder_ / "sweep.json";
  if (fs::exists(table)) {
    checkHeader(jsonFromText(textOf(table), table.string()), table);
    if (fs::exists(folder_ / "cells.jsonl")) readRows(folder_ / "cells.jsonl", false);
  }
}

// What another plan, or another version of this program, has measured must not be mixed with this.
void SweepTable::checkHeader(const Json& found, const fs::path& file) const {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorKind::BadOutput, file.string() + ": " + what + "; name another folder");
  };
  const auto text = [&](const char* key) {
    return found.is_object() && found.contains(key) && found[key].is_string()
               ? found[key].get<std::string>()
               : std::string();
  };
  if (text("plan") != plan_.fingerprint)
    refuse("holds cells of another plan, or of files that have changed");
  if (text("version") != UMBRA_VERSION)
    refuse("holds cells of version '" + clipped(text("version")) + "'");
}

// A part begins with a line that names its plan. The last line of what is kept of single cells may
// have been cut by the end of the process.
void SweepTable::readRows(const fs::path& file, bool mayBeCut) {
  const std::string content = contentOf(file, largestTable);
  std::istringstream lines(content);
  std::string line;
  bool isFirst = file.filename() != "cells.jsonl";
  while (std::getline(lines, line)) {
    if (lines.eof() && mayBeCut) break;  // no line end follows
    const Json row = jsonFromText(line, file.string());
    if (isFirst) {
      checkHeader(row, file);
      isFirst = false;
      continue;
    }
    const bool isCell = row.is_object() && row.contains("cell") &&
                        row["cell"].is_number_unsigned() && row.contains("settings");
    if (!isCell)
      throw Error(ErrorKind::BadOutput,
                  file.string() + ": holds a line that is no cell; name another folder");
    const auto cell = row["cell"].get<std::size_t>();
    if (cell >= range_.first && cell <= range_.last) rows_[cell] = line;
  }
}

fs::path SweepTable::journal() const {
  return folder_ /
         ("kept-" + std::to_string(range_.first) + "-" + std::to_string(range_.last) + ".jsonl");
}

std::string SweepTable::partName() const {
  return "cells-" + std::to_string(range_.first) + "-" + std::to_string(range_.last) + ".jsonl";
}

Json SweepTable::header() const {
  return {{"format", partFormat}, {"plan", plan_.fingerprint}, {"version", UMBRA_VERSION}};
}

void SweepTable::add(std::size_t cell, const Json& row) {
  const auto failed = [&] {
    throw Error(ErrorKind::BadOutput, journal().string() + ": " + std::strerror(errno));
  };
  const auto write = [&](const std::string& line) {
    const bool done = std::fputs(line.c_str(), kept_.get()) >= 0 && std::fflush(kept_.get()) == 0 &&
                      fsync(fileno(kept_.get())) == 0;
    if (!done) failed();
  };
  if (!kept_) {
    // What an ended run left is in rows_, and is kept anew: its last line may be cut.
    std::string all = header().dump() + "\n";
    for (const auto& [known, line] : rows_) all += line + "\n";
    writeTextAtomically(journal(), all);
    const int file = open(journal().c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) failed();
    kept_.reset(fdopen(file, "a"));
  }
  rows_[cell] = row.dump();
  write(rows_[cell] + "\n");
}

std::string SweepTable::csv() const {
  std::vector<std::string> columns{"cell"};
  columns.insert(columns.end(), plan_.settings.begin(), plan_.settings.end());
  std::vector<std::vector<std::pair<std::string, std::string>>> all;
  for (const auto& [cell, line] : rows_) {
    all.push_back(fieldsOf(jsonFromText(line, "cells")));
    for (const auto& [name, text] : all.back())
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
  }
  std::string out;
  for (const std::string& column : columns) (out += out.empty() ? "" : ",") += csvField(column);
  out += "\n";
  for (const auto& fields : all) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto found = std::find_if(fields.begin(), fields.end(),
                                      [&](const auto& field) { return field.first == columns[c]; });
      if (c > 0) line += ",";
      if (found != fields.end()) line += csvField(found->second);
    }
    out += line + "\n";
  }
  return out;
}

void SweepTable::finish() {
  std::string lines;
  for (const auto& [cell, line] : rows_) lines += line + "\n";
  if (range_.isWhole) {
    OutputFolder files(folder_);
    writeTextAtomically(files.file("cells.jsonl"), lines);
    writeTextAtomically(files.file("cells.csv"), csv());
    Json table = header();
    table["format"] = tableFormat;
    table["cells"] = rows_.size();
    writeTextAtomically(files.file("sweep.json"), toText(table));
    files.finish();
  } else {
    writeTextAtomically(folder_ / partName(), header().dump() + "\n" + lines);
    announce(folder_ / partName());
  }
  kept_.reset();
  std::error_code ignored;
  fs::remove(journal(), ignored);
}

}  // namespace umbra
