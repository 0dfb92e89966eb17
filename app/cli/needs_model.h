#pragma once
#include <string>

#include "document/document.h"

namespace ps::cli {

/// The arguments of `needs --model`.
struct ModelArguments {
  double tolerance = 0;
  std::string views;  ///< "orbit:N" or a file with a camera on each line; empty: the document's view
  std::string sheet;  ///< a picture file for before, after and difference; empty: none
  std::string save;   ///< a .scene file for the reduced scene; empty: none
  bool json = false;
};

/// Weighs the model of the document's scene, prints what can go, and saves the reduced scene. Returns the exit status:
/// 1 where a saved scene, read again and drawn afresh, is not within the tolerance.
int run_model_needs(const Document& document, const ModelArguments& arguments);

}  // namespace ps::cli
