#include "app/reproduce/ReportPage.h"

#include <algorithm>
#include <map>
#include <set>

#include "app/lessons/Markdown.h"
#include "app/lessons/PageParts.h"
#include "datasets/figures/FigureMeasures.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// What the pages of lessons do not have. Verdicts are told apart by their words, not by colour
// alone.
constexpr const char* reportStyle = R"(
body { max-width: 60rem; }
.panes { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: .8rem; }
.panes figure { margin: 0; }
.scroll { overflow-x: auto; }
.verdict { font: 600 .85rem Inter, "DejaVu Sans", Arial, sans-serif; white-space: nowrap; }
.holds { color: #1b6e3c; }
.partly { color: #8a5a00; }
.fails { color: #a3262a; }
a { color: var(--accent); }
)";

std::string verdictHtml(Verdict verdict) {
  const std::string name = nameOf(verdict);
  return "<span class=\"verdict " + name + "\">" + name + "</span>";
}

std::string numberHtml(const std::optional<double>& value) {
  return "<td class=\"figure\">" + (value ? shortNumber(*value) : std::string("–")) + "</td>";
}

std::string headingOf(const Figure& figure) {
  return figure.paper + ", " + figure.number + ": " + figure.title;
}

std::string picturesHtml(const FigureResult& result) {
  std::string html;
  for (std::size_t i = 0; i < result.pictures.size(); ++i)
    if (!result.pictures[i].empty())
      html += pictureInPage(result.pictures[i], result.figure.cells[i].label);
  return html.empty() ? html : "<div class=\"panes\">\n" + html + "</div>\n";
}

// Why a cell was not measured, or what was not as it sets.
std::string remarkOn(const Json& row) {
  std::vector<std::string> remarks;
  if (row.contains("reason")) remarks.push_back(row["reason"].get<std::string>());
  if (row.contains("notices"))
    for (const Json& notice : row["notices"]) remarks.push_back(notice.get<std::string>());
  return remarks.empty() ? std::string() : " (" + joined(remarks, "; ") + ")";
}

std::string measuredHtml(const FigureResult& result) {
  const Figure& figure = result.figure;
  if (figure.columns.empty()) return {};
  std::string html = "<div class=\"scroll\"><table><tr><th>Measured here</th>";
  for (const std::string& column : figure.columns) html += "<th>" + escapedHtml(column) + "</th>";
  html += "</tr>\n";
  for (std::size_t i = 0; i < figure.cells.size(); ++i) {
    html += "<tr><td>" + escapedHtml(figure.cells[i].label + remarkOn(result.rows[i])) + "</td>";
    for (const std::string& column : figure.columns)
      html += numberHtml(measureIn(result.rows[i], column));
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string statedText(const FigureClaim& claim) {
  std::string text = std::string(nameOf(claim.relation)) + " " + shortNumber(claim.stated);
  if (claim.tolerance > 0.0) text += ", ±" + shortNumber(claim.tolerance);
  if (claim.partly > 0.0) text += "; in part ±" + shortNumber(claim.partly);
  return text;
}

std::string claimsHtml(const FigureResult& result) {
  const Figure& figure = result.figure;
  std::string html =
      "<div class=\"scroll\"><table><tr><th>Claim</th><th>Quantity</th><th>Measured</th>"
      "<th>Stated</th><th>Verdict</th></tr>\n";
  for (std::size_t i = 0; i < figure.claims.size(); ++i) {
    const FigureClaim& claim = figure.claims[i];
    html += "<tr><td>" + escapedHtml(claim.text) + "</td><td>" +
            escapedHtml(describe(figure, claim)) + "</td>" + numberHtml(result.claims[i].measured) +
            "<td class=\"figure\">" + escapedHtml(statedText(claim)) + "</td><td>" +
            verdictHtml(result.claims[i].verdict) + "</td></tr>\n";
  }
  return html + "</table></div>\n";
}

std::string figureHtml(const FigureResult& result) {
  const Figure& figure = result.figure;
  std::string html = "<section id=\"" + figure.name + "\">\n<h2>" + escapedHtml(headingOf(figure)) +
                     "</h2>\n<p class=\"label\">What the paper states</p>\n" +
                     markdownToHtml(figure.states);
  if (!figure.differs.empty())
    html += "<p class=\"label\">What differs here</p>\n" + markdownToHtml(figure.differs);
  return html + picturesHtml(result) + claimsHtml(result) + measuredHtml(result) +
         "<p class=\"after\">Again: <code>" + escapedHtml(commandOf(figure)) + "</code> (" +
         shortNumber(result.seconds) + " s)</p>\n</section>\n";
}

// How many claims of a figure have each verdict.
std::string summaryHtml(const std::vector<FigureResult>& results) {
  std::string html = "<table><tr><th>Figure</th><th>Holds</th><th>Partly</th><th>Fails</th></tr>\n";
  std::map<Verdict, std::size_t> all;
  const auto row = [&](const std::string& name, std::map<Verdict, std::size_t>& counts) {
    html += "<tr><td>" + name + "</td>";
    for (const Verdict verdict : {Verdict::Holds, Verdict::Partly, Verdict::Fails})
      html += "<td class=\"figure\">" + std::to_string(counts[verdict]) + "</td>";
    html += "</tr>\n";
  };
  for (const FigureResult& result : results) {
    std::map<Verdict, std::size_t> counts;
    for (const ClaimVerdict& claim : result.claims) {
      ++counts[claim.verdict];
      ++all[claim.verdict];
    }
    row("<a href=\"#" + result.figure.name + "\">" + escapedHtml(headingOf(result.figure)) + "</a>",
        counts);
  }
  row("<strong>All</strong>", all);
  return html + "</table>\n";
}

std::string leftOutHtml(const std::vector<Figure>& leftOut) {
  if (leftOut.empty()) return {};
  std::string html =
      "<section>\n<h2>What is left out</h2>\n<table><tr><th>Figure</th><th>Why</th></tr>\n";
  for (const Figure& figure : leftOut)
    html += "<tr><td>" + escapedHtml(headingOf(figure)) + "</td><td>" +
            markdownToHtml(figure.leftOut) + "</td></tr>\n";
  return html + "</table>\n</section>\n";
}

std::set<std::string> measuresOf(const std::vector<FigureResult>& results) {
  std::set<std::string> names;
  for (const FigureResult& result : results) {
    names.insert(result.figure.columns.begin(), result.figure.columns.end());
    for (const FigureClaim& claim : result.figure.claims) {
      names.insert(claim.left.measure);
      if (claim.operation != FigureOperation::None) names.insert(claim.right.measure);
    }
  }
  return names;
}

std::string definitionsHtml(const std::vector<FigureResult>& results) {
  const std::set<std::string> names = measuresOf(results);
  std::string html = "<section>\n<h2>The measures</h2>\n<table>\n";
  for (const FigureMeasure& measure : figureMeasures())
    if (names.contains(std::string(measure.name)))
      html += "<tr><td><code>" + std::string(measure.name) + "</code></td><td>" +
              escapedHtml(measure.definition) + "</td></tr>\n";
  return html +
         "</table>\n<p>A claim holds where what is measured stands in the relation to what is "
         "stated, or is off by no more than the tolerance; it holds partly within the wider one. "
         "Costs are of this machine, so that only ratios compare with the papers’.</p>\n"
         "</section>\n";
}

}  // namespace

std::string reportPage(const std::vector<FigureResult>& results,
                       const std::vector<Figure>& leftOut) {
  const std::string title = "The papers’ figures, measured again";
  std::string html = pageStart(title, reportStyle) + "<header>\n<h1>" + title +
                     "</h1>\n<p>Each claim of a paper beside what this program measures. Verdicts "
                     "are computed.</p>\n</header>\n<section>\n" +
                     summaryHtml(results) + "</section>\n";
  for (const FigureResult& result : results) html += figureHtml(result);
  return html + leftOutHtml(leftOut) + definitionsHtml(results) +
         "<footer><p>Pictures and figures by Umbrascope " UMBRA_VERSION
         ".</p></footer>\n</body>\n</html>\n";
}

}  // namespace umbra
