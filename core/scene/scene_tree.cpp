#include "scene/scene_tree.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/scene_token.h"

namespace ps {
namespace {

using Kind = SceneTerm::Kind;

bool starts_number(const SceneToken& token) {
  return token.kind == SceneToken::Kind::word && token.text.find_first_of("0123456789") <= 2;
}

class TreeParser {
 public:
  TreeParser(std::vector<SceneToken> tokens, const std::string& file) : tokens_(std::move(tokens)), file_(file) {}

  std::vector<SceneEntry> file() {
    std::vector<SceneEntry> entries;
    while (peek().kind != SceneToken::Kind::end) entries.push_back(entry("a key"));
    return entries;
  }

 private:
  SceneEntry entry(const std::string& expected) {
    SceneEntry result;
    result.line = peek().line;
    result.column = peek().column;
    if (peek().is('(') || peek().is('[')) {
      result.value = value({});
      return result;
    }
    if (peek().kind == SceneToken::Kind::word || peek().kind == SceneToken::Kind::quoted) {
      if (peek(1).is(',')) {
        result.value = value({});
        return result;
      }
      result.key = take().text;
      if (peek().is('{')) {
        result.value = block();
        return result;
      }
      if (!peek().is('=')) fail(peek(), fmt::format("'=' or '{{' after '{}'", result.key));
      take();
      result.value = value(result.key);
      return result;
    }
    fail(peek(), expected);
  }

  /// A whole value: one term, a size, or terms with commas between them.
  SceneTerm value(const std::string& key) {
    SceneTerm first = term(key);
    // "radius = color = red": the second word is a key, and radius has no value.
    const bool is_key =
        (first.kind == Kind::word || first.kind == Kind::quoted) && !key.empty() && (peek().is('=') || peek().is('{'));
    if (is_key)
      throw InputError({file_, first.line, first.column}, first.shown(), fmt::format("a value for '{}'", key));
    if (first.kind == Kind::word && peek().kind == SceneToken::Kind::word && peek().text == "x" &&
        starts_number(peek(1))) {
      take();
      return group(Kind::size, std::move(first), term(key));
    }
    if (!peek().is(',')) return first;
    SceneTerm sequence;
    sequence.kind = Kind::sequence;
    sequence.line = first.line;
    sequence.column = first.column;
    sequence.items.push_back(std::move(first));
    while (peek().is(',')) {
      take();
      sequence.items.push_back(term(key));
    }
    return sequence;
  }

  SceneTerm term(const std::string& key) {
    const SceneToken& token = peek();
    if (token.is('{')) return block();
    if (token.is('(')) return enclosed(Kind::tuple, ')');
    if (token.is('[')) return enclosed(Kind::list, ']');
    if (token.is('<')) return rotation();
    if (token.kind != SceneToken::Kind::word && token.kind != SceneToken::Kind::quoted)
      fail(token, key.empty() ? "a value" : fmt::format("a value for '{}'", key));
    if (token.kind == SceneToken::Kind::word && token.text == "linear" && peek(1).is('(')) {
      SceneTerm result = start(Kind::linear);
      take();
      result.items = enclosed(Kind::tuple, ')').items;
      return result;
    }
    SceneTerm result = start(token.kind == SceneToken::Kind::word ? Kind::word : Kind::quoted);
    result.text = take().text;
    return result;
  }

  SceneTerm enclosed(Kind kind, char close) {
    const Nesting nesting(*this);
    SceneTerm result = start(kind);
    const SceneToken open = take();
    while (!peek().is(close)) {
      if (!result.items.empty()) {
        if (!peek().is(',')) fail_inside(open, fmt::format("',' or '{}'", close));
        take();
      }
      if (peek().kind == SceneToken::Kind::end) fail_inside(open, fmt::format("'{}'", close));
      result.items.push_back(term({}));
    }
    take();
    return result;
  }

  SceneTerm rotation() {
    SceneTerm result = start(Kind::rotation);
    const SceneToken open = take();
    while (!peek().is('>')) {
      if (peek().kind != SceneToken::Kind::word) fail_inside(open, "'>'");
      result.items.push_back(term({}));
    }
    take();
    return result;
  }

  SceneTerm block() {
    const Nesting nesting(*this);
    SceneTerm result = start(Kind::block);
    const SceneToken open = take();
    while (!peek().is('}')) {
      if (peek().kind == SceneToken::Kind::end) fail_inside(open, "'}'");
      result.entries.push_back(entry("a key or '}'"));
    }
    take();
    return result;
  }

  SceneTerm start(Kind kind) const {
    SceneTerm term;
    term.kind = kind;
    term.line = peek().line;
    term.column = peek().column;
    return term;
  }
  static SceneTerm group(Kind kind, SceneTerm a, SceneTerm b) {
    SceneTerm result;
    result.kind = kind;
    result.line = a.line;
    result.column = a.column;
    result.items.push_back(std::move(a));
    result.items.push_back(std::move(b));
    return result;
  }

  const SceneToken& peek(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  const SceneToken& take() {
    const SceneToken& token = peek();
    if (at_ + 1 < tokens_.size()) ++at_;
    return token;
  }

  [[noreturn]] void fail(const SceneToken& token, const std::string& expected) const {
    throw InputError({file_, token.line, token.column}, token.shown(), expected);
  }
  /// At the end of the file the place that helps is where the brace was opened.
  [[noreturn]] void fail_inside(const SceneToken& open, const std::string& expected) const {
    if (peek().kind != SceneToken::Kind::end) fail(peek(), expected);
    throw InputError({file_, open.line, open.column}, fmt::format("{} that is not closed", open.shown()),
                     fmt::format("{} before the end of the file", expected));
  }

  /// Counts open brackets, so that a file of a million of them is an error and no stack overflow.
  class Nesting {
   public:
    explicit Nesting(TreeParser& parser) : parser_(parser) {
      if (++parser_.depth_ > max_scene_nesting)
        parser_.fail(parser_.peek(), fmt::format("at most {} nested brackets", max_scene_nesting));
    }
    ~Nesting() { --parser_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    TreeParser& parser_;
  };

  std::vector<SceneToken> tokens_;
  const std::string& file_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

std::string joined(const std::vector<SceneTerm>& items, std::string_view between) {
  std::string text;
  for (std::size_t i = 0; i < items.size() && i < 5; ++i) {
    if (i > 0) text += between;
    text += items[i].kind == Kind::word || items[i].kind == Kind::quoted ? items[i].text : "...";
  }
  return items.size() > 5 ? text + std::string(between) + "..." : text;
}

}  // namespace

std::string SceneTerm::shown() const {
  std::string result;
  switch (kind) {
  case Kind::word:
  case Kind::quoted:
    result = text;
    break;
  case Kind::tuple:
    result = fmt::format("({})", joined(items, ", "));
    break;
  case Kind::list:
    result = fmt::format("[{}]", joined(items, ", "));
    break;
  case Kind::sequence:
    result = joined(items, ", ");
    break;
  case Kind::size:
    result = joined(items, " x ");
    break;
  case Kind::rotation:
    result = fmt::format("<{}>", joined(items, " "));
    break;
  case Kind::linear:
    result = fmt::format("linear ({})", joined(items, ", "));
    break;
  case Kind::block:
    return "a block";
  }
  constexpr std::size_t longest = 80;
  if (result.size() > longest) result = result.substr(0, longest) + "...";
  return fmt::format("'{}'", result);
}

std::vector<SceneEntry> scene_tree(std::string_view text, const std::string& file) {
  return TreeParser(scene_tokens(text, file), file).file();
}

}  // namespace ps
