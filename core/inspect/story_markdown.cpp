#include "inspect/story_markdown.h"

#include <fmt/format.h>

#include "inspect/describe.h"
#include "math/conventions.h"
#include "options/renderer_kind.h"
#include "record/value_text.h"

namespace ps {
namespace {

/// Text in which nothing is taken for Markdown.
std::string plain(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

/// One item for each event, in the order of the story: its sentence, then all of its fields on the same line.
std::string field_lists(const PixelStory& story, const Scene& scene) {
  std::string text;
  for (const Event& event : story.events) {
    std::string fields;
    for (const FieldText& field : event_table(event, scene))
      fields += fmt::format("{}{} = {}", fields.empty() ? "" : "; ", plain(field.name), plain(field.value));
    text += fmt::format("- **{}**: {}\n", plain(describe(event, scene)), fields);
  }
  return text;
}

std::string indent(int depth) { return std::string(static_cast<std::size_t>(depth) * 2, ' '); }

}  // namespace

std::string story_markdown(const PixelStory& story, const Scene& scene, const View& view,
                           const Provenance& provenance) {
  const Vec2i book = book_pixel(story.pixel.x, story.pixel.y, view.width, view.height);
  const auto& d = story.display;
  std::string text = fmt::format("# Pixel ({}, {}) of {}\n\n{}\n\n", story.pixel.x, story.pixel.y, plain(scene.name),
                                 plain(story.verdict));
  text += fmt::format("- picture: {} x {}, in the book's coordinates ({}, {})\n- renderer: {}\n- linear colour: {}\n- "
                      "stored as: {}, {}, {}\n\n",
                      view.width, view.height, book.x, book.y, renderer_label(story.renderer),
                      vector_text(story.linear), d[0], d[1], d[2]);
  text += "## What happened\n\n";
  std::vector<int> depth(story.events.size(), 0);
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const Event& event = story.events[i];
    if (event.parent >= 0) depth[i] = depth[static_cast<std::size_t>(event.parent)] + 1;
    text += fmt::format("{}- {}\n", indent(depth[i]), plain(describe(event, scene)));
  }
  if (story.triangles_elsewhere > 0)
    text += fmt::format("- {} triangles lie elsewhere in the picture\n", story.triangles_elsewhere);
  if (!story.not_reported.empty()) text += fmt::format("\n{}\n", plain(story.not_reported));
  text += fmt::format("\n<details>\n<summary>All fields of these {} events</summary>\n\n{}\n</details>\n",
                      story.events.size(), field_lists(story, scene));
  text += "\n## The colour as a sum\n\n| term | red | green | blue |\n|---|---:|---:|---:|\n";
  for (const LedgerLine& line : story.ledger) {
    std::string term;
    for (int level = 0; level < line.level; ++level) term += "&emsp;";
    text += fmt::format("| {}{} | {} | {} | {} |\n", term, plain(line.term), number_text(line.value.x),
                        number_text(line.value.y), number_text(line.value.z));
  }
  text += "\n## Work for this pixel\n\n| what | count |\n|---|---:|\n";
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    if (const auto count = story.counters.get(counter); count.value_or(0) > 0)
      text += fmt::format("| {} | {} |\n", plain(counter_label(counter)), *count);
  }
  text += "\n## How this was made\n\n" + provenance_markdown(provenance);
  return text;
}

}  // namespace ps
