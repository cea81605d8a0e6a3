// The cells of a sweep on the disk: each is kept as soon as it is measured, so that a run that was
// ended goes on where it was, and the table is made when all are there.
#pragma once

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/output/Output.h"
#include "datasets/plans/SweepPlan.h"

namespace umbra {

// Some cells of a plan, the first and the last among them.
struct SweepRange {
  std::size_t first = 0, last = 0;
  bool isWhole = true;  // all cells: what is written is the table, else a part of it

  std::size_t count() const { return last - first + 1; }
};

class SweepTable {
 public:
  // Reads what the folder has of these cells, of this run or of others, finished or not. Throws
  // BadOutput where it cannot be written, or holds cells of another plan.
  SweepTable(const SweepPlan& plan, const SweepRange& range, std::filesystem::path folder);

  bool has(std::size_t cell) const { return rows_.contains(cell); }
  std::size_t count() const { return rows_.size(); }
  // Keeps a cell at once, on the disk.
  void add(std::size_t cell, const Json& row);
  // Writes cells.jsonl, cells.csv and sweep.json, or cells-FIRST-LAST.jsonl for a part, in the
  // plan's order whatever was measured first, and removes what is kept of single cells.
  void finish();

 private:
  void checkHeader(const Json& found, const std::filesystem::path& file) const;
  void readRows(const std::filesystem::path& file, bool mayBeCut);
  std::filesystem::path journal() const;
  std::string partName() const;
  Json header() const;
  std::string csv() const;

  const SweepPlan& plan_;
  const SweepRange range_;
  const std::filesystem::path folder_;
  std::map<std::size_t, std::string> rows_;  // by cell, as lines of JSON
  std::unique_ptr<FILE, int (*)(FILE*)> kept_{nullptr, std::fclose};
};

}  // namespace umbra
