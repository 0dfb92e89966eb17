#include "engine/markdown.h"

#include <fmt/format.h>
#include <md4c.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "base/spelling.h"
#include "engine/formula_marks.h"
#include "engine/glossary.h"
#include "engine/maths_writers.h"
#include "engine/place_in_text.h"
#include "options/option.h"

namespace ps {
namespace {

constexpr unsigned markdown_flags =
    MD_FLAG_COLLAPSEWHITESPACE | MD_FLAG_NOHTML | MD_FLAG_NOINDENTEDCODEBLOCKS | MD_FLAG_WIKILINKS;
constexpr std::string_view blanks = " \t\r\n";

/// Makes blocks of what md4c reports. That reports no positions, but its texts point into what it reads: the source
/// with its formulas hidden.
class MarkdownReader {
 public:
  MarkdownReader(std::string_view source, const SourcePlace& start)
      : source_(source), start_(start), formulas_(find_formulas(source, start)),
        hidden_(hide_formulas(source, formulas_)), text_(hidden_) {}

  StepText read() {
    MD_PARSER parser{};
    parser.flags = markdown_flags;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) {
      return guarded(self, [&](MarkdownReader& reader) { reader.enter_block(type, detail); });
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) {
      return guarded(self, [&](MarkdownReader& reader) { reader.leave_block(type); });
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) {
      return guarded(self, [&](MarkdownReader& reader) { reader.enter_span(type, detail); });
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* self) {
      return guarded(self, [&](MarkdownReader& reader) { reader.leave_span(type); });
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* self) {
      return guarded(self, [&](MarkdownReader& reader) { reader.add_text(type, {text, size}); });
    };
    const int ended = md_parse(text_.data(), static_cast<MD_SIZE>(text_.size()), &parser, this);
    if (error_) std::rethrow_exception(error_);
    if (ended != 0) throw InputError(start_, "text that cannot be read", "CommonMark");
    return std::move(result_);
  }

 private:
  /// Exceptions may not pass through C: the first one is kept, and md4c is stopped.
  template <class Step>
  static int guarded(void* self, Step step) {
    auto& reader = *static_cast<MarkdownReader*>(self);
    if (reader.error_) return 1;  // md4c still closes what is open
    try {
      step(reader);
      return 0;
    } catch (...) {
      reader.error_ = std::current_exception();
      return 1;
    }
  }

  SourcePlace place_of(std::size_t offset) const { return place_in(source_, offset, start_); }

  /// The next sign behind what was read.
  SourcePlace next_place() const { return place_of(std::min(text_.find_first_not_of(blanks, read_to_), text_.size())); }

  [[noreturn]] void refuse(std::string_view found, std::string_view expected = "text, lists, quotes and links") const {
    throw InputError(next_place(), std::string(found), std::string(expected));
  }

  void enter_block(MD_BLOCKTYPE type, void* detail) {
    switch (type) {
    case MD_BLOCK_DOC:
      return;
    case MD_BLOCK_QUOTE:
      if (in_quote_ || list_) refuse("a quote inside another or in a list");
      in_quote_ = true;
      return;
    case MD_BLOCK_UL:
    case MD_BLOCK_OL:
      if (list_) refuse("a list inside a list");
      if (in_quote_) refuse("a list in a quote", "one quote for each hint");
      list_ = type == MD_BLOCK_UL ? BlockKind::bullet : BlockKind::numbered;
      if (type == MD_BLOCK_OL)
        number_ = static_cast<int>(std::min(static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start, 9999u));
      return;
    case MD_BLOCK_LI:
      item_begun_ = false;
      return begin(*list_);
    case MD_BLOCK_P:
      if (!list_) return begin(BlockKind::paragraph);
      if (item_begun_) refuse("a second paragraph in one item");
      return;
    case MD_BLOCK_H:
      if (list_ || in_quote_) refuse("a heading in a list or a quote");
      if (static_cast<MD_BLOCK_H_DETAIL*>(detail)->level < 3)
        refuse("a heading of level 1 or 2 within a step", "'###' before a heading");
      return begin(BlockKind::heading);
    case MD_BLOCK_HR:
      refuse("a line across");
    case MD_BLOCK_CODE:
      refuse("a block of code", "```settings, ```claim, ```question or ```notes");
    case MD_BLOCK_HTML:
    case MD_BLOCK_TABLE:
    case MD_BLOCK_THEAD:
    case MD_BLOCK_TBODY:
    case MD_BLOCK_TR:
    case MD_BLOCK_TH:
    case MD_BLOCK_TD:
      refuse("HTML or a table");
    }
  }

