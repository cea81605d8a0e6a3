// Plots as files: every format, whole or not at all.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <csignal>
#include <fstream>

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"
#include "tests/plots/SamplePlots.h"
#include "ui/plots/PlotRenderer.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class PlotExport : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("umbra-plot-export-" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    map_ = leavesOverBench();
    probe_ = sampleProbe(map_);
    plots_ = {histogramPlot(probe_), curvesPlot(probe_, "vsm"), cdfPlot(probe_)};
  }
  void TearDown() override { fs::remove_all(folder_); }

  static QByteArray contentOf(const fs::path& file) {
    QFile stream(QString::fromStdString(file.string()));
    stream.open(QIODevice::ReadOnly);
    return stream.readAll();
  }

  static std::vector<std::string> wordsOf(const Plot& plot) {
    std::vector<std::string> words{plot.title, plot.xLabel, plot.yLabel};
    if (plot.series.size() > 1)
      for (const PlotSeries& series : plot.series) words.push_back(series.name);
    for (const PlotMarker& marker : plot.markers) words.push_back(marker.label);
    for (const PlotError& error : plot.errors) words.push_back(error.label);
    return words;
  }

  fs::path folder_;
  DepthMap map_;
  Probe probe_;
  std::vector<Plot> plots_;
};

// All text elements of an SVG file in a row: Qt begins a new one with every script.
std::string svgText(const QByteArray& content) {
  QString text;
  QRegularExpression element("<text[^>]*>([^<]*)</text>");
  auto match = element.globalMatch(QString::fromUtf8(content));
  while (match.hasNext()) text += match.next().captured(1);
  return text.replace("&lt;", "<").replace("&amp;", "&").toStdString();
}

TEST_F(PlotExport, SvgKeepsTextAsText) {
  for (const Plot& plot : plots_) {
    const fs::path file = folder_ / (plot.name + ".svg");
    exportPlot(plot, file);
    const QByteArray content = contentOf(file);
    const std::string text = svgText(content);
    for (const std::string& word : wordsOf(plot))
      EXPECT_NE(text.find(word), std::string::npos) << plot.name << ": " << word << "\n" << text;
    EXPECT_NE(text.find("0.2"), std::string::npos) << "tick labels";
    EXPECT_TRUE(QSvgRenderer(content).isValid());
  }
}

TEST_F(PlotExport, SvgDrawsEverySeriesInItsColour) {
  const Plot& plot = plots_[1];
  const fs::path file = folder_ / "curves.svg";
  exportPlot(plot, file);
  const QString content = QString::fromUtf8(contentOf(file));
  ASSERT_EQ(plot.series.size(), probe_.techniques.size() + 1);
  for (const PlotSeries& series : plot.series) {
    // A polyline of at least three points in the series' stroke colour.
    const QRegularExpression line("<g[^>]*stroke=\"" + QString::fromStdString(series.colour) +
                                  "\"[^>]*>\\s*<polyline[^>]*points=\"(\\S+ ){3,}");
    EXPECT_TRUE(line.match(content).hasMatch()) << series.name << " " << series.colour;
  }
}

TEST_F(PlotExport, PdfEmbedsFontsAndKeepsText) {
  for (const Plot& plot : plots_) {
    const fs::path file = folder_ / (plot.name + ".pdf");
    exportPlot(plot, file);
    const QByteArray content = contentOf(file);
    ASSERT_TRUE(content.startsWith("%PDF-"));
    EXPECT_TRUE(content.contains("/FontFile"));   // the glyphs themselves
    EXPECT_TRUE(content.contains("/ToUnicode"));  // so that text can be searched and copied
    EXPECT_FALSE(content.contains("/Subtype /Image")) << "drawn, not a picture";
    EXPECT_TRUE(content.contains("/MediaBox [0 0 720.000000 440.000000]") ||
                content.contains("/MediaBox [0 0 720 440]"))
        << content.mid(content.indexOf("/MediaBox"), 60).constData();
  }
}

