#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include "base/spelling.h"
#include "engine/maths.h"
#include "engine/maths_signs.h"
#include "engine/place_in_text.h"

namespace ps {
namespace {

constexpr std::size_t longest_notation = 2000;
constexpr int deepest_nesting = 16;
constexpr std::size_t most_columns = 16;

/// Commands with arguments, or of a form of their own; those for one sign are in maths_signs.cpp.
constexpr std::array<std::string_view, 19> structures{"frac", "sqrt", "vec",   "hat",   "bar", "mathbf",       "mathrm",
                                                      "text", "left", "right", "begin", "end", "operatorname", ",",
                                                      ";",    " ",    "quad",  "|",     "\\"};

struct MathsEnvironment {
  std::string_view name, opening, closing;
  MathsAlignment alignment = MathsAlignment::centre;
};
constexpr std::array<MathsEnvironment, 5> environments{{{"matrix", "", ""},
                                                        {"pmatrix", "(", ")"},
                                                        {"bmatrix", "[", "]"},
                                                        {"vmatrix", "|", "|"},
                                                        {"cases", "{", "", MathsAlignment::left}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Recursive descent over the bytes of the notation.
class FormulaReader {
 public:
  FormulaReader(std::string_view text, const SourcePlace& start) : text_(text), start_(start) {}

  MathsRow read() {
    if (text_.size() > longest_notation)
      refuse(0, fmt::format("a formula of {} bytes", text_.size()), fmt::format("at most {}", longest_notation));
    MathsRow row = read_row();
    if (at_ < text_.size()) refuse_end();
    if (row.empty()) refuse(0, "an empty formula", "something between the dollar signs");
    return row;
  }

 private:
  [[noreturn]] void refuse(std::size_t at, std::string found, std::string expected) const {
    throw InputError(place_in(text_, at, start_), std::move(found), std::move(expected));
  }

  /// The end of a row is there, but no row that it could end.
  [[noreturn]] void refuse_end() const {
    switch (text_[at_]) {
    case '}':
      refuse(at_, "'}' without its '{'", "'\\}' for the sign itself");
    case '&':
      refuse(at_, "'&' outside a matrix", "\\begin{matrix} before it");
    default:
      refuse(at_, fmt::format("'{}' without its partner", text_.substr(at_, command_end(at_) - at_)),
             "\\left before \\right, \\begin before \\end and '\\\\'");
    }
  }

  bool more() const { return at_ < text_.size(); }

  void skip_blanks() {
    while (more() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  /// The end of the command whose backslash is at `from`: letters, or one other sign.
  std::size_t command_end(std::size_t from) const {
    std::size_t end = from + 1;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    return std::min(end == from + 1 ? end + 1 : end, text_.size());
  }

  std::string_view command_here() const {
    if (!more() || text_[at_] != '\\') return {};
    return text_.substr(at_ + 1, command_end(at_) - at_ - 1);
  }

  bool row_ends() const {
    if (!more()) return true;
    if (text_[at_] == '}' || text_[at_] == '&' || (in_degree_ && text_[at_] == ']')) return true;
    const std::string_view command = command_here();
    return command == "right" || command == "end" || command == "\\";
  }

  MathsRow read_row() {
    MathsRow row;
    for (skip_blanks(); !row_ends(); skip_blanks()) row.push_back(read_with_scripts());
    return row;
  }

  MathsNode read_with_scripts() {
    const std::size_t begin = at_;
    const char first = text_[at_];
    if (first == '^' || first == '_' || first == '\'')
      refuse(begin, fmt::format("'{}' without a base", first), "a sign or {...} before it");
    MathsNode base = read_atom();
    MathsScripts scripts;
    bool has_super = false;
    for (skip_blanks(); more(); skip_blanks()) {
      const std::size_t at = at_;
      const char c = text_[at_];
      if (c == '\'') {
        if (has_super) refuse(at, "a prime behind a superscript", "the prime first");
        for (; more() && text_[at_] == '\''; ++at_) scripts.super.push_back({MathsSign{"′"}});
      } else if (c == '^') {
        if (has_super) refuse(at, "a second superscript", "{...} around the first one");
        has_super = true;
        for (MathsNode& node : read_argument("^")) scripts.super.push_back(std::move(node));
      } else if (c == '_') {
        if (!scripts.sub.empty()) refuse(at, "a second subscript", "{...} around the first one");
        scripts.sub = read_argument("_");
      } else {
        break;
      }
    }
    if (scripts.sub.empty() && scripts.super.empty()) return base;
    scripts.base.push_back(std::move(base));
    return {std::move(scripts)};
  }

  /// The argument of a command or a script: {...}, or one sign.
  MathsRow read_argument(std::string_view of) {
    const Nesting nesting(*this, at_);
    if (of == "^" || of == "_") ++at_;
    skip_blanks();
    if (row_ends()) refuse(std::min(at_, text_.size()), "nothing", fmt::format("{{...}} or a sign behind '{}'", of));
    if (text_[at_] == '{') return read_braces();
    if (text_[at_] == '^' || text_[at_] == '_' || text_[at_] == '\'')
      refuse(at_, fmt::format("'{}'", text_[at_]), fmt::format("{{...}} or a sign behind '{}'", of));
    MathsRow row;
    if (is_digit(text_[at_]))
      row.push_back({MathsSign{std::string(1, text_[at_++])}});  // x^12 is x^1 and 2, as in LaTeX
    else
      row.push_back(read_atom());
    return row;
  }

  MathsRow read_braces() {
    const std::size_t open = at_++;
    const Nesting nesting(*this, open);
    const bool outer = std::exchange(in_degree_, false);
    MathsRow row = read_row();
    in_degree_ = outer;
    if (!more()) refuse(open, "'{' without its '}'", "'\\{' for the sign itself");
    if (text_[at_] != '}') refuse_end();
    ++at_;
    if (row.empty()) refuse(open, "empty braces", "something between them");
    return row;
  }

  MathsNode read_atom() {
    const std::size_t begin = at_;
    const char c = text_[at_];
    if (c == '\\') return read_command();
    if (c == '{') return {MathsGroup{read_braces()}};
    if (is_letter(c)) {
      ++at_;
      return {MathsSign{std::string(1, c), MathsStyle::italic}};
    }
    if (is_digit(c)) return {MathsSign{read_number()}};
    if (auto sign = sign_of_byte(c)) {
      ++at_;
      return {std::move(*sign)};
    }
    refuse_character(begin);
  }

  std::string read_number() {
    const std::size_t begin = at_;
    while (more() && is_digit(text_[at_])) ++at_;
    if (at_ + 1 < text_.size() && text_[at_] == '.' && is_digit(text_[at_ + 1]))
      for (++at_; more() && is_digit(text_[at_]);) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  [[noreturn]] void refuse_character(std::size_t at) const {
    std::size_t end = at + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0u) == 0x80u) ++end;
    const std::string_view character = text_.substr(at, end - at);
    const bool printable = static_cast<unsigned char>(character[0]) >= 0x20;
    const std::string found = printable ? fmt::format("'{}'", character) : "a control character";
    const std::string_view command = command_of_character(character == "*" ? "·" : character);
    if (!command.empty()) refuse(at, found, fmt::format("'\\{}'", command));
    refuse(at, found, "letters, digits, + - = < > / ( ) [ ] | , ; : . ! ? and commands");
  }

  MathsNode read_command() {
    const std::size_t begin = at_;
    const std::string_view name = command_here();
    if (name.empty()) refuse(begin, "'\\' at the end", "a command behind it");
    at_ = command_end(at_);
    if (name == "frac") return read_fraction(name);
    if (name == "sqrt") return read_root(name);
    if (name == "vec") return {MathsAccented{MathsAccent::vector, read_argument(name)}};
    if (name == "hat") return {MathsAccented{MathsAccent::hat, read_argument(name)}};
    if (name == "bar") return {MathsAccented{MathsAccent::bar, read_argument(name)}};
    if (name == "mathbf") return read_in_style(name, MathsStyle::bold);
    if (name == "mathrm") return read_in_style(name, MathsStyle::upright);
    if (name == "text") return {MathsWords{std::string(read_verbatim(name))}};
    if (name == "operatorname")
      return {MathsSign{std::string(read_verbatim(name)), MathsStyle::upright, MathsRole::function}};
    if (name == "left") return read_fence(begin);
    if (name == "begin") return read_matrix(begin);
    if (name == ",") return {MathsSpace{3.0 / 18}};
    if (name == ";") return {MathsSpace{5.0 / 18}};
    if (name == " ") return {MathsSpace{4.0 / 18}};
    if (name == "quad") return {MathsSpace{1}};
    if (name == "|") return {MathsSign{"‖"}};
    if (const SignCommand* command = find_sign_command(name)) return {command->sign};
    refuse_command(begin, name);
  }

  [[noreturn]] void refuse_command(std::size_t at, std::string_view name) const {
    std::vector<std::string_view> known(structures.begin(), structures.end());
    for (const SignCommand& each : sign_commands()) known.push_back(each.name);
    const std::string_view similar = similar_word(name, known);
    refuse(at, fmt::format("the unknown command '\\{}'", shown_start(name)),
           similar.empty() ? "a command of the notation (chapters/README.md lists them)"
                           : fmt::format("'\\{}'", similar));
  }

  MathsNode read_fraction(std::string_view name) {
    MathsFraction fraction;
    fraction.numerator = read_argument(name);
    fraction.denominator = read_argument(name);
    return {std::move(fraction)};
  }

  MathsNode read_root(std::string_view name) {
    MathsRoot root;
    skip_blanks();
    if (more() && text_[at_] == '[') {
      const std::size_t open = at_++;
      const Nesting nesting(*this, open);
      const bool outer = std::exchange(in_degree_, true);
      root.degree = read_row();
      in_degree_ = outer;
      if (!more() || text_[at_] != ']') refuse(open, "'[' without its ']'", "the degree of the root between them");
      ++at_;
    }
    root.inside = read_argument(name);
    return {std::move(root)};
  }

  /// Letters and digits in one style.
  MathsNode read_in_style(std::string_view name, MathsStyle style) {
    const std::size_t begin = at_;
    MathsGroup group{read_argument(name)};
    for (MathsNode& node : group.inside) {
      auto* sign = std::get_if<MathsSign>(&node.what);
      if (!sign) refuse(begin, fmt::format("more than letters in '\\{}'", name), "letters and digits");
      sign->style = style;
    }
    if (group.inside.size() == 1) return std::move(group.inside.front());
    return {std::move(group)};
  }

  /// The bytes between braces as they are.
  std::string_view read_verbatim(std::string_view name) {
    skip_blanks();
    if (!more() || text_[at_] != '{')
      refuse(std::min(at_, text_.size()), "nothing", fmt::format("{{...}} behind '\\{}'", name));
    const std::size_t open = at_;
    const std::size_t close = text_.find('}', open);
    if (close == std::string_view::npos) refuse(open, "'{' without its '}'", "'}' behind the words");
    const std::string_view inside = text_.substr(open + 1, close - open - 1);
    for (std::size_t i = 0; i < inside.size(); ++i)
      if (inside[i] == '\\' || inside[i] == '{' || static_cast<unsigned char>(inside[i]) < 0x20)
        refuse(open + 1 + i,
               fmt::format("'{}' in '\\{}'",
                           inside[i] == '\\'  ? "\\"
                           : inside[i] == '{' ? "{"
                                              : "\\n",
                           name),
               "words alone");
    if (inside.empty()) refuse(open, "empty braces", "words between them");
    at_ = close + 1;
    return inside;
  }

  std::string read_delimiter(std::string_view of) {
    skip_blanks();
    const std::size_t begin = at_;
    if (more() && text_[at_] == '\\') {
      const std::string_view name = command_here();
      at_ = command_end(at_);
      if (name == "|") return "‖";
      const SignCommand* command = find_sign_command(name);
      if (command && (command->sign.role == MathsRole::opening || command->sign.role == MathsRole::closing))
        return command->sign.text;
    } else if (more()) {
      const char byte = text_[at_++];
      if (byte == '.') return {};
      if (std::string_view("()[]|").find(byte) != std::string_view::npos) return std::string(1, byte);
    }
    refuse(std::min(begin, text_.size()), "no delimiter",
           fmt::format("( ) [ ] | \\{{ \\}} \\| \\lvert \\lVert \\lfloor \\lceil \\langle or . behind '\\{}'", of));
  }

  MathsNode read_fence(std::size_t begin) {
    MathsFence fence;
    fence.opening = read_delimiter("left");
    const Nesting nesting(*this, begin);
    const bool outer = std::exchange(in_degree_, false);
    fence.inside = read_row();
    in_degree_ = outer;
    if (command_here() != "right")
      refuse(begin, "'\\left' without its '\\right'", "'\\right' and a delimiter, or '\\right.' for none");
    at_ = command_end(at_);
    fence.closing = read_delimiter("right");
    return {std::move(fence)};
  }

  const MathsEnvironment& environment_named(std::string_view name, std::size_t at) const {
    std::vector<std::string_view> known;
    for (const MathsEnvironment& each : environments) {
      if (each.name == name) return each;
      known.push_back(each.name);
    }
    refuse(at, fmt::format("the environment '{}'", shown_start(name)), expected_word(name, known));
  }

  MathsNode read_matrix(std::size_t begin) {
    const std::size_t name_at = at_;
    const std::string_view name = read_verbatim("begin");
    const MathsEnvironment& environment = environment_named(name, name_at);
    MathsMatrix matrix{std::string(environment.opening), std::string(environment.closing), environment.alignment, {}};
    const Nesting nesting(*this, begin);
    const bool outer = std::exchange(in_degree_, false);
    matrix.rows.emplace_back();
    while (true) {
      matrix.rows.back().push_back(read_row());
      if (matrix.rows.back().size() > most_columns)
        refuse(at_, "a wide matrix", fmt::format("at most {} columns", most_columns));
      if (more() && text_[at_] == '&') {
        ++at_;
        continue;
      }
      const std::string_view command = command_here();
      if (command == "end") break;
      if (command != "\\")
        refuse(begin, fmt::format("'\\begin{{{}}}' without its end", name), fmt::format("'\\end{{{}}}'", name));
      at_ = command_end(at_);
      matrix.rows.emplace_back();
    }
    in_degree_ = outer;
    const std::size_t end = at_;
    at_ = command_end(at_);
    if (read_verbatim("end") != name) refuse(end, "the end of another environment", fmt::format("'\\end{{{}}}'", name));
    finish_matrix(matrix, begin);
    return {std::move(matrix)};
  }

  /// An empty line behind the last '\\' is not a row.
  void finish_matrix(MathsMatrix& matrix, std::size_t begin) const {
    if (matrix.rows.size() > 1 && matrix.rows.back().size() == 1 && matrix.rows.back().front().empty())
      matrix.rows.pop_back();
    for (const auto& row : matrix.rows)
      if (row.size() != matrix.rows.front().size())
        refuse(begin, fmt::format("rows of {} and {} cells", matrix.rows.front().size(), row.size()),
               "equally many in each row");
  }

  /// Counts how deep the reader is, since bytes from outside must not exhaust the stack.
  class Nesting {
   public:
    Nesting(FormulaReader& reader, std::size_t at) : reader_(reader) {
      if (++reader_.depth_ > deepest_nesting)
        reader_.refuse(at, "a formula nested too deeply", fmt::format("at most {} levels", deepest_nesting));
    }
    ~Nesting() { --reader_.depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    FormulaReader& reader_;
  };

  std::string_view text_;
  SourcePlace start_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool in_degree_ = false;  // of a root, which ends at ']'
};

}  // namespace

Formula read_formula(std::string_view notation, FormulaForm form, const SourcePlace& start) {
  return {std::string(notation), form, FormulaReader(notation, start).read()};
}

}  // namespace ps