  void leave_block(MD_BLOCKTYPE type) {
    switch (type) {
    case MD_BLOCK_QUOTE:
      in_quote_ = false;
      return;
    case MD_BLOCK_UL:
    case MD_BLOCK_OL:
      list_.reset();
      return;
    case MD_BLOCK_P:
      item_begun_ = true;
      if (!list_) end();
      return;
    case MD_BLOCK_LI:
      ++number_;
      return end();
    case MD_BLOCK_H:
      return end();
    case MD_BLOCK_DOC:
    case MD_BLOCK_HR:
    case MD_BLOCK_CODE:
    case MD_BLOCK_HTML:
    case MD_BLOCK_TABLE:
    case MD_BLOCK_THEAD:
    case MD_BLOCK_TBODY:
    case MD_BLOCK_TR:
    case MD_BLOCK_TH:
    case MD_BLOCK_TD:
      return;
    }
  }

  void begin(BlockKind kind) {
    block_ = {};
    block_.kind = kind;
    if (kind == BlockKind::numbered) block_.number = number_;
  }

  void end() {
    if (block_.spans.empty()) refuse("an item without text");
    require_display_alone();
    (in_quote_ ? result_.hints : result_.blocks).push_back(std::move(block_));
    block_ = {};
  }

  void require_display_alone() const {
    for (const TextSpan& span : block_.spans)
      if (span.formula && span.formula->form == FormulaForm::display &&
          (block_.spans.size() > 1 || block_.kind != BlockKind::paragraph || in_quote_))
        throw InputError(display_place_, "'$$' inside a text", "a paragraph of its own, or single '$'");
  }

  void enter_span(MD_SPANTYPE type, void* detail) {
    switch (type) {
    case MD_SPAN_EM:
      return styles_.push_back(TextStyle::emphasis);
    case MD_SPAN_STRONG:
      return styles_.push_back(TextStyle::strong);
    case MD_SPAN_CODE:
      return styles_.push_back(TextStyle::code);
    case MD_SPAN_A:
      return begin_link(static_cast<MD_SPAN_A_DETAIL*>(detail)->href, parse_link);
    case MD_SPAN_WIKILINK:
      return begin_link(static_cast<MD_SPAN_WIKILINK_DETAIL*>(detail)->target, parse_control);
    case MD_SPAN_IMG:
      refuse("a picture");
    case MD_SPAN_DEL:
    case MD_SPAN_U:
      refuse("struck or underlined text");
    case MD_SPAN_LATEXMATH:  // formulas are read here, not by md4c
    case MD_SPAN_LATEXMATH_DISPLAY:
      return;
    }
  }

  template <class Parse>
  void begin_link(const MD_ATTRIBUTE& target, Parse parse) {
    try {
      link_ = parse(std::string_view(target.text, target.size));
    } catch (const InputError& error) {
      const SourcePlace place = next_place();
      throw InputError(fmt::format("{}:{}:{}: {}", place.file, place.line, place.column, error.what()));
    }
    if (link_.kind == LinkKind::step) result_.step_links.push_back({next_place(), link_.step});
    link_begin_ = block_.spans.size();
    linked_ = true;
  }

  void leave_span(MD_SPANTYPE type) {
    switch (type) {
    case MD_SPAN_A:
    case MD_SPAN_WIKILINK:
      return end_link();
    case MD_SPAN_STRONG:
      styles_.pop_back();
      return name_strong_text();
    case MD_SPAN_EM:
      styles_.pop_back();
      return name_term();
    case MD_SPAN_CODE:
      return styles_.pop_back();
    case MD_SPAN_IMG:
    case MD_SPAN_DEL:
    case MD_SPAN_U:
    case MD_SPAN_LATEXMATH:
    case MD_SPAN_LATEXMATH_DISPLAY:
      return;
    }
  }

  void end_link() {
    linked_ = false;
    if (block_.spans.size() == link_begin_) refuse("a link without words");
    if (link_.kind == LinkKind::control) {  // what is between the brackets is a key, not words
      block_.spans.resize(link_begin_);
      block_.spans.push_back({std::string(find_option(link_.target)->label), TextStyle::plain, link_});
    }
    link_ = {};
  }

  /// The name of an option or a panel in bold leads there.
  void name_strong_text() {
    if (block_.spans.empty() || linked_) return;
    TextSpan& last = block_.spans.back();
    if (last.style == TextStyle::strong && last.link.kind == LinkKind::none) last.link = link_of_name(last.text);
  }

