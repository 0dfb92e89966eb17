#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "base/enumerators.h"
#include "base/spelling.h"
#include "engine/figure_kinds.h"
#include "engine/figure_rules.h"
#include "engine/words.h"

namespace ps {
namespace {

/// Roles that a description may name.
constexpr std::array named_roles{Role::ink,   Role::quiet, Role::border, Role::faint,  Role::a,        Role::b,
                                 Role::right, Role::wrong, Role::light,  Role::mirror, Role::attention};

struct NamedSide {
  std::string_view name;
  Vec2d side;
};
constexpr double diagonal = 0.75;
const std::array named_sides{NamedSide{"to-the-left", label_left},
                             NamedSide{"to-the-right", label_right},
                             NamedSide{"above", label_above},
                             NamedSide{"below", label_below},
                             NamedSide{"on", label_on},
                             NamedSide{"above-left", {-diagonal, diagonal}},
                             NamedSide{"above-right", {diagonal, diagonal}},
                             NamedSide{"below-left", {-diagonal, -diagonal}},
                             NamedSide{"below-right", {diagonal, -diagonal}}};

constexpr double filled_opacity = 0.18, angle_share = 0.35, most_cells = 4096;

Vec2d unit_vector(const Vec2d& v) {
  const double length = figure_length(v);
  return length > 0 ? v / length : Vec2d(0, 1);
}

/// One line of the description, taken apart: its words, how its marks look, and the label behind ": ".
struct DrawnLine {
  std::vector<FigureWord> words;  ///< those that are neither looks nor sides
  Stroke stroke = figure_stroke();
  double opacity = 0;
  std::optional<Vec2d> side;
  std::string label;
  SourcePlace label_place;
};

class FigureReader {
 public:
  /// Numbers of a pixel are those of this story, which has them all, or without one the step's own.
  explicit FigureReader(const SourcePlace& start, const PixelStory* story = nullptr) : start_(start), story_(story) {}

  void read_line(std::string_view line, int number) {
    const SourcePlace start{start_.file, number, 1};
    const std::string_view text = without_blanks(line);
    if (text.empty()) return;
    const FigureWord verb{std::string(text.substr(0, text.find(' '))),
                          {start.file, start.line, start.column + static_cast<int>(line.find(text))}};
    if (verb.text == "alt") return read_description(text.substr(3), verb);
    if (verb.text == "pixel") return read_pixel(line, start);
    if (const FigureKind* kind = find_figure_kind(verb.text)) {
      std::vector<FigureWord> words = numbered_words(line, start);
      words.erase(words.begin());
      FigureValues values(std::move(words));
      kind->draw(values, figure_.marks);
      return values.require_all_used();
    }
    const auto found =
        std::find_if(verbs.begin(), verbs.end(), [&](const Verb& each) { return each.name == verb.text; });
    if (found == verbs.end()) {
      std::vector<std::string_view> known = figure_kind_names();
      known.insert(known.end(), {"alt", "pixel"});
      for (const Verb& each : verbs) known.push_back(each.name);
      throw InputError(verb.place, fmt::format("'{}'", shown_start(verb.text)), expected_word(verb.text, known));
    }
    verb_ = verb;
    (this->*found->read)(take_apart(line, start));
  }

  Figure finish() {
    if (figure_.description.empty())
      throw InputError(start_, "a figure without a description", "a line 'alt What it shows.'");
    if (figure_.marks.empty())
      throw InputError(start_, "a figure without marks", "lines such as 'arrow (0, 0) (2, 1)'");
    return std::move(figure_);
  }

 private:
  struct Verb {
    std::string_view name;
    void (FigureReader::*read)(const DrawnLine&);
  };
  static const std::array<Verb, 14> verbs;

  void read_description(std::string_view text, const FigureWord& verb) {
    if (!figure_.description.empty()) throw InputError(verb.place, "a second description", "one");
    figure_.description = without_blanks(text);
  }

