#include "diagnose/verdict/verdict.h"

namespace breakaway {

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::nothingMissing:
      return "nothing_missing";
    case Verdict::named:
      return "named";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::outsideCatalogue:
      return "outside_catalogue";
  }
  return {};
}

}  // namespace breakaway
