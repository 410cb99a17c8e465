#include "diagnose/model/model.h"

#include <algorithm>

namespace breakaway {

std::vector<double> valuesOf(const EffectTerm& term) {
  std::vector<double> values;
  values.reserve(term.parameters.size());
  for (const Parameter& one : term.parameters) values.push_back(one.value);
  return values;
}

std::optional<double> Model::baseValue(const std::string& name) const {
  const auto it = std::find_if(base.begin(), base.end(), [&name](const Parameter& one) { return one.name == name; });
  return it == base.end() ? std::nullopt : std::optional<double>(it->value);
}

}  // namespace breakaway
