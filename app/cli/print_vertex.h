#pragma once
#include <string>

#include "document/document.h"
#include "record/story.h"

namespace ps::cli {

/// The arguments of `inspect --vertex`.
struct VertexArguments {
  std::string vertex;  ///< "OBJECT,INDEX" or "nearest" (to the pixel, of the triangle that it shows); empty = none
  std::string order;   ///< "turn-then-move" or "move-then-turn"; empty = the first
  double near = 0;     ///< in place of the option's; 0 = none
};

/// Prints the vertex's way from its model to the canvas, with matrices. Throws InputError for a vertex that there is
/// not.
void print_vertex(const Document& document, const PixelStory& story, const VertexArguments& arguments, bool json);

}  // namespace ps::cli
