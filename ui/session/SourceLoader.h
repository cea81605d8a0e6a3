// Reads scenes and depth maps beside the interface's thread.
#pragma once

#include <QObject>
#include <map>
#include <thread>

#include "ui/session/Document.h"

namespace umbra {

class SourceLoader : public QObject {
  Q_OBJECT

 public:
  explicit SourceLoader(QObject* parent = nullptr);
  // Waits for what is still being read.
  ~SourceLoader() override;

  // Loading ends in `loaded` or `failed`, on the thread of this object. Where several calls
  // overlap, only the last one is reported.
  void load(const Workspace& workspace);
  // Gives up what is being read: it is stopped as soon as it can be, and never reported.
  void drop();
  bool busy() const { return reported_ != asked_; }

 signals:
  // `document.workspace` is the one that was asked for.
  void loaded(const umbra::Document& document);
  void failed(const umbra::Workspace& asked, const QString& message);
  // Tells now and then which part of a mesh file has been read, from 0 to 1.
  void progressed(double part);
  void finished();  // after either

 private:
  void report(int number, const Document& document, const QString& error);
  void stopAll();

  std::map<int, std::jthread> threads_;  // by number of request, until they have reported
  int asked_ = 0, reported_ = 0;         // numbers of requests
};

}  // namespace umbra
