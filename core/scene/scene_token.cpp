#include "scene/scene_token.h"

#include <fmt/format.h>

namespace ps {
namespace {

constexpr std::string_view punctuation = "{}()[]=,<>";
constexpr std::string_view blanks = " \t\f\v";

class Lexer {
 public:
  Lexer(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::vector<SceneToken> run() {
    if (text_.substr(0, 2) == "\xFF\xFE" || text_.substr(0, 2) == "\xFE\xFF")
      throw InputError({file_, 1, 1}, "UTF-16 text", "UTF-8 text");
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    while (at_ < text_.size()) {
      next();
      if (tokens_.size() > max_scene_tokens)
        throw InputError({file_, line_, column_}, fmt::format("more than {} words and marks", max_scene_tokens),
                         "a smaller scene file; large models can be OBJ files");
    }
    begin(SceneToken::Kind::end);
    return std::move(tokens_);
  }

 private:
  void next() {
    const char c = text_[at_];
    if (c == '\n' || c == '\r') return end_line();
    if (blanks.find(c) != std::string_view::npos) return step();
    if (c == '#') {
      while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') step();
      return;
    }
    if (c == '"') return quoted();
    if (punctuation.find(c) != std::string_view::npos) {
      begin(SceneToken::Kind::punctuation).text = c;
      return step();
    }
    word();
  }

  void word() {
    SceneToken& token = begin(SceneToken::Kind::word);
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n' || c == '\r' || c == '#' || c == '"') break;
      if (blanks.find(c) != std::string_view::npos || punctuation.find(c) != std::string_view::npos) break;
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
        throw InputError({file_, line_, column_}, fmt::format("the control character 0x{:02X}", int{c}), "text");
      token.text += c;
      step();
    }
  }

  void quoted() {
    SceneToken& token = begin(SceneToken::Kind::quoted);
    step();
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') {
      const char c = text_[at_];
      step();
      if (c == '"') return;
      if (static_cast<unsigned char>(c) < 0x20 && c != '\t')
        throw InputError({file_, line_, column_ - 1}, fmt::format("the control character 0x{:02X}", int{c}), "text");
      if (c == '\\' && at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\\')) {
        token.text += text_[at_];
        step();
      } else {
        token.text += c;
      }
    }
    throw InputError({file_, token.line, token.column}, "a quotation mark that is not closed",
                     "a closing quotation mark on the same line");
  }

  SceneToken& begin(SceneToken::Kind kind) {
    tokens_.push_back({kind, {}, line_, column_});
    return tokens_.back();
  }
  void step() {
    ++at_;
    // The following bytes of a UTF-8 character belong to its one column.
    if (at_ >= text_.size() || (static_cast<unsigned char>(text_[at_]) & 0xC0) != 0x80) ++column_;
  }
  void end_line() {
    at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    ++line_;
    column_ = 1;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
  std::vector<SceneToken> tokens_;
};

}  // namespace

std::string SceneToken::shown() const {
  if (kind == Kind::end) return "the end of the file";
  constexpr std::size_t longest = 60;
  return text.size() > longest ? fmt::format("'{}...'", text.substr(0, longest)) : fmt::format("'{}'", text);
}

std::vector<SceneToken> scene_tokens(std::string_view text, const std::string& file) { return Lexer(text, file).run(); }

}  // namespace ps
