// Runs the window's tests: all of them, or those that are named.
//
//   window_test                                        every case of every class
//   window_test ErrorTest LayoutTest                   all cases of these classes
//   window_test ErrorTest.aPixelOfTheErrorIsProbed     this case
//   window_test aPixelOfTheErrorIsProbed               the same
//   window_test --list                                 says what there is, one CLASS.CASE a line
//
// Arguments that begin with '-' go to Qt Test: -v2, -maxwarnings 0.
#include <QApplication>
#include <QMetaMethod>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "AllTests.h"
#include "ui/window/WindowStyle.h"

namespace umbra {
namespace {

using TestClasses = std::vector<std::unique_ptr<QObject>>;

QString nameOf(const QObject& test) {
  return QString(test.metaObject()->className()).section("::", -1);
}

// The private slots that the class itself has; those of its base set a case up.
QStringList casesOf(const QObject& test) {
  QStringList cases;
  const QMetaObject& meta = *test.metaObject();
  for (int i = meta.methodOffset(); i < meta.methodCount(); ++i)
    if (meta.method(i).methodType() == QMetaMethod::Slot) cases += meta.method(i).name();
  return cases;
}

// Lists the cases of one class that `names` ask for.
QStringList chosenOf(const QObject& test, const QStringList& names) {
  const QString name = nameOf(test);
  QStringList chosen;
  for (const QString& each : casesOf(test))
    if (names.isEmpty() || names.contains(name) || names.contains(each) ||
        names.contains(name + "." + each))
      chosen += each;
  return chosen;
}

// What no class answers to.
QStringList unknown(const TestClasses& tests, const QStringList& names) {
  QStringList left;
  for (const QString& name : names) {
    const bool known = std::any_of(tests.begin(), tests.end(), [&](const auto& test) {
      return !chosenOf(*test, {name}).isEmpty();
    });
    if (!known) left += name;
  }
  return left;
}

// A class without cases is a mistake: its slots are perhaps not private ones.
int list(const TestClasses& tests) {
  for (const auto& test : tests) {
    const QStringList cases = casesOf(*test);
    if (cases.isEmpty()) return 1;
    for (const QString& each : cases) std::puts(qPrintable(nameOf(*test) + "." + each));
  }
  return 0;
}

int run(const TestClasses& tests, const QString& program, const QStringList& names,
        const QStringList& options) {
  int failed = 0;
  for (const auto& test : tests) {
    const QStringList cases = chosenOf(*test, names);
    if (!cases.isEmpty())
      failed += QTest::qExec(test.get(), QStringList{program} + options + cases);
  }
  return std::min(failed, 100);
}

}  // namespace
}  // namespace umbra

int main(int argc, char** argv) {
  QStringList names, options;
  for (int i = 1; i < argc; ++i) {
    // The value of an option follows it.
    const bool option =
        argv[i][0] == '-' || (!options.isEmpty() && options.last() == "-maxwarnings");
    (option ? options : names) += argv[i];
  }
  const umbra::TestClasses tests = umbra::allTests();
  if (options.contains("--list")) return umbra::list(tests);
  if (const QStringList unknown = umbra::unknown(tests, names); !unknown.isEmpty()) {
    std::fprintf(stderr, "no test is called %s; --list says what there is\n",
                 qPrintable(unknown.join(", ")));
    return 2;
  }
  umbra::prepareApplication();
  QApplication application(argc, argv);
  umbra::applyStyle(application);
  return umbra::run(tests, argv[0], names, options);
}
