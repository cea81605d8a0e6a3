// Counts the values of depth files beside the interface's thread.
#pragma once

#include <QObject>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <thread>

#include "datasets/maps/RawDepths.h"

namespace umbra {

class RawDepthLoader : public QObject {
  Q_OBJECT

 public:
  explicit RawDepthLoader(QObject* parent = nullptr);
  // Waits for what is still being read.
  ~RawDepthLoader() override;

  // Ends in `loaded`, on the thread of this object. Where several calls overlap, only the last one
  // is reported.
  void load(const std::filesystem::path& file, const std::string& channel);

 signals:
  // Nothing where the file is none that can be read; its channels alone, without counts, where the
  // channel is none that can be.
  void loaded(const std::optional<umbra::RawDepths>& raw);

 private:
  std::map<int, std::jthread> threads_;  // by number of request, until they have reported
  int asked_ = 0;                        // number of the last request
};

}  // namespace umbra