  void read_pixel(std::string_view line, const SourcePlace& start) {
    FigureNumber number = read_figure_number(line, start);
    const double value = story_ ? number_at(number, *story_).value() : number.own;
    if (!numbers_.emplace(number.name, value).second)
      throw InputError(number.place, fmt::format("a second '{}'", number.name), "another name");
    figure_.of_pixel.push_back(std::move(number));
  }

  std::vector<FigureWord> numbered_words(std::string_view line, const SourcePlace& start) const {
    std::vector<FigureWord> words = words_of_line(line, start);
    for (FigureWord& word : words) word.text = with_numbers(word.text, numbers_, word.place, false);
    return words;
  }

  /// The words behind the verb.
  DrawnLine take_apart(std::string_view line, const SourcePlace& start) const {
    DrawnLine drawn;
    if (const std::size_t colon = line.find(" : "); colon != std::string_view::npos) {
      const std::string_view label = line.substr(colon + 3);
      const std::size_t blanks = std::min(label.find_first_not_of(' '), label.size());
      drawn.label_place = {start.file, start.line, start.column + static_cast<int>(colon + 3 + blanks)};
      drawn.label = with_numbers(without_blanks(label), numbers_, drawn.label_place, true);
      line = line.substr(0, colon);
    }
    std::vector<FigureWord> words = numbered_words(line, start);
    for (std::size_t i = 1; i < words.size(); ++i)
      if (!take_look(words[i].text, drawn)) drawn.words.push_back(std::move(words[i]));
    return drawn;
  }

  static bool take_look(const std::string& word, DrawnLine& drawn) {
    for (const Role role : named_roles)
      if (enumerator_key(role) == word) return drawn.stroke.tint.role = role, true;
    for (const NamedSide& each : named_sides)
      if (each.name == word) return drawn.side = each.side, true;
    if (word == "dashed") return drawn.stroke.dash = dashed, true;
    if (word == "dotted") return drawn.stroke.dash = dotted, true;
    if (word == "thick") return drawn.stroke.width = thick_line, true;
    if (word == "thin") return drawn.stroke.width = thin_line, true;
    if (word == "filled") return drawn.opacity = filled_opacity, true;
    return false;
  }

  void require_words(const DrawnLine& drawn, std::size_t least, std::size_t most, std::string_view expected) const {
    if (drawn.words.size() < least) throw InputError(verb_.place, "too few words", std::string(expected));
    if (drawn.words.size() > most)
      throw InputError(drawn.words[most].place, fmt::format("'{}'", shown_start(drawn.words[most].text)),
                       "the end of the line, or ' : ' before a label");
  }

  /// "(x, y)" or a name.
  Vec2d place_of(const FigureWord& word) const {
    if (!word.text.empty() && word.text.front() == '(') return pair_of(word);
    if (const auto named = places_.find(word.text); named != places_.end()) return named->second;
    std::vector<std::string_view> names;
    for (const auto& [name, place] : places_) names.push_back(name);
    throw InputError(word.place, fmt::format("'{}'", shown_start(word.text)),
                     "(x, y) or a place that has a name" + did_you_mean(word.text, names, ""));
  }

  std::vector<Vec2d> places_of(const DrawnLine& drawn, std::size_t least, std::size_t most = 200) const {
    require_words(drawn, least, most, fmt::format("{} places", least));
    std::vector<Vec2d> places;
    for (const FigureWord& word : drawn.words) places.push_back(place_of(word));
    return places;
  }

  void label(const DrawnLine& drawn, const Vec2d& at, const Vec2d& side, Role role) {
    if (drawn.label.empty()) return;
    FigureLabel made = read_label(drawn.label, drawn.label_place);
    made.at = at;
    made.side = drawn.side.value_or(side);
    made.tint = {role};
    figure_.marks.emplace_back(std::move(made));
  }
  void label(const DrawnLine& drawn, const Vec2d& at, const Vec2d& side) {
    label(drawn, at, side, drawn.stroke.tint.role);
  }

