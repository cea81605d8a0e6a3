#include "app/reproduce/FigureResult.h"

#include <chrono>

#include "app/sweep/SweepRunner.h"
#include "datasets/figures/FigureMeasures.h"

namespace umbra {
namespace {

Json numberOrNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json claimToJson(const Figure& figure, const FigureClaim& claim, const ClaimVerdict& result) {
  return {{"text", claim.text},
          {"quantity", describe(figure, claim)},
          {"measured", numberOrNull(result.measured)},
          {"relation", nameOf(claim.relation)},
          {"stated", claim.stated},
          {"tolerance", claim.tolerance},
          {"partly", claim.partly},
          {"verdict", nameOf(result.verdict)}};
}

Json cellToJson(const FigureResult& result, std::size_t cell) {
  const Figure& figure = result.figure;
  Json json{{"name", figure.cells[cell].name}, {"label", figure.cells[cell].label}};
  for (const auto& [key, value] : result.rows[cell].items())
    if (key != "cell" && key != "picture") json[key] = value;
  if (!result.pictures[cell].empty()) json["picture"] = pictureNameOf(figure, cell);
  return json;
}

Json paperToJson(const Figure& figure) {
  return {{"name", figure.name},
          {"paper", figure.paper},
          {"number", figure.number},
          {"title", figure.title},
          {"states", figure.states}};
}

Json figureToJson(const FigureResult& result) {
  const Figure& figure = result.figure;
  Json json = paperToJson(figure);
  if (!figure.differs.empty()) json["differs"] = figure.differs;
  json["claims"] = Json::array();
  for (std::size_t i = 0; i < figure.claims.size(); ++i)
    json["claims"].push_back(claimToJson(figure, figure.claims[i], result.claims[i]));
  json["cells"] = Json::array();
  for (std::size_t i = 0; i < figure.cells.size(); ++i)
    json["cells"].push_back(cellToJson(result, i));
  json["command"] = commandOf(figure);
  json["seconds"] = result.seconds;
  return json;
}

}  // namespace

FigureResult measuredFigure(const Figure& figure, const std::function<void()>& beforeCell) {
  const auto began = std::chrono::steady_clock::now();
  FigureResult result{figure, {}, std::vector<std::string>(figure.cells.size()), {}, 0.0};
  SweepRunner runner(figure.plan, figure.name, [&](std::size_t cell, const std::string& png) {
    result.pictures[cell] = png;
    return pictureNameOf(figure, cell);
  });
  for (std::size_t cell = 0; cell < figure.cells.size(); ++cell) {
    beforeCell();
    result.rows.push_back(runner.measured(cell));
  }
  for (const FigureClaim& claim : figure.claims)
    result.claims.push_back(verdictOn(claim, result.rows));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  result.seconds = took.count();
  return result;
}

std::string pictureNameOf(const Figure& figure, std::size_t cell) {
  return figure.name + "-" + figure.cells[cell].name + ".png";
}

std::string commandOf(const Figure& figure) {
  return "umbrascope reproduce " + figure.argument + " -o report";
}

Json reportToJson(const std::vector<FigureResult>& results, const std::vector<Figure>& leftOut) {
  Json report{{"format", "umbrascope-report/1"},
              {"version", UMBRA_VERSION},
              {"figures", Json::array()},
              {"leftOut", Json::array()},
              {"measures", Json::object()}};
  for (const FigureResult& result : results) report["figures"].push_back(figureToJson(result));
  for (const Figure& figure : leftOut) {
    Json json = paperToJson(figure);
    json["reason"] = figure.leftOut;
    report["leftOut"].push_back(json);
  }
  for (const FigureMeasure& measure : figureMeasures())
    report["measures"][std::string(measure.name)] = measure.definition;
  return report;
}

}  // namespace umbra
