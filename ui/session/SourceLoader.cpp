#include "ui/session/SourceLoader.h"

#include <QMetaObject>
#include <exception>

namespace umbra {

SourceLoader::SourceLoader(QObject* parent) : QObject(parent) {}

// Events that a thread has posted to this object die with it.
SourceLoader::~SourceLoader() = default;

void SourceLoader::load(const Workspace& workspace) {
  const int number = ++asked_;
  threads_.emplace(number, [this, number, workspace] {
    Document document{workspace, {}};
    QString error;
    try {
      document.content = loadSource(workspace.shared.source);
    } catch (const std::exception& problem) {
      error = QString::fromUtf8(problem.what());
    }
    QMetaObject::invokeMethod(
        this, [=, this] { report(number, document, error); }, Qt::QueuedConnection);
  });
}

void SourceLoader::drop() {
  if (!busy()) return;
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
