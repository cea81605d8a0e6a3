#include "datasets/json/Relation.h"

#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

const char* nameOf(Relation relation) {
  return relation == Relation::Less ? "<" : relation == Relation::Greater ? ">" : "≈";
}

Relation relationFrom(const std::string& name, const std::string& where) {
  for (const auto relation : {Relation::Less, Relation::Greater, Relation::Near})
    if (name == nameOf(relation)) return relation;
  throw Error(ErrorKind::BadInput,
              where + ": '" + clipped(name) + "' is no relation; there are <, > and ≈");
}

}  // namespace umbra
