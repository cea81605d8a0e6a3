#include "datasets/figures/Figure.h"

namespace umbra {
namespace {

std::string describeQuantity(const Figure& figure, const FigureQuantity& quantity) {
  return quantity.measure + " of " + figure.cells[quantity.cell].label;
}

}  // namespace

std::string describe(const Figure& figure, const FigureClaim& claim) {
  const std::string left = describeQuantity(figure, claim.left);
  if (claim.operation == FigureOperation::None) return left;
  return left + (claim.operation == FigureOperation::Over ? " ÷ " : " − ") +
         describeQuantity(figure, claim.right);
}

}  // namespace umbra
