#include "scene/mtl_check.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "base/number_text.h"
#include "base/spelling.h"
#include "scene/obj_line.h"

namespace ps {
namespace {

constexpr std::array<std::string_view, 3> drawn_colours{"Ka", "Kd", "Ks"};

/// Statements that are understood, but that nothing draws, with what that means for the picture.
struct NotDrawn {
  std::string_view word, meaning;
};
constexpr std::array<NotDrawn, 25> not_drawn{{{"Ke", "surfaces do not glow"},
                                              {"Tf", "light is not tinted on its way through"},
                                              {"Kt", "light is not tinted on its way through"},
                                              {"map_Ka", "ambient light takes the colour of map_Kd"},
                                              {"map_Ks", "highlights take Ks alone"},
                                              {"map_Ns", "highlights take Ns alone"},
                                              {"map_d", "the surface is as opaque as d says, everywhere"},
                                              {"map_Tr", "the surface is as opaque as d says, everywhere"},
                                              {"map_Disp", "the surface is smooth"},
                                              {"map_disp", "the surface is smooth"},
                                              {"disp", "the surface is smooth"},
                                              {"decal", "the surface goes without it"},
                                              {"refl", "reflections show the scene itself"},
                                              {"map_refl", "reflections show the scene itself"},
                                              {"map_Ke", "surfaces do not glow"},
                                              {"map_Pr", "roughness comes from Ns"},
                                              {"map_Pm", "metals take Kd and Ks"},
                                              {"map_Ps", "there is no sheen"},
                                              {"Pr", "roughness comes from Ns"},
                                              {"Pm", "metals take Kd and Ks"},
                                              {"Ps", "there is no sheen"},
                                              {"Pc", "there is no clear coat"},
                                              {"Pcr", "there is no clear coat"},
                                              {"aniso", "highlights are round"},
                                              {"anisor", "highlights are round"}}};

/// Statements without any influence on a picture made here.
constexpr std::array<std::string_view, 3> harmless{"sharpness", "map_aat", "map_Kd_filter"};

/// One statement or another, as exporters like; all name a picture of the surface's relief.
constexpr std::array<std::string_view, 4> reliefs{"norm", "map_Bump", "map_bump", "bump"};

constexpr std::array<std::string_view, 7> reflection_types{"sphere",    "cube_top",  "cube_bottom", "cube_front",
                                                           "cube_back", "cube_left", "cube_right"};

bool is_one_of(std::string_view word, const auto& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::vector<std::string_view> mtl_words() {
  std::vector<std::string_view> words(drawn_colours.begin(), drawn_colours.end());
  for (const char* word : {"newmtl", "Ns", "Ni", "d", "Tr", "illum", "map_Kd"}) words.push_back(word);
  words.insert(words.end(), reliefs.begin(), reliefs.end());
  for (const NotDrawn& statement : not_drawn) words.push_back(statement.word);
  return words;
}

bool is_map(std::string_view word) {
  return word.substr(0, 4) == "map_" || word == "bump" || word == "norm" || word == "disp" || word == "decal" ||
         word == "refl";
}

class MtlChecker {
 public:
  MtlChecker(std::string& text, const std::string& file) : text_(text), file_(file) {}

  MtlSummary run() {
    for_each_obj_line(text_, file_, [&](ObjLine& line) { statement(line); });
    return std::move(summary_);
  }

 private:
  void statement(ObjLine& line) {
    const std::string word(line.next());
    if (word.empty()) return;
    if (word == "newmtl") return start(line);
    if (is_one_of(word, harmless)) return;
    const auto ignored =
        std::find_if(not_drawn.begin(), not_drawn.end(), [&](const NotDrawn& s) { return s.word == word; });
    const bool is_drawn = is_one_of(word, drawn_colours) || word == "Ns" || word == "Ni" || word == "d" ||
                          word == "Tr" || word == "illum" || word == "map_Kd" || is_one_of(word, reliefs);
    if (!is_drawn && ignored == not_drawn.end()) return unknown(line, word);
    if (facts_ == nullptr) line.fail(fmt::format("'{}' before any material", word), "'newmtl NAME' first");
    if (ignored != not_drawn.end()) return leave_out(line, *ignored);
    if (word == "map_Kd") {
      facts_->diffuse_map = texture(line, word);
    } else if (is_one_of(word, reliefs)) {
      const MtlTexture map = texture(line, word);
      if (word == "norm" || !facts_->relief_map) facts_->relief_map = map;  // directions say more than heights
    } else if (word == "d" || word == "Tr") {
      opacity(line, word);
    } else if (word == "illum") {
      facts_->illum = static_cast<int>(number(line, 0, 10, "a whole number from 0 to 10"));
      end(line, "one number");
    } else if (word == "Ns" || word == "Ni") {
      line.require_number();
      if (word == "Ni") facts_->refraction_index = parse_number(line.word()).value_or(1);
      end(line, "one number");
    } else {
      for (int i = 0; i < 3; ++i) line.require_number();
      end(line, "three numbers");
      if (word == "Kd") facts_->diffuse = true;
    }
  }

  void unknown(const ObjLine& line, const std::string& word) {
    constexpr std::size_t most_notes = 50;  // a file of another kind has nothing but unknown words
    if (noted_.size() >= most_notes || noted_.count(word) > 0) return;
    const std::string_view similar = similar_word(word, mtl_words());
    note(word, fmt::format("{}:{}: '{}' is not a statement of a material file{}.", file_, line.number(),
                           word.substr(0, 60), similar.empty() ? "" : fmt::format("; perhaps '{}'", similar)));
  }

  void start(ObjLine& line) {
    const std::string name(line.rest());
    if (name.empty()) line.fail(line.shown(), "the name of a material");
    const auto [material, is_new] = summary_.materials.try_emplace(name);
    second_ = {};
    facts_ = is_new ? &material->second : &second_;
  }

  /// d 0.5, d -halo 0.5, Tr 0.5
  void opacity(ObjLine& line, const std::string& word) {
    ObjLine ahead = line;
    if (word == "d" && ahead.next() == "-halo") {
      line.next();
      note("-halo",
           fmt::format("{}:{}: '-halo' is not drawn: the surface is as opaque from every side.", file_, line.number()));
    }
    const double value = number(line, 0, 1, "a number from 0 to 1");
    end(line, "one number");
    if (word == "d") {
      facts_->dissolve = value;
      has_d_ = &*facts_;
    } else if (has_d_ != &*facts_) {
      facts_->dissolve = 1 - value;
    }
    if (facts_->dissolve == 0.0)
      note("invisible", fmt::format("{}:{}: '{} {}' makes the material invisible.", file_, line.number(), word, value));
  }

  /// Options, then a name that may hold blanks.
  MtlTexture texture(ObjLine& line, const std::string& word) {
    bool typed = false;
    for (;;) {
      ObjLine ahead = line;
      const std::string option(ahead.next());
      if (option.empty() || option.front() != '-') break;
      line.next();
      if (option == "-type") {
        if (!is_one_of(line.next(), reflection_types))
          line.fail(line.shown(), "sphere, cube_top, cube_bottom, cube_front, cube_back, cube_left or cube_right");
        typed = true;
      } else if (option == "-s" || option == "-o" || option == "-t") {
        const double neutral = option == "-s" ? 1 : 0;
        if (numbers(line, 1, 3, neutral) != Neutral::yes) warn_option(line, word, option);
      } else if (option == "-mm") {
        const bool keeps_black = numbers(line, 1, 1, 0) == Neutral::yes;
        const bool keeps_white = numbers(line, 1, 1, 1) == Neutral::yes;
        if (!keeps_black || !keeps_white) warn_option(line, word, option);
      } else if (option == "-bm") {
        const double bump = number(line, -1e6, 1e6, "a number");
        if (is_one_of(word, reliefs)) facts_->bump = bump;
      } else if (option == "-boost" || option == "-texres") {
        numbers(line, 1, 1, 1);
      } else if (option == "-blendu" || option == "-blendv" || option == "-cc" || option == "-clamp") {
        const std::string value(line.next());
        if (value != "on" && value != "off") line.fail(line.shown(), "on or off");
        if (option == "-clamp" && value == "on") warn_option(line, word, option);
      } else if (option == "-imfchan" || option == "-colorspace") {
        if (line.next().empty()) line.fail(line.shown(), fmt::format("a value for {}", option));
      } else {
        line.fail(line.shown(), "an option of a texture, such as -s 1 1 1, or a file name");
      }
    }
    if (word == "refl" && !typed) {
      ObjLine ahead = line;
      if (ahead.next().empty()) line.fail("the end of the line", "-type sphere or -type cube_top and so on");
    }
    MtlTexture result{std::string(line.rest()), line.number()};
    if (result.name.empty()) line.fail(line.shown(), "the name of a picture file");
    return result;
  }

  void leave_out(ObjLine& line, const NotDrawn& statement) {
    const std::string word(statement.word);
    if (is_map(word)) {
      const MtlTexture map = texture(line, word);
      // Exporters name one picture twice; then nothing is lost.
      if (word == "map_Ka" && (!facts_->diffuse_map || facts_->diffuse_map->name == map.name)) return;
    } else {
      bool black = true;
      int count = 0;
      for (; count < 3; ++count) {
        ObjLine ahead = line;
        if (ahead.next().empty()) break;
        black = number(line, -1e12, 1e12, "a number") == 0 && black;
      }
      if (count == 0) line.fail(line.shown(), "a number");
      if (black) return;
    }
    note(word, fmt::format("{}:{}: '{}' is not drawn: {}.", file_, line.number(), word, statement.meaning));
  }

  void warn_option(const ObjLine& line, const std::string& word, const std::string& option) {
    note(option, fmt::format("{}:{}: the option {} of {} is not drawn.", file_, line.number(), option, word));
  }

  enum class Neutral { yes, no };
  /// Reads `least` numbers and up to `most` if they follow; says whether all were `neutral`.
  static Neutral numbers(ObjLine& line, int least, int most, double neutral) {
    Neutral result = Neutral::yes;
    for (int i = 0; i < most; ++i) {
      ObjLine ahead = line;
      if (i >= least && !parse_number(ahead.next())) break;
      line.require_number();
      if (parse_number(line.word()) != neutral) result = Neutral::no;
    }
    return result;
  }

  static double number(ObjLine& line, double low, double high, const char* expected) {
    line.require_number();
    const auto value = parse_number(line.word());
    if (!value || !(*value >= low && *value <= high)) line.fail(line.shown(), expected);
    return *value;
  }

  static void end(ObjLine& line, const char* expected) {
    if (!line.next().empty()) line.fail(line.shown(), expected);
  }

  void note(const std::string& kind, std::string text) {
    if (noted_.insert(kind).second) summary_.notes.push_back(std::move(text));
  }

  std::string& text_;
  const std::string& file_;
  MtlSummary summary_;
  MtlFacts* facts_ = nullptr;
  const MtlFacts* has_d_ = nullptr;
  MtlFacts second_;  ///< of a second material of one name, which does not count
  std::set<std::string> noted_;
};

}  // namespace

MtlSummary check_mtl(std::string& text, const std::string& file) { return MtlChecker(text, file).run(); }

}  // namespace ps