TEST_F(PlotExport, PdfsOfOnePlotAreTheSameFileWhereTheDateIsGiven) {
  const fs::path file = folder_ / "dated.pdf";
  qputenv("SOURCE_DATE_EPOCH", "1000000000");
  exportPlot(plots_[0], file);
  const QByteArray first = contentOf(file);
  qunsetenv("SOURCE_DATE_EPOCH");
  EXPECT_TRUE(first.contains("/CreationDate (D:20010909014640"));
  // The table at the end names the byte at which each object begins.
  const int table = first.lastIndexOf("\nxref") + 1;
  EXPECT_EQ(first.mid(first.lastIndexOf("startxref") + 10).split('\n').front().toInt(), table);
  exportPlot(plots_[0], file);
  EXPECT_FALSE(contentOf(file).contains("/CreationDate (D:20010909014640"));
}

TEST_F(PlotExport, PngHasTheAskedSizeAndItsColours) {
  for (const Plot& plot : plots_) {
    const fs::path file = folder_ / (plot.name + ".png");
    exportPlot(plot, file, {500, 300});
    const QImage image(QString::fromStdString(file.string()));
    ASSERT_EQ(image.size(), QSize(1000, 600));
    for (const PlotSeries& series : plot.series) {
      const QRgb wanted = QColor(QString::fromStdString(series.colour)).rgb();
      int found = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) found += image.pixel(x, y) == wanted;
      EXPECT_GT(found, 20) << plot.name << ": " << series.name;
    }
  }
}

TEST_F(PlotExport, CsvNumbersReadBackExactly) {
  const Plot& plot = plots_[1];
  writeCsv(plot, folder_ / "curves.csv");
  std::ifstream stream(folder_ / "curves.csv");
  std::string line;
  std::getline(stream, line);
  for (std::size_t row = 0; row < plot.series[0].x.size(); ++row) {
    ASSERT_TRUE(std::getline(stream, line));
    const std::vector<std::string> cells = split(line, ',');
    ASSERT_EQ(cells.size(), plot.series.size() + 1);
    EXPECT_EQ(std::stod(cells[0]), plot.series[0].x[row]);
    for (std::size_t i = 0; i < plot.series.size(); ++i)
      EXPECT_EQ(std::stod(cells[i + 1]), plot.series[i].y[row]) << plot.series[i].name;
  }
  EXPECT_FALSE(std::getline(stream, line));
}

TEST_F(PlotExport, RefusesWhatCannotBeWrittenAndLeavesNothing) {
  std::ofstream(folder_ / "file") << "in the way";
  const auto kindOf = [&](const fs::path& file) {
    try {
      exportPlot(plots_[0], file);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
      return error.kind();
    }
    ADD_FAILURE() << file << " was accepted";
    return ErrorKind::WorkFailed;
  };
  for (const char* extension : {".svg", ".pdf", ".png"}) {
    const std::string name = std::string("plot") + extension;
    EXPECT_EQ(kindOf(folder_ / "file" / name), ErrorKind::BadOutput);
    fs::create_directories(folder_ / "taken" / name);
    EXPECT_EQ(kindOf(folder_ / "taken" / name), ErrorKind::BadOutput);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "taken" / name), {}), 0);
  }
  EXPECT_EQ(kindOf(folder_ / "plot.bmp"), ErrorKind::BadOutput);
  EXPECT_EQ(contentOf(folder_ / "file"), QByteArray("in the way"));
  for (const auto& entry : fs::directory_iterator(folder_))
    EXPECT_TRUE(entry.path().filename() == "file" || entry.path().filename() == "taken") << entry;
}

// A full disk: /dev/full takes no byte.
// Lets this process write no file longer than so many bytes, as a full disk does.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit less{bytes, limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &less);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit limit_{};
};

TEST_F(PlotExport, ReportsAFullDisk) {
  const QByteArray before = "an older plot";
  for (const char* extension : {".svg", ".pdf", ".png"}) {
    const fs::path file = folder_ / (std::string("plot") + extension);
    std::ofstream(file) << before.constData();
    {
      const FullDisk full(100);
      EXPECT_THROW(exportPlot(plots_[1], file), Error) << extension;
    }
    ASSERT_TRUE(fs::is_regular_file(fs::symlink_status(file)));
    EXPECT_EQ(contentOf(file), before);
    fs::remove(file);
    EXPECT_TRUE(fs::is_empty(folder_)) << extension;
  }
}

}  // namespace
}  // namespace umbra

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
