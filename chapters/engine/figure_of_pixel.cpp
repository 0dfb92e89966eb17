#include <fmt/format.h>

#include <algorithm>

#include "engine/figure.h"

namespace ps {

std::shared_ptr<const Figure> figure_of_pixel(const std::shared_ptr<const Figure>& figure, const PixelStory* story) {
  if (!figure || figure->of_pixel.empty() || !story) return figure;
  const auto lacking = std::find_if(figure->of_pixel.begin(), figure->of_pixel.end(),
                                    [&](const FigureNumber& number) { return !number_at(number, *story); });
  std::string reason = "lies outside this figure";
  if (lacking != figure->of_pixel.end()) {
    reason = "has no " + field_query_words(lacking->query);
  } else {
    const FigureSource& source = figure->source;
    try {
      return std::make_shared<const Figure>(read_figure(source.text, source.file, source.first_line, story));
    } catch (const InputError&) {  // such as an angle beyond a kind's range
    }
  }
  auto own = std::make_shared<Figure>(*figure);
  own->note = fmt::format("Pixel ({}, {}) {}. So this is drawn for the step's own pixel.", story->pixel.x,
                          story->pixel.y, reason);
  return own;
}

std::string figure_words(const Figure& figure) {
  return figure.note.empty() ? figure.description : figure.description + " " + figure.note;
}

}  // namespace ps