  /// "place NAME (x, y)", or in place of (x, y): "meet A B C D", "foot P A B", "along A B SHARE",
  /// "turn P MIDDLE DEGREES" or "tangent P CENTRE RADIUS": where the tangent from P to a circle on the right touches
  /// it.
  void read_place(const DrawnLine& drawn) {
    require_words(drawn, 2, 6, "a name and (x, y)");
    const FigureWord &name = drawn.words[0], &how = drawn.words[1];
    if (name.text.front() == '(') throw InputError(name.place, fmt::format("'{}'", name.text), "a name");
    const auto at = [&](std::size_t i) {
      if (i >= drawn.words.size())
        throw InputError(how.place, fmt::format("'{}' with too few places", how.text), "more");
      return drawn.words[i];
    };
    Vec2d& place = places_[name.text];
    if (how.text == "meet") {
      const Vec2d a = place_of(at(2)), b = place_of(at(3)), c = place_of(at(4)), d = place_of(at(5));
      if (edge_value(a, b, a + d - c) == 0) throw InputError(how.place, "lines that are parallel", "two that meet");
      place = meeting(a, b, c, d);
    } else if (how.text == "foot") {
      const Vec2d p = place_of(at(2)), a = place_of(at(3)), b = place_of(at(4)), along = unit_vector(b - a);
      place = a + ((p - a).x * along.x + (p - a).y * along.y) * along;
    } else if (how.text == "along") {
      const Vec2d a = place_of(at(2)), b = place_of(at(3));
      place = a + number_of(at(4)) * (b - a);
    } else if (how.text == "tangent") {
      const Vec2d p = place_of(at(2)), way = place_of(at(3)) - p;
      const double radius = number_of(at(4)), square = way.x * way.x + way.y * way.y - radius * radius;
      if (!(square > 0)) throw InputError(how.place, "a place in the circle", "one outside");
      const double along = square / (square + radius * radius), across = along * radius / std::sqrt(square);
      place = p + along * way + across * Vec2d(way.y, -way.x);
    } else if (how.text == "turn") {
      const Vec2d p = place_of(at(2)), middle = place_of(at(3)), away = p - middle;
      const Vec2d turned = figure_direction(number_of(at(4)));
      place = middle + Vec2d(turned.x * away.x - turned.y * away.y, turned.y * away.x + turned.x * away.y);
    } else {
      place = place_of(how);
    }
  }

  void read_dot(const DrawnLine& drawn) {
    const Vec2d at = places_of(drawn, 1, 1).front();
    add_dot(figure_.marks, at, drawn.stroke.tint.role);
    label(drawn, at, label_above, Role::ink);
  }

  void read_label_line(const DrawnLine& drawn) {
    const Vec2d at = places_of(drawn, 1, 1).front();
    if (drawn.label.empty()) throw InputError(verb_.place, "a label without words", "' : ' before them");
    label(drawn, at, label_on);
  }

  void read_line_mark(const DrawnLine& drawn) {
    std::vector<Vec2d> places = places_of(drawn, 2);
    const Vec2d along = unit_vector(places[1] - places[0]);
    label(drawn, (places[0] + places[1]) / 2.0, {-along.y, along.x});
    add_line(figure_.marks, std::move(places), drawn.stroke);
  }

  void read_arrow(const DrawnLine& drawn) {
    const std::vector<Vec2d> places = places_of(drawn, 2, 2);
    add_arrow(figure_.marks, places[0], places[1], drawn.stroke);
    label(drawn, places[1], unit_vector(places[1] - places[0]));
  }

  void read_polygon(const DrawnLine& drawn) {
    const std::vector<Vec2d> corners = places_of(drawn, 3);
    Vec2d sum(0, 0);
    for (const Vec2d& corner : corners) sum += corner;
    add_polygon(figure_.marks, corners, drawn.stroke, drawn.opacity);
    label(drawn, sum / static_cast<double>(corners.size()), label_on);
  }

