#include "datasets/figures/FigureFile.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "datasets/figures/FigureMeasures.h"
#include "datasets/json/JsonText.h"
#include "datasets/session/file/JsonObject.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr double largest = std::numeric_limits<double>::max();

[[noreturn]] void refuseFigure(const std::string& where, const std::string& why) {
  throw Error(ErrorKind::BadInput, where + why);
}

void readNeeded(JsonObject& object, const char* key, std::string& text) {
  object.readLines(key, text);
  if (text.empty()) refuseFigure(object.where(), std::string(": needs a text '") + key + "'");
}

// Names are parts of files' names.
void checkName(const std::string& name, const std::string& where) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  };
  if (name.size() > 60 || name.starts_with('.') || !std::all_of(name.begin(), name.end(), fits))
    refuseFigure(where, ": '" + clipped(name) +
                            "' is not right, pictures are called so: it takes up to 60 small "
                            "letters, digits, '-' and '.'");
}

class FigureReader {
 public:
  FigureReader(const Json& json, std::string_view where, const fs::path& folder)
      : json_(json), where_(where), folder_(folder) {}

  Figure read() {
    JsonObject object(json_, where_);
    std::string format;
    object.read("format", format);
    if (format != figureFormat)
      refuseFigure(
          where_, std::string(": is no figure, its \"format\" should be \"") + figureFormat + "\"");
    readNeeded(object, "name", figure_.name);
    checkName(figure_.name, where_ + ": name");
    figure_.argument = figure_.name;
    readNeeded(object, "paper", figure_.paper);
    readNeeded(object, "number", figure_.number);
    readNeeded(object, "title", figure_.title);
    readNeeded(object, "states", figure_.states);
    object.readLines("leftOut", figure_.leftOut);
    if (figure_.leftOut.empty()) readDone(object);
    object.finish();
    return std::move(figure_);
  }

 private:
  void readDone(JsonObject& object) {
    object.readLines("differs", figure_.differs);
    Json base = Json::object();
    object.readValue("base", [&](const Json& value, const std::string&) { base = value; });
    std::vector<SweepCell> cells;
    object.readList("cells", [&](const Json& value, const std::string& at) {
      cells.push_back(cellFrom(value, at));
    });
    if (cells.empty()) refuseFigure(where_, ": needs 'cells', or 'leftOut', why it is not done");
    std::vector<SweepMeasure> measures;
    object.readList("measures", [&](const Json& value, const std::string& at) {
      measures.push_back(sweepMeasureFrom(value, at));
    });
    if (measures.empty()) measures = {SweepMeasure::Compare};
    figure_.plan = sweepPlanOfCells(base, std::move(cells), std::move(measures), where_, folder_);
    object.readList("columns", [&](const Json& value, const std::string& at) {
      figure_.columns.push_back(measureFrom(value.is_string() ? value.get<std::string>() : "", at));
    });
    object.readList("claims", [&](const Json& value, const std::string& at) {
      JsonObject claim(value, at);
      figure_.claims.push_back(claimFrom(claim));
      claim.finish();
    });
    if (figure_.claims.empty()) refuseFigure(where_, ": needs at least one of 'claims'");
  }

  SweepCell cellFrom(const Json& value, const std::string& at) {
    JsonObject object(value, at);
    FigureCell cell;
    readNeeded(object, "name", cell.name);
    checkName(cell.name, at + ": name");
    for (const FigureCell& other : figure_.cells)
      if (other.name == cell.name)
        refuseFigure(at, ": another cell is called '" + cell.name + "' as well");
    cell.label = cell.name;
    object.read("label", cell.label);
    SweepCell settings;
    object.readObject("set", [&](JsonObject& set) {
      set.readRest([&](const std::string& key, const Json& setting, const std::string&) {
        settings.emplace_back(key, setting);
      });
    });
    object.finish();
    figure_.cells.push_back(cell);
    return settings;
  }

  // A measure that the plan asks for.
  std::string measureFrom(const std::string& name, const std::string& at) const {
    const SweepMeasure asks = figureMeasureNamed(name, at).asks;
    const auto& measures = figure_.plan.measures;
    if (std::find(measures.begin(), measures.end(), asks) == measures.end())
      refuseFigure(at, ": '" + name + "' needs '" + std::string(nameOf(asks)) + "' in 'measures'");
    return name;
  }

  // `usual` is the measure where the object names none.
  FigureQuantity quantityFrom(JsonObject& object, const std::string& usual) const {
    std::string cell;
    FigureQuantity quantity{0, usual};
    readNeeded(object, "cell", cell);
    std::vector<std::string> names;
    for (const FigureCell& known : figure_.cells) names.push_back(known.name);
    const auto found = std::find(names.begin(), names.end(), cell);
    if (found == names.end())
      refuseFigure(object.where(),
                   ".cell: there is no cell '" + clipped(cell) + "'; there are " + joined(names));
    quantity.cell = std::size_t(found - names.begin());
    object.read("measure", quantity.measure);
    quantity.measure = measureFrom(quantity.measure, object.where() + ".measure");
    return quantity;
  }

  FigureClaim claimFrom(JsonObject& object) const {
    FigureClaim claim;
    readNeeded(object, "text", claim.text);
    claim.left = quantityFrom(object, "");
    const auto operand = [&](const char* key, FigureOperation operation) {
      object.readObject(key, [&](JsonObject& right) {
        if (claim.operation != FigureOperation::None)
          refuseFigure(object.where(), ": 'over' excludes 'minus'");
        claim.operation = operation;
        claim.right = quantityFrom(right, claim.left.measure);
        right.finish();
      });
    };
    operand("over", FigureOperation::Over);
    operand("minus", FigureOperation::Minus);
    std::string relation;
    readNeeded(object, "relation", relation);
    claim.relation = relationFrom(relation, object.where() + ".relation");
    claim.stated = std::numeric_limits<double>::infinity();
    object.read("stated", claim.stated, -largest, largest);
    if (claim.stated == std::numeric_limits<double>::infinity())
      refuseFigure(object.where(), ": needs a number 'stated'");
    object.read("tolerance", claim.tolerance, 0.0, largest);
    object.read("partly", claim.partly, 0.0, largest);
    if (claim.partly != 0.0 && claim.partly <= claim.tolerance)
      refuseFigure(object.where(), ".partly: should be wider than the tolerance");
    if (claim.relation == Relation::Near && claim.tolerance == 0.0)
      refuseFigure(object.where(), ": the relation ≈ needs a 'tolerance' above 0");
    return claim;
  }

  const Json& json_;
  const std::string where_;
  const fs::path folder_;
  Figure figure_;
};

}  // namespace

Figure figureFromText(std::string_view text, std::string_view where, const fs::path& folder) {
  const Json json = jsonFromText(text, where);
  return FigureReader(json, where, folder).read();
}

Figure readFigure(const fs::path& file) {
  Figure figure = figureFromText(textOf(file), file.string(), fs::absolute(file).parent_path());
  figure.argument = file.string();
  return figure;
}

}  // namespace umbra
