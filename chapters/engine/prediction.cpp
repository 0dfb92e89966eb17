#include <fmt/format.h>

#include "engine/block.h"
#include "engine/lesson.h"

namespace ps {

Prediction read_prediction(const std::vector<BlockLine>& lines, const SourcePlace& place) {
  Prediction prediction;
  bool asks = false;
  for (const BlockLine& line : lines)
    at_place(line.place, [&] {
      if (line.word == "ask") {
        prediction.question = parse_question(line.rest);
        asks = true;
      } else if (line.word == "text") {
        prediction.text = line.rest;
      } else {
        throw InputError(line.place, fmt::format("'{} {}'", line.word, line.rest), "ask or text");
      }
    });
  if (!asks)
    throw InputError(place, "a question about nothing",
                     "a line 'ask colour', 'ask winner', 'ask rays' or 'ask triangle'");
  if (prediction.text.empty()) throw InputError(place, "a question without words", "a line 'text QUESTION'");
  return prediction;
}

}  // namespace ps