  void read_circle(const DrawnLine& drawn) {
    require_words(drawn, 2, 2, "a centre and a radius");
    const Vec2d middle = place_of(drawn.words[0]);
    const double radius = number_of(drawn.words[1]);
    std::vector<Vec2d> places = arc_places(middle, radius, 0, 360);
    if (drawn.opacity > 0) figure_.marks.emplace_back(FigureArea{places, {drawn.stroke.tint.role, drawn.opacity}});
    add_line(figure_.marks, std::move(places), drawn.stroke);
    label(drawn, middle, label_on);
  }

  void read_arc(const DrawnLine& drawn) {
    require_words(drawn, 4, 4, "a centre, a radius and two angles in degrees");
    const Vec2d middle = place_of(drawn.words[0]);
    const double radius = number_of(drawn.words[1]), from = number_of(drawn.words[2]), to = number_of(drawn.words[3]);
    add_line(figure_.marks, arc_places(middle, radius, from, to), drawn.stroke);
    const Vec2d outwards = figure_direction((from + to) / 2);
    label(drawn, middle + radius * outwards, outwards);
  }

  void read_angle(const DrawnLine& drawn) {
    require_words(drawn, 3, 4, "three places, the corner in the middle");
    const Vec2d from = place_of(drawn.words[0]), corner = place_of(drawn.words[1]), to = place_of(drawn.words[2]);
    const double radius = drawn.words.size() > 3
                              ? number_of(drawn.words[3])
                              : angle_share * std::min(figure_length(from - corner), figure_length(to - corner));
    add_angle(figure_.marks, from, corner, to, radius, "", drawn.stroke.tint.role);
    const Vec2d outwards = unit_vector(unit_vector(from - corner) + unit_vector(to - corner));
    label(drawn, corner + radius * outwards, outwards);
  }

  void read_grid(const DrawnLine& drawn) {
    const std::vector<Vec2d> corners = places_of(drawn, 2, 2);
    const Vec2d low = corners[0], high = corners[1];
    require_few_cells((high.x - low.x) * (high.y - low.y));
    const Stroke stroke = figure_stroke(Role::faint, thin_line);
    for (double x = low.x; x <= high.x; ++x) add_line(figure_.marks, {{x, low.y}, {x, high.y}}, stroke);
    for (double y = low.y; y <= high.y; ++y) add_line(figure_.marks, {{low.x, y}, {high.x, y}}, stroke);
  }

  void require_few_cells(double count) const {
    if (!(count >= 0 && count <= most_cells))
      throw InputError(verb_.place, "a grid of too many cells",
                       fmt::format("at most {:g}, from the lower left corner on", most_cells));
  }

  void fill_cell(const Vec2d& low, const DrawnLine& drawn) {
    const std::vector<Vec2d> corners{low, low + Vec2d(1, 0), low + Vec2d(1, 1), low + Vec2d(0, 1)};
    figure_.marks.emplace_back(FigureArea{corners, {drawn.stroke.tint.role, drawn.opacity > 0 ? 0.18 : 0.4}});
  }

  /// The cells whose lower left corners these are.
  void read_cells(const DrawnLine& drawn) {
    for (const Vec2d& low : places_of(drawn, 1)) fill_cell(low, drawn);
  }

  /// The cells of a line between two cells: one for each column or row of the longer side, the other place rounded.
  void read_pixels(const DrawnLine& drawn) {
    const std::vector<Vec2d> ends = places_of(drawn, 2, 2);
    const Vec2d way = ends[1] - ends[0];
    const double steps = std::round(std::max(std::abs(way.x), std::abs(way.y)));
    require_few_cells(steps);
    for (double i = 0; i <= steps; ++i) {
      const Vec2d at = ends[0] + (steps > 0 ? i / steps : 0) * way;
      fill_cell({std::floor(at.x + 0.5), std::floor(at.y + 0.5)}, drawn);
    }
  }

