#include <cmath>
#include <vector>

#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

struct Span {
  std::string_view text;
  Face face = Face::body;
};

/// Parts a line at **bold** and `code`. A mark without its partner is kept as text.
std::vector<Span> spans_of(std::string_view line, Face plain) {
  std::vector<Span> spans;
  while (!line.empty()) {
    const auto bold = line.find("**"), code = line.find('`');
    const auto mark = std::min(bold, code);
    const std::string_view fence = mark == bold ? "**" : "`";
    const auto close = mark == std::string_view::npos ? mark : line.find(fence, mark + fence.size());
    if (close == std::string_view::npos) {
      spans.push_back({line, plain});
      break;
    }
    if (mark > 0) spans.push_back({line.substr(0, mark), plain});
    const auto begin = mark + fence.size();
    spans.push_back({line.substr(begin, close - begin), mark == bold ? Face::bold : Face::mono});
    line.remove_prefix(close + fence.size());
  }
  return spans;
}

/// Sets words one after another and breaks lines at spaces, across changes of face.
class Typesetter {
 public:
  Typesetter(float left, float right, float line_height) : left_(left), right_(right), line_height_(line_height) {
    x_ = left;
    y_ = ImGui::GetCursorScreenPos().y;
  }
  void set(const Span& span) {
    const FontScope face(span.face);
    const ImVec4& colour = palette().text;
    std::size_t at = 0;
    while (at < span.text.size()) {
      const auto space = span.text.find(' ', at);
      const std::string_view word = span.text.substr(at, space == std::string_view::npos ? space : space - at);
      const float width = text_width(word);
      if (x_ + width > right_ && x_ > left_) new_line();
      const float drop = (line_height_ - ImGui::GetFontSize()) / 2;
      if (span.face == Face::mono && !word.empty())
        ImGui::GetWindowDrawList()->AddRectFilled({x_ - px(2), y_ + px(1)},
                                                  {x_ + width + px(2), y_ + line_height_ - px(2)},
                                                  colour_u32(palette().field_active), px(3));
      if (!word.empty())
        ImGui::GetWindowDrawList()->AddText({std::floor(x_), std::floor(y_ + drop)}, colour_u32(colour), word.data(),
                                            word.data() + word.size());
      x_ += width;
      if (space == std::string_view::npos) break;
      if (x_ > left_ || at == 0) x_ += text_width(" ");
      at = space + 1;
    }
  }
  float bottom() const { return y_ + line_height_; }

 private:
  void new_line() {
    x_ = left_;
    y_ += line_height_;
  }
  float left_, right_, line_height_, x_, y_ = 0;
};

void set_block(std::string_view text, Face face, float indent, float line_spacing) {
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  float height = 0;
  {
    const FontScope font(face);
    height = std::floor(ImGui::GetFontSize() * line_spacing);
  }
  Typesetter setter(start.x + indent, start.x + room, height);
  for (const Span& span : spans_of(text, face)) setter.set(span);
  ImGui::Dummy({room, setter.bottom() - start.y});
}

}  // namespace

void rich_text(std::string_view markdown) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, px(2)});
  std::string paragraph;
  Face face = Face::body;
  bool bullet = false;
  const auto flush = [&] {
    if (paragraph.empty()) return;
    const float indent = bullet ? px(18) : 0;
    if (bullet) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + px(7), at.y + px(12)}, px(2.5),
                                                  colour_u32(palette().text_quiet), 12);
    }
    set_block(paragraph, face, indent, face == Face::body ? 1.2f : 1.12f);
    paragraph.clear();
    face = Face::body;
    bullet = false;
  };
  while (!markdown.empty()) {
    const auto end = markdown.find('\n');
    std::string_view line = markdown.substr(0, end);
    markdown.remove_prefix(end == std::string_view::npos ? markdown.size() : end + 1);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    if (line.empty()) {
      if (!paragraph.empty()) {
        flush();
        ImGui::Dummy({0, px(5)});
      }
    } else if (line.starts_with("# ") || line.starts_with("## ")) {
      flush();
      const bool first = line.starts_with("# ");
      face = first ? Face::heading : Face::bold;
      paragraph = line.substr(first ? 2 : 3);
      flush();
    } else if (line.starts_with("- ")) {
      flush();
      bullet = true;
      paragraph = line.substr(2);
    } else {
      if (!paragraph.empty()) paragraph += ' ';
      paragraph += line;
    }
  }
  flush();
  ImGui::PopStyleVar();
}

}  // namespace ps::gui
