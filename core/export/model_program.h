// A fitted model as a portable program.
#pragma once

#include <string>
#include <vector>

#include "diagnose/model/model.h"
#include "export/portable/program.h"

namespace breakaway {

/// What of a model stays behind in a form: an effect with its numbers, and why.
struct LeftOut {
  std::string what;     ///< "cogging (amplitude_Nm 0.0021, phase_rad 1.2, order 12)"
  std::string why;      ///< where `partly`: what is lost of it
  bool partly = false;  ///< the rest is held
};

/// The model's functions, shown ones with units in their names: friction(), load(), step(), reading(), and where
/// voltage or duty drives coast() and current_reading(); `leftOut` gets what is not in them. Steps follow the same
/// equations in the same order as simulate(). Precondition: termsOf(model) succeeds.
Program programOf(const Model& model, std::vector<LeftOut>& leftOut);

/// An effect and its parameters in words.
std::string inWords(const EffectTerm& term);

}  // namespace breakaway
