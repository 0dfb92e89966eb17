#include "scene/obj_check.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "base/spelling.h"
#include "scene/obj_line.h"

namespace ps {
namespace {

constexpr int most_corners = 1000;

/// Statements that say nothing about the surface, or nothing that Pixelscope draws.
constexpr std::array<std::string_view, 13> ignored_words{
    "o", "g", "mg", "vp", "vw", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "usemap", "maplib"};
constexpr std::array<std::string_view, 9> used{"v", "vt", "vn", "f", "s", "l", "p", "usemtl", "mtllib"};
/// Free-form curves and surfaces, which programs for construction write beside faces.
constexpr std::array<std::string_view, 17> free_form{"cstype", "deg",  "bmat",  "step",  "curv", "curv2",
                                                     "surf",   "parm", "trim",  "hole",  "scrv", "sp",
                                                     "end",    "con",  "ctech", "stech", "bsp"};

std::vector<std::string_view> obj_words() {
  std::vector<std::string_view> words(used.begin(), used.end());
  words.insert(words.end(), ignored_words.begin(), ignored_words.end());
  return words;
}

/// Positive indices may name elements that come later in the file. Of those only each new largest one is kept: the
/// first that turns out to be too large is among them.
struct PendingIndex {
  long long index = 0;
  ObjLine place;
};

struct IndexList {
  std::string_view name;
  std::size_t count = 0;
  std::vector<PendingIndex> pending{};
};

class ObjChecker {
 public:
  ObjChecker(std::string& text, const std::string& file) : text_(text), file_(file) {}

  ObjSummary run() {
    const int lines = for_each_obj_line(text_, file_, [&](ObjLine& line) { statement(line); });
    for (const IndexList* list : {&positions_, &uvs_, &normals_})
      for (const PendingIndex& pending : list->pending)
        if (pending.index > static_cast<long long>(list->count)) fail_index(pending.place, pending.index, *list);
    if (summary_.faces == 0 && first_skipped_)
      first_skipped_->fail(fmt::format("'{}', which is not about polygons", first_skipped_->word()),
                           "a model of polygons (v, vt, vn, f)");
    if (summary_.faces == 0)
      throw InputError({file_, lines, 0}, fmt::format("no face in {} lines", lines), "at least one line 'f 1 2 3'");
    summary_.positions = positions_.count;
    summary_.uvs = uvs_.count;
    summary_.normals = normals_.count;
    return std::move(summary_);
  }

 private:
  void statement(ObjLine& line) {
    const std::string_view word = line.next();
    if (word.empty()) return;
    if (word == "v") return position(line);
    if (word == "vn") {
      for (int i = 0; i < 3; ++i) line.require_number();
      require_end(line, "three numbers");
      ++normals_.count;
      return;
    }
    if (word == "vt") return uv(line);
    if (word == "f") return face(line);
    if (word == "s") return smoothing(line);
    if (word == "l" || word == "p") return elements(line, word == "l" ? "lines are not drawn" : "points are not drawn");
    if (word == "usemtl") return material(line);
    if (word == "mtllib") return reference(line, summary_.material_files, "the name of a material file");
    if (std::find(free_form.begin(), free_form.end(), word) != free_form.end())
      return skip(line, "free-form curves and surfaces are not drawn");
    if (word == "call" || word == "csh") return skip(line, "other files and programs are not run");
    if (word == "fo") line.fail("'fo', the old form of 'f'", "'f'");
    if (std::find(ignored_words.begin(), ignored_words.end(), word) == ignored_words.end()) unknown(line, word);
  }

  [[noreturn]] static void unknown(const ObjLine& line, std::string_view word) {
    const std::string_view similar = similar_word(word, obj_words());
    line.fail(line.shown(),
              similar.empty() ? "a statement of model files, such as v, vt, vn or f" : fmt::format("'{}'", similar));
  }

  /// x y z, then perhaps w, or a colour, or both.
  void position(ObjLine& line) {
    for (int i = 0; i < 3; ++i) line.require_number();
    int extra = 0;
    for (; extra < 4; ++extra) {
      ObjLine ahead = line;
      if (ahead.next().empty()) break;
      line.require_number();
    }
    require_end(line, "at most 7 numbers");
    if (extra >= 3) note("vertex colours are not drawn", line);
    ++positions_.count;
  }

  /// s off, s 0, s 3; s alone is taken for off.
  void smoothing(ObjLine& line) {
    const std::string_view word = line.next();
    std::uint32_t group = 0;
    if (word.empty()) {
      note("'s' without a smoothing group is taken for 's off'", line);
    } else if (word != "off") {
      constexpr std::size_t most_digits = 9;
      if (word.size() > most_digits) line.fail(line.shown(), smoothing_form);
      for (const char c : word) {
        if (c < '0' || c > '9') line.fail(line.shown(), smoothing_form);
        group = group * 10 + static_cast<std::uint32_t>(c - '0');
      }
    }
    require_end(line, "one smoothing group");
    const std::uint32_t before = summary_.smoothing.empty() ? 0 : summary_.smoothing.back().group;
    if (group != before) summary_.smoothing.push_back({summary_.faces, group});
  }
  static constexpr const char* smoothing_form = "off or the number of a smoothing group";

  /// Lines and points: nothing draws them, but what follows may be meant as a face.
  void elements(ObjLine& line, const char* what) {
    if (line.next().empty()) line.fail(line.shown(), "a vertex index");
    note(what, line);
  }