  /// A term of the glossary in emphasis leads there.
  void name_term() {
    if (block_.spans.empty() || linked_) return;
    TextSpan& last = block_.spans.back();
    if (last.style != TextStyle::emphasis || last.formula || last.link.kind != LinkKind::none) return;
    if (std::string term = term_of(last.text); !term.empty()) last.link = {LinkKind::term, std::move(term), 0, {}};
  }

  TextStyle style() const {
    return styles_.empty() ? TextStyle::plain : *std::max_element(styles_.begin(), styles_.end());
  }

  void add_text(MD_TEXTTYPE type, std::string_view text) {
    const bool ours = !text.empty() && text.data() >= text_.data() && text.data() < text_.data() + text_.size();
    const std::size_t at = ours ? static_cast<std::size_t>(text.data() - text_.data()) : read_to_;
    switch (type) {
    case MD_TEXT_NORMAL:
      if (ours)
        append_with_formulas(text, at);
      else
        append(text);
      break;
    case MD_TEXT_CODE:
      append(text);
      break;
    case MD_TEXT_SOFTBR:
      append(" ");
      break;
    case MD_TEXT_BR:
      refuse("a line break", "an empty line between paragraphs");
    case MD_TEXT_NULLCHAR:
    case MD_TEXT_ENTITY:
    case MD_TEXT_HTML:
    case MD_TEXT_LATEXMATH:
      throw InputError(place_of(at),
                       fmt::format("'{}'", type == MD_TEXT_NULLCHAR ? std::string("\\0") : shown_start(text)),
                       "plain text");
    }
    if (ours) read_to_ = std::max(read_to_, at + text.size());
  }

  /// A sign that md4c leaves as text although it is a mark: its partner is missing.
  void require_no_loose_marks(std::string_view text, std::size_t at) const {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (std::string_view("*`[]$").find(text[i]) == std::string_view::npos) continue;
      const std::size_t place = at + i;
      if (place > 0 && text_[place - 1] == '\\') continue;
      throw InputError(place_of(place), fmt::format("'{}' without its partner", text[i]),
                       fmt::format("'\\{}' for the sign itself", text[i]));
    }
  }

  /// A text of the source, from byte `at`.
  void append_with_formulas(std::string_view text, std::size_t at) {
    require_no_loose_marks(text, at);
    while (!text.empty()) {
      const std::size_t hidden = std::min(text.find(hidden_byte), text.size());
      if (hidden > 0) append(text.substr(0, hidden));
      text.remove_prefix(hidden);
      at += hidden;
      if (text.empty()) return;
      const auto mark = std::find_if(formulas_.begin(), formulas_.end(),
                                     [&](const FormulaMark& each) { return at >= each.begin && at < each.end; });
      if (at == mark->begin) add_formula(*mark);
      const std::size_t length = std::min(mark->end - at, text.size());
      text.remove_prefix(length);
      at += length;
    }
  }

  void add_formula(const FormulaMark& mark) {
    const SourcePlace place = place_of(mark.begin + mark.sign_length());
    TextSpan span{{}, style(), link_};
    span.formula = read_formula(mark.notation(source_), mark.form, place);
    span.text = plain_maths(*span.formula);
    if (mark.form == FormulaForm::display) display_place_ = place_of(mark.begin);
    block_.spans.push_back(std::move(span));
  }

  void append(std::string_view text) {
    const bool same = !block_.spans.empty() && block_.spans.size() > (linked_ ? link_begin_ : 0) &&
                      block_.spans.back().style == style() && block_.spans.back().link == link_ &&
                      !block_.spans.back().formula && (linked_ || block_.spans.back().link.kind == LinkKind::none);
    if (same)
      block_.spans.back().text += text;
    else
      block_.spans.push_back({std::string(text), style(), link_});
  }

  std::string_view source_;  // as it is in the file
  SourcePlace start_;
  std::vector<FormulaMark> formulas_;
  std::string hidden_;
  std::string_view text_;  // what md4c reads
  SourcePlace display_place_;
  std::size_t read_to_ = 0;  // of text_: the end of the last text
  StepText result_;
  TextBlock block_;
  std::optional<BlockKind> list_;
  bool in_quote_ = false, item_begun_ = false;
  int number_ = 1;
  std::vector<TextStyle> styles_;
  TextLink link_;
  bool linked_ = false;
  std::size_t link_begin_ = 0;  // of block_.spans
  std::exception_ptr error_;
};

}  // namespace

StepText read_markdown(std::string_view text, const std::string& file, int first_line) {
  static_assert(sizeof(MD_SIZE) >= 4, "a lesson's size fits");
  return MarkdownReader(text, {file, first_line, 1}).read();
}

}  // namespace ps
