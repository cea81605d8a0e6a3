#include "ui/session/SourceLoader.h"

#include <QMetaObject>
#include <exception>

#include "filters/core/support/Error.h"

namespace umbra {

SourceLoader::SourceLoader(QObject* parent) : QObject(parent) {}

// Events that a thread has posted to this object die with it; a thread is asked to stop, and waited
// for.
SourceLoader::~SourceLoader() = default;

void SourceLoader::stopAll() {
  for (auto& [number, thread] : threads_) thread.request_stop();
}

void SourceLoader::load(const Workspace& workspace) {
  stopAll();
  const int number = ++asked_;
  threads_.emplace(number, [this, number, workspace](const std::stop_token& stop) {
    int told = -1;  // per cent
    const Progress progress([this, number, stop, &told](double part) {
      if (stop.stop_requested()) throw Error(ErrorKind::Cancelled, "given up");
      if (int(100.0 * part) == told) return;
      told = int(100.0 * part);
      QMetaObject::invokeMethod(
          this,
          [this, number, part] {
            if (number == asked_) emit progressed(part);
          },
          Qt::QueuedConnection);
    });
    Document document{workspace, {}};
    QString error;
    try {
      document.content = loadSource(workspace.shared.source, progress);
    } catch (const std::exception& problem) {
      error = QString::fromUtf8(problem.what());
    }
    QMetaObject::invokeMethod(
        this, [=, this] { report(number, document, error); }, Qt::QueuedConnection);
  });
}

void SourceLoader::drop() {
  if (!busy()) return;
  stopAll();
  reported_ = ++asked_;
  emit finished();
}

void SourceLoader::report(int number, const Document& document, const QString& error) {
  threads_.erase(number);  // it has only to return
  if (number != asked_) return;
  reported_ = number;
  if (error.isEmpty())
    emit loaded(document);
  else
    emit failed(document.workspace, error);
  emit finished();
}

}  // namespace umbra
