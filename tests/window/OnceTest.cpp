// What is asked for once is done once.
#include <QSignalSpy>
#include <QTest>
#include <map>
#include <string>
#include <utility>

#include "datasets/maps/ExrFile.h"
#include "tests/window/WindowFixture.h"
#include "ui/picture/SceneView.h"
#include "ui/probe/Prober.h"
#include "ui/session/SessionController.h"

namespace umbra {
namespace {

// By id, how often the catalogue has copied each of its techniques.
using Counts = std::map<std::string, int>;

// A catalogue's own instance of a technique, which counts the copies that are made of it. These are
// plain.
class Counted : public Technique {
 public:
  Counted(std::unique_ptr<Technique> plain, Counts& counts)
      : plain_(std::move(plain)), counts_(counts) {}

  std::unique_ptr<Technique> clone() const override {
    ++counts_[std::string(info().id)];
    return plain_->clone();
  }
  const TechniqueInfo& info() const override { return plain_->info(); }
  std::vector<Channel> channels() const override { return plain_->channels(); }
  std::vector<Parameter> parameters() override { return plain_->parameters(); }
  std::vector<ParameterView> parameters() const override {
    return std::as_const(*plain_).parameters();
  }
  void encode(double z, std::span<double> channels) const override { plain_->encode(z, channels); }
  double visibility(const Fetch& fetch, double receiver) const override {
    return plain_->visibility(fetch, receiver);
  }
  Trace explain(const Fetch& fetch, double receiver) const override {
    return plain_->explain(fetch, receiver);
  }
  std::string_view glsl() const override { return plain_->glsl(); }
  std::string_view page() const override { return plain_->page(); }

 private:
  std::unique_ptr<Technique> plain_;
  Counts& counts_;
};

TechniqueCatalogue countedTechniques(Counts& counts) {
  const TechniqueCatalogue plain = allTechniques();
  TechniqueCatalogue counted;
  for (const Technique* technique : plain.all())
    counted.add(std::make_unique<Counted>(technique->clone(), counts));
  return counted;
}

}  // namespace

class OnceTest : public WindowFixture {
  Q_OBJECT

 private slots:
  void aClickProbesOnce();
  void aTexelIsProbedOnce();
  void anEditMakesEachTechniqueOnce();
};

// Each report is of one probe, which evaluates every technique once.
void OnceTest::aClickProbesOnce() {
  MainWindow& window = open();
  const QSize size = window.view().pixels();
  QSignalSpy reported(&window.prober(), &Prober::reported);
  click({size.width() / 2, size.height() * 3 / 4});
  QCOMPARE(reported.count(), 1);
  QVERIFY(window.prober().report()->pixel == (Pixel{size.width() / 2, size.height() * 3 / 4}));
  // The same place again says nothing new; another one does.
  click({size.width() / 2, size.height() * 3 / 4});
  QCOMPARE(reported.count(), 1);
  click({size.width() / 4, size.height() * 3 / 4});
  QCOMPARE(reported.count(), 2);
  // Whoever asks for what is known gets it.
  window.prober().refresh();
  QCOMPARE(reported.count(), 2);
  window.prober().unpin();
  QCOMPARE(reported.count(), 3);
}

void OnceTest::aTexelIsProbedOnce() {
  const std::string file = folder_.filePath("once.exr").toStdString();
  Image<float> depths(16, 16, 1, 0.75F);
  depths(8, 8) = 0.25F;
  writeExr(file, {{"Z", depths}}, {});
  Session session;
  session.source.kind = SourceKind::DepthFile;
  session.source.name = file;
  MainWindow& window = open(session);
  QSignalSpy reported(&window.prober(), &Prober::reported);
  window.prober().pin({8, 8});
  QCOMPARE(reported.count(), 1);
  window.controller().edit("Receiver", [](Session& s) { s.receiver = 0.5; });
  QCOMPARE(reported.count(), 2);
}

void OnceTest::anEditMakesEachTechniqueOnce() {
  Counts counts;
  SessionController controller(Workspace{}, nullptr, countedTechniques(counts));
  const std::size_t all = controller.catalogue().all().size();
  QCOMPARE(counts.size(), all);
  for (const auto& [id, count] : counts) QVERIFY2(count == 1, id.c_str());

  counts.clear();
  controller.edit("Another format",
                  [](Session& session) { session.frame.map.format = StorageFormat::Half; });
  QCOMPARE(counts.size(), all);
  for (const auto& [id, count] : counts) QVERIFY2(count == 1, id.c_str());

  counts.clear();
  controller.edit("A parameter",
                  [](Session& session) { session.parameters["vsm"]["bleed-reduction"] = 0.25; });
  QCOMPARE(counts, (Counts{{"vsm", 1}}));

  counts.clear();
  controller.edit("The kernel", [](Session& session) { session.frame.kernel.radius = 5; });
  controller.edit("Another technique", [](Session& session) { session.technique = "esm"; });
  QVERIFY2(counts.empty(), "what makes no other technique makes none");
}

std::unique_ptr<QObject> makeOnceTest() {
  return std::make_unique<OnceTest>();
}

}  // namespace umbra

#include "OnceTest.moc"
