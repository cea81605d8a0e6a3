// How the values of a depth file are understood, as a form.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>

#include "datasets/maps/DepthFile.h"

class QComboBox;
class QFormLayout;

namespace umbra {

class NumberField;

class DepthImportForm : public QWidget {
  Q_OBJECT

 public:
  explicit DepthImportForm(QWidget* parent = nullptr);

  // What the file names; the row is hidden where there is nothing to choose. Emits nothing.
  void setChannels(const QStringList& names);
  // Emits nothing.
  void setImport(const DepthImport& import);
  // What the form says. Nothing where a number is missing or wrong: `problem` says which.
  std::optional<DepthImport> import(QString* problem = nullptr) const;
  // Puts the cursor where a projection's planes are to be given.
  void askForPlanes();

 signals:
  void edited();

 private:
  void makeRows();
  void showChannel();
  void showWhatApplies();
  // Each gives false with a problem where its numbers are missing or wrong.
  bool readRange(DepthImport& import, QString& problem) const;
  bool readProjection(DepthProjection& projection, QString& problem) const;
  bool readMiss(DepthMiss& miss, QString& problem) const;

  QFormLayout* rows_;
  QComboBox *channel_, *projection_, *miss_;
  NumberField *atZero_, *atOne_, *near_, *far_, *angle_, *missValue_;
  QString wantedChannel_;
};

}  // namespace umbra
