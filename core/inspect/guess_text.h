#pragma once
#include <string>

#include "inspect/predict.h"

namespace ps {

/// A guess in words: "51 0 0", "red", "4".
std::string guess_text(Question question, const Guess& guess, const Scene& scene);

}  // namespace ps