  /// usemtl NAME; without a name, what follows has none.
  void material(ObjLine& line) {
    ObjLine ahead = line;
    auto& without = summary_.without_material;
    const bool replaces = !without.empty() && without.back() == summary_.faces;
    if (ahead.next().empty()) {
      note("'usemtl' without a name is taken for no material", line);
      if (!replaces) without.push_back(summary_.faces);
      return;
    }
    if (replaces) without.pop_back();
    reference(line, summary_.used_materials, "the name of a material");
  }

  void skip(const ObjLine& line, const char* what) {
    if (!first_skipped_) first_skipped_ = line;
    note(what, line);
  }

  void note(const char* what, const ObjLine& line) {
    const bool known = std::find(noted_.begin(), noted_.end(), what) != noted_.end();
    if (known) return;
    noted_.emplace_back(what);
    summary_.notes.push_back(fmt::format("{}:{}: {}.", file_, line.number(), what));
  }

  void uv(ObjLine& line) {
    line.require_number();
    for (int extra = 0; extra < 2; ++extra) {
      ObjLine ahead = line;
      if (ahead.next().empty()) break;
      line.require_number();
    }
    require_end(line, "at most 3 numbers");
    ++uvs_.count;
  }

  void face(ObjLine& line) {
    int corners = 0;
    for (auto word = line.next(); !word.empty(); word = line.next()) {
      if (++corners > most_corners) line.fail(line.shown(), fmt::format("at most {} vertices", most_corners));
      corner(line, word);
    }
    if (corners < 3)
      line.fail(fmt::format("a face with {} {}", corners, corners == 1 ? "vertex" : "vertices"), "at least 3 vertices");
    ++summary_.faces;
    summary_.corners += static_cast<std::size_t>(corners);
  }

  /// v, v/vt, v//vn or v/vt/vn. Slashes with nothing behind them go: tinyobjloader would take the next vertex's number.
  void corner(ObjLine& line, std::string_view word) {
    const auto last = word.find_last_not_of('/');
    if (last != std::string_view::npos && last + 1 < word.size()) {
      line.blank_word_end(word.size() - last - 1);
      word = line.word();
    }
    const auto first = word.find('/');
    index(line, word.substr(0, first), positions_);
    if (first == std::string_view::npos) return;
    const std::string_view behind = word.substr(first + 1);
    const auto second = behind.find('/');
    if (const auto part = behind.substr(0, second); !part.empty()) index(line, part, uvs_);
    if (second == std::string_view::npos) return;
    if (const auto part = behind.substr(second + 1); !part.empty()) index(line, part, normals_);
  }

  void index(ObjLine& line, std::string_view digits, IndexList& list) {
    const bool negative = !digits.empty() && digits.front() == '-';
    long long value = 0;
    const std::string_view number = digits.substr(negative ? 1 : 0);
    if (number.empty()) fail_corner(line);
    for (const char c : number) {
      if (c < '0' || c > '9') fail_corner(line);
      value = std::min(value * 10 + (c - '0'), 1'000'000'000'000LL);
    }
    if (value == 0) line.fail(line.shown(), "an index from 1 up, or below 0 to count backwards");
    if (negative) {
      if (value > static_cast<long long>(list.count)) fail_index(line, -value, list);
    } else if (value > static_cast<long long>(list.count)) {
      if (list.pending.empty() || value > list.pending.back().index) list.pending.push_back({value, line});
    }
  }

  [[noreturn]] static void fail_corner(const ObjLine& line) {
    line.fail(line.shown(), "a vertex reference such as 1, 1/2, 1//3 or 1/2/3");
  }

  [[noreturn]] static void fail_index(const ObjLine& line, long long index, const IndexList& list) {
    const std::string expected =
        list.count == 0 ? fmt::format("no {} index, since there are none {}", list.name,
                                      index < 0 ? "before this line" : "in the file")
        : index < 0     ? fmt::format("a {} index of at least -{}, counted back from this line", list.name, list.count)
                        : fmt::format("a {} index of at most {}", list.name, list.count);
    line.fail(fmt::format("index {} in {}", index, line.shown()), expected);
  }

  static void require_end(ObjLine& line, const std::string& expected) {
    if (!line.next().empty()) line.fail(line.shown(), expected);
  }

  static void reference(ObjLine& line, std::vector<ObjReference>& list, const std::string& expected) {
    const std::string name(line.rest());
    if (name.empty()) line.fail(line.shown(), expected);
    const bool known = std::any_of(list.begin(), list.end(), [&](const ObjReference& r) { return r.name == name; });
    if (known) return;
    constexpr std::size_t most_names = 10000;
    if (list.size() >= most_names) line.fail(line.shown(), fmt::format("at most {} names", most_names));
    list.push_back({name, line.number()});
  }

  std::string& text_;
  const std::string& file_;
  ObjSummary summary_;
  std::vector<std::string_view> noted_;
  std::optional<ObjLine> first_skipped_;  ///< statement that is not about polygons
  IndexList positions_{"vertex"};
  IndexList uvs_{"texture coordinate"};
  IndexList normals_{"normal"};
};

}  // namespace

ObjSummary check_obj(std::string& text, const std::string& file) { return ObjChecker(text, file).run(); }

}  // namespace ps
