#include "scene/mtl_check.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "base/spelling.h"
#include "scene/obj_line.h"

namespace ps {
namespace {

constexpr std::array<std::string_view, 3> drawn_colours{"Ka", "Kd", "Ks"};

/// Statements that are understood, but that no renderer uses, with what that means for the picture.
struct NotDrawn {
  std::string_view word, meaning;
};
constexpr std::array<NotDrawn, 19> not_drawn{{{"Ke", "surfaces do not glow"},
                                              {"Tf", "light is not tinted on its way through"},
                                              {"Kt", "light is not tinted on its way through"},
                                              {"map_Ns", "highlights take Ns alone"},
                                              {"map_Disp", "the surface is smooth"},
                                              {"map_disp", "the surface is smooth"},
                                              {"disp", "the surface is smooth"},
                                              {"decal", "the surface goes without it"},
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

/// Statements that name a picture which is drawn, besides those of relief.
constexpr std::array<std::string_view, 7> drawn_maps{"map_Kd", "map_Ks", "map_Ka",  "map_d",
                                                     "map_Tr", "refl",   "map_refl"};

/// One statement or another, as exporters like; all name a picture of the surface's relief.
constexpr std::array<std::string_view, 4> reliefs{"norm", "map_Bump", "map_bump", "bump"};

bool is_one_of(std::string_view word, const auto& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::vector<std::string_view> mtl_words() {
  std::vector<std::string_view> words(drawn_colours.begin(), drawn_colours.end());
  for (const char* word : {"newmtl", "Ns", "Ni", "d", "Tr", "illum"}) words.push_back(word);
  words.insert(words.end(), drawn_maps.begin(), drawn_maps.end());
  words.insert(words.end(), reliefs.begin(), reliefs.end());
  for (const NotDrawn& statement : not_drawn) words.push_back(statement.word);
  return words;
}

bool is_map(std::string_view word) {
  return word.substr(0, 4) == "map_" || word == "bump" || word == "norm" || word == "disp" || word == "decal" ||
         word == "refl";
}

/// Exporters write white where they mean that light passes unchanged; for all others black means that there is none.
double neutral_value(std::string_view word) { return word == "Tf" || word == "Kt" ? 1 : 0; }

/// The opacity statements of a material, until all of the file is known.
struct Opacity {
  std::optional<double> d, tr;
  int line = 0;
};

class MtlChecker {
 public:
  MtlChecker(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  MtlSummary run() {
    constexpr std::size_t most_bytes = 64 * 1024;
    ObjLines lines(text_, file_, most_bytes);
    while (auto line = lines.next()) {
      ObjLine words = *line;
      const std::string word(words.next());
      try {
        statement(*line);
      } catch (const InputError& error) {
        note("bad " + word, line->number(),
             fmt::format("'{}' is left out: found {}, expected {}", word.substr(0, 60), error.found(),
                         error.expected()));
      }
    }
    finish();
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
                          word == "Tr" || word == "illum" || is_one_of(word, drawn_maps) || is_one_of(word, reliefs);
    if (!is_drawn && ignored == not_drawn.end()) return unknown(line, word);
    if (facts_ == nullptr) line.fail(fmt::format("'{}' before any material", word), "'newmtl NAME' first");
    if (ignored != not_drawn.end()) return leave_out(line, *ignored);
    if (is_one_of(word, drawn_maps)) {
      drawn_map(line, word);
    } else if (is_one_of(word, reliefs)) {
      const MtlTexture map = texture(line, word);
      if (word == "norm" || !facts_->relief_map) facts_->relief_map = map;  // directions say more than heights
    } else if (word == "d" || word == "Tr") {
      opacity(line, word);
    } else if (word == "illum") {
      facts_->illum = static_cast<int>(clamped(line, word, 0, 10));
    } else if (word == "Ns" || word == "Ni") {
      (word == "Ns" ? facts_->shininess : facts_->refraction_index) = line.require_number();
      end(line, word, "one number");
    } else {
      (word == "Kd" ? facts_->diffuse : word == "Ks" ? facts_->specular : facts_->ambient) = colour(line, word);
    }
  }

  void unknown(const ObjLine& line, const std::string& word) {
    constexpr std::size_t most_notes = 50;  // a file of another kind has only unknown words
    if (noted_.size() >= most_notes || noted_.count(word) > 0) return;
    const std::string_view similar = similar_word(word, mtl_words());
    note(word, line.number(),
         fmt::format("'{}' is not a statement of a material file{}", word.substr(0, 60),
                     similar.empty() ? "" : fmt::format("; perhaps '{}'", similar)));
  }

  void start(ObjLine& line) {
    const std::string name(line.name());
    if (name.empty()) {
      facts_ = &second_;
      opacity_ = &second_opacity_;
      line.fail(line.shown(), "the name of a material");
    }
    const auto [material, is_new] = summary_.materials.try_emplace(name);
    if (is_new) summary_.order.push_back(name);
    second_ = {};
    second_opacity_ = {};
    facts_ = is_new ? &material->second : &second_;
    opacity_ = is_new ? &opacities_[name] : &second_opacity_;
  }

  /// d 0.5, d -halo 0.5, Tr 0.5
  void opacity(ObjLine& line, const std::string& word) {
    ObjLine ahead = line;
    if (word == "d" && ahead.next() == "-halo") {
      line.next();
      note("-halo", line.number(), "'-halo' is not drawn: the surface is as opaque from every side");
    }
    (word == "d" ? opacity_->d : opacity_->tr) = clamped(line, word, 0, 1);
    if (word == "d" || !opacity_->d) opacity_->line = line.number();
  }

  /// r g b, or one value for all three.
  Vec3d colour(ObjLine& line, const std::string& word) {
    Vec3d result(line.require_number());
    if (line.at_end()) return result;
    result.y = line.require_number();
    result.z = line.require_number();
    end(line, word, "three numbers");
    return result;
  }

  MtlTexture texture(ObjLine& line, const std::string& word) {
    MtlTexture map = read_mtl_texture(line);
    if (map.turbulence) note("-t", line.number(), fmt::format("the option -t of {} is not drawn", word));
    return map;
  }

  void drawn_map(ObjLine& line, const std::string& word) {
    MtlTexture map = texture(line, word);
    if (word == "refl" || word == "map_refl") return facts_->reflections.push_back(std::move(map));
    if (word == "map_Tr") {  // transparency: the opposite
      map.base = 1 - map.base;
      map.gain = -map.gain;
    }
    (word == "map_Kd"   ? facts_->diffuse_map
     : word == "map_Ks" ? facts_->specular_map
     : word == "map_Ka" ? facts_->ambient_map
                        : facts_->opacity_map) = std::move(map);
  }

  void leave_out(ObjLine& line, const NotDrawn& statement) {
    const std::string word(statement.word);
    if (is_map(word)) {
      texture(line, word);
    } else {
      bool neutral = true;
      for (int count = 0; count < 3; ++count) {
        if (count > 0 && line.at_end()) break;
        neutral = line.require_number() == neutral_value(word) && neutral;
      }
      if (neutral) return;
    }
    note(word, line.number(), fmt::format("'{}' is not drawn: {}", word, statement.meaning));
  }

  /// Checks that need the whole file.
  void finish() {
    // Some programs write Tr 1 for opaque. One that meant it would have made everything invisible.
    const auto turned = [](const auto& named) { return !named.second.d && named.second.tr == 1.0; };
    const bool means_opaque = !opacities_.empty() && std::all_of(opacities_.begin(), opacities_.end(), turned);
    for (const std::string& name : summary_.order) {
      MtlFacts& facts = summary_.materials[name];
      const Opacity& opacity = opacities_[name];
      if (means_opaque) {
        note("Tr", opacity.line, "every material has 'Tr 1' and no 'd', so 1 is taken for opaque");
      } else if (opacity.d || opacity.tr) {
        facts.dissolve = opacity.d ? *opacity.d : 1 - *opacity.tr;
        if (facts.dissolve == 0.0)
          note("invisible", opacity.line, fmt::format("'{}' makes the material invisible", opacity.d ? "d 0" : "Tr 1"));
      }
      place_maps(facts);
      if (!facts.reflections.empty() && facts.specular.value_or(Vec3d{0, 0, 0}) == Vec3d{0, 0, 0})
        note("dull", facts.reflections.front().line,
             fmt::format("'refl' of '{}' is not drawn: the surface reflects as much as Ks says, which is nothing",
                         name));
      if (facts.diffuse_map && facts.diffuse == Vec3d{0, 0, 0})
        note("hidden", facts.diffuse_map->line,
             fmt::format("'Kd 0 0 0' of '{}' hides the picture of map_Kd: texels are multiplied by Kd", name));
    }
  }

  /// A surface has one set of texture coordinates: the first of its pictures says where they lie.
  void place_maps(MtlFacts& facts) {
    bool is_first = true;
    for (const auto* map :
         {&facts.diffuse_map, &facts.specular_map, &facts.ambient_map, &facts.opacity_map, &facts.relief_map}) {
      if (!*map) continue;
      const UvPlacement own{Vec2d((*map)->scale), Vec2d((*map)->offset)};
      if (is_first) facts.placement = own;
      if (own != facts.placement)
        note("placement", (*map)->line,
             "the options -s and -o of a material's first picture hold for all of them; others here are not drawn");
      is_first = false;
    }
  }

  /// The only value of a statement.
  double clamped(ObjLine& line, const std::string& word, double low, double high) {
    const double value = line.require_number();
    const double result = std::clamp(value, low, high);
    if (result != value)
      note(word + " range", line.number(),
           fmt::format("'{} {}' lies outside {} to {} and is taken as {}", word, line.word().substr(0, 60), low, high,
                       result));
    end(line, word, "one number");
    return result;
  }

  /// Words behind the values of a statement are not used.
  void end(ObjLine& line, const std::string& word, const char* values) {
    if (!line.at_end())
      note(word + " end", line.number(), fmt::format("'{}' has {}; what follows is not used", word, values));
  }

  void note(const std::string& kind, int line, const std::string& text) {
    if (noted_.insert(kind).second) summary_.notes.push_back(fmt::format("{}:{}: {}.", file_, line, text));
  }

  std::string_view text_;
  const std::string& file_;
  MtlSummary summary_;
  MtlFacts* facts_ = nullptr;
  Opacity* opacity_ = nullptr;
  std::map<std::string, Opacity> opacities_;  ///< by the material's name
  MtlFacts second_;                           ///< of a second material of one name or of none, which do not count
  Opacity second_opacity_;
  std::set<std::string> noted_;
};

}  // namespace

MtlSummary check_mtl(std::string_view text, const std::string& file) { return MtlChecker(text, file).run(); }

}  // namespace ps