  /// The cells whose centres lie in a triangle.
  void read_covered(const DrawnLine& drawn) {
    const std::vector<Vec2d> p = places_of(drawn, 3, 3);
    const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
    const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
    require_few_cells((x1 - x0) * (y1 - y0));
    const double turn = edge_value(p[0], p[1], p[2]) < 0 ? -1 : 1;
    for (double y = std::floor(y0); y < y1; ++y)
      for (double x = std::floor(x0); x < x1; ++x) {
        const Vec2d centre(x + 0.5, y + 0.5);
        if (turn * edge_value(p[0], p[1], centre) > 0 && turn * edge_value(p[1], p[2], centre) > 0 &&
            turn * edge_value(p[2], p[0], centre) > 0)
          fill_cell({x, y}, drawn);
      }
  }

  /// "hits O D CENTRE RADIUS": where the ray from O through D meets the circle at t above 0, D at t = 1. The places get
  /// the names hit1 and hit2. A label marks the first one alone; else each has its t.
  void read_hits(const DrawnLine& drawn) {
    require_words(drawn, 4, 4, "two places of a ray, a centre and a radius");
    const Vec2d origin = place_of(drawn.words[0]), direction = place_of(drawn.words[1]) - origin;
    const std::vector<double> hits =
        circle_hits(origin, direction, place_of(drawn.words[2]), number_of(drawn.words[3]));
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (!(hits[i] > 0)) continue;
      const Vec2d at = origin + hits[i] * direction, side = drawn.side.value_or(Vec2d(i == 0 ? -0.6 : 0.6, 0.9));
      add_dot(figure_.marks, at, drawn.stroke.tint.role);
      if (drawn.label.empty())
        add_label(figure_.marks, at, side, fmt::format("$t_{}$", i + 1), drawn.stroke.tint.role);
      else
        label(drawn, at, side);
      places_[fmt::format("hit{}", i + 1)] = at;
      if (!drawn.label.empty()) break;
    }
  }

  SourcePlace start_;
  const PixelStory* story_;
  FigureNumbers numbers_;
  Figure figure_;
  FigureWord verb_;  // of the line that is read
  std::map<std::string, Vec2d> places_;
};

const std::array<FigureReader::Verb, 14> FigureReader::verbs{{{"place", &FigureReader::read_place},
                                                              {"dot", &FigureReader::read_dot},
                                                              {"label", &FigureReader::read_label_line},
                                                              {"line", &FigureReader::read_line_mark},
                                                              {"arrow", &FigureReader::read_arrow},
                                                              {"polygon", &FigureReader::read_polygon},
                                                              {"circle", &FigureReader::read_circle},
                                                              {"arc", &FigureReader::read_arc},
                                                              {"angle", &FigureReader::read_angle},
                                                              {"grid", &FigureReader::read_grid},
                                                              {"cells", &FigureReader::read_cells},
                                                              {"pixels", &FigureReader::read_pixels},
                                                              {"covered", &FigureReader::read_covered},
                                                              {"hits", &FigureReader::read_hits}}};

}  // namespace

Figure read_figure(std::string_view text, const std::string& file, int first_line, const PixelStory* story) {
  FigureReader reader({file, first_line, 1}, story);
  const std::string whole(text);
  for (int line = first_line; !text.empty(); ++line) reader.read_line(take_line(text), line);
  Figure figure = reader.finish();
  if (!figure.of_pixel.empty()) {
    figure.source = {whole, file, first_line};
    figure.note =
        story ? fmt::format("At pixel ({}, {}).", story->pixel.x, story->pixel.y) : "At the step's own pixel.";
  }
  return figure;
}

const FigureKind* find_figure_kind(std::string_view name) {
  for (const auto kinds : {ray_figures(), interval_figures(), raster_figures()})
    for (const FigureKind& kind : kinds)
      if (kind.name == name) return &kind;
  return nullptr;
}

std::vector<std::string_view> figure_kind_names() {
  std::vector<std::string_view> names;
  for (const auto kinds : {ray_figures(), interval_figures(), raster_figures()})
    for (const FigureKind& kind : kinds) names.push_back(kind.name);
  return names;
}

}  // namespace ps
