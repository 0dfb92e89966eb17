#include <fmt/format.h>

#include "engine/figure.h"
#include "engine/handout.h"
#include "engine/maths_writers.h"
#include "image/svg.h"

namespace ps {
namespace {

/// Links that no reader of a page can follow are left out: options and panels are in the window alone.
std::string linked(const TextSpan& span, std::string html) {
  switch (span.link.kind) {
  case LinkKind::step:
    return fmt::format("<a href=\"#step-{}\">{}</a>", span.link.step + 1, html);
  case LinkKind::control:
    return fmt::format("<b>{}</b>", html);
  case LinkKind::none:
  case LinkKind::option:
  case LinkKind::panel:
  case LinkKind::lesson:
  case LinkKind::term:
    return html;
  }
  return html;
}

std::string span_html(const TextSpan& span) {
  if (span.formula) return mathml(*span.formula);
  const std::string text = xml_escaped(span.text);
  switch (span.style) {
  case TextStyle::plain:
    return linked(span, text);
  case TextStyle::emphasis:
    return linked(span, "<em>" + text + "</em>");
  case TextStyle::strong:
    return linked(span, "<strong>" + text + "</strong>");
  case TextStyle::code:
    return linked(span, "<code>" + text + "</code>");
  }
  return {};
}

std::string_view list_of(BlockKind kind) {
  switch (kind) {
  case BlockKind::bullet:
    return "ul";
  case BlockKind::numbered:
    return "ol";
  case BlockKind::paragraph:
  case BlockKind::heading:
  case BlockKind::figure:
    break;
  }
  return {};
}

}  // namespace

std::string block_html(const std::vector<TextBlock>& blocks) {
  std::string html;
  std::string_view open;
  for (const TextBlock& block : blocks) {
    const std::string_view list = list_of(block.kind);
    if (list != open) {
      if (!open.empty()) html += fmt::format("</{}>\n", open);
      if (list == "ol")
        html += fmt::format("<ol start=\"{}\">\n", block.number);
      else if (!list.empty())
        html += "<ul>\n";
      open = list;
    }
    if (block.figure) {
      html += fmt::format("<figure class=\"drawing\" role=\"img\" aria-label=\"{}\">{}</figure>\n",
                          xml_escaped(figure_words(*block.figure)), figure_svg(*block.figure));
      continue;
    }
    std::string inside;
    for (const TextSpan& span : block.spans) inside += span_html(span);
    const std::string_view tag = !list.empty() ? "li" : block.kind == BlockKind::heading ? "h3" : "p";
    html += fmt::format("<{}>{}</{}>\n", tag, inside, tag);
  }
  if (!open.empty()) html += fmt::format("</{}>\n", open);
  return html;
}

std::string list_html(std::vector<TextBlock> lines) {
  for (TextBlock& line : lines) line.kind = BlockKind::bullet;
  return block_html(lines);
}

}  // namespace ps
