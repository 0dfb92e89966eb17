// The feature that a picture file lacks is named. The files are by other hands: a small ray tracer that is written here
// anew, from the book's text and in double, with something missing, too much or stored otherwise; and listings in which
// one line is wrong.
#include "study/missing_feature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "frame/display_frame.h"
#include "image/difference.h"
#include "image/file.h"
#include "inspect/missing_term.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/refusal.h"
#include "support/render_once.h"
#include "support/run_cli.h"
#include "support/shown_levels.h"

namespace ps::missing_feature_test {
namespace {

constexpr int side = 64;

/// Ways in which a student's program differs from the book's chapter on shadows.
struct Program {
  Vec2d sample{0.5, 0.5};  ///< inside the pixel, from its top left corner
  bool shadows = true, diffuse = true, highlights = true, ground = true;
  double point_light = 0.6, ambient_light = 0.2;
  bool truncates = false, sideways = false, upside_down = false, red_as_blue = false;
  double gamma = 1;
};

struct Ball {
  Vec3d centre;
  double radius;
  Vec3d colour;
  double shine;
};

/// "Computer Graphics from Scratch", chapters 2 to 4, without reflections.
class StudentTracer {
 public:
  explicit StudentTracer(const Program& program) : program_(program) {
    balls_ = {{{0, -1, 3}, 1, {1, 0, 0}, 500}, {{-2, 0, 4}, 1, {0, 1, 0}, 10}, {{2, 0, 4}, 1, {0, 0, 1}, 500}};
    if (program.ground) balls_.push_back({{0, -5001, 0}, 5000, {1, 1, 0}, 1000});
  }

  Image<Rgb8> picture() const {
    Image<Rgb8> levels(side, side);
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        const double x = column + program_.sample.x - side / 2.0, y = side / 2.0 - row - program_.sample.y;
        Vec3d colour = along({x / side, y / side, 1});
        if (program_.red_as_blue) std::swap(colour.x, colour.z);
        levels.at(program_.sideways ? side - 1 - column : column,
                  program_.upside_down ? side - 1 - row : row) = {level(colour.x), level(colour.y), level(colour.z)};
      }
    return levels;
  }

 private:
  std::uint8_t level(double value) const {
    const double shown = 255 * std::pow(std::clamp(value, 0.0, 1.0), 1 / program_.gamma);
    return static_cast<std::uint8_t>(program_.truncates ? shown : std::nearbyint(shown));
  }

  const Ball* nearest(const Vec3d& from, const Vec3d& way, double least, double most, double& found) const {
    const Ball* hit = nullptr;
    found = most;
    for (const Ball& ball : balls_) {
      const Vec3d to = from - ball.centre;
      const double a = dot(way, way), b = 2 * dot(to, way), c = dot(to, to) - ball.radius * ball.radius;
      const double under = b * b - 4 * a * c;
      if (under < 0) continue;
      for (const double t : {(-b + std::sqrt(under)) / (2 * a), (-b - std::sqrt(under)) / (2 * a)})
        if (t > least && t < found) {
          found = t;
          hit = &ball;
        }
    }
    return hit;
  }

  Vec3d along(const Vec3d& way) const {
    double t = 0;
    const Ball* ball = nearest({0, 0, 0}, way, 1, 1e30, t);
    if (!ball) return {1, 1, 1};
    const Vec3d point = way * t, outward = point - ball->centre, normal = outward * (1 / length(outward));
    const double light = program_.ambient_light +
                         lit(*ball, point, normal, -way, Vec3d(2, 1, 0) - point, 0.999999, program_.point_light) +
                         lit(*ball, point, normal, -way, {1, 4, 4}, 1e30, 0.2);
    return ball->colour * light;
  }

  double lit(const Ball& ball, const Vec3d& point, const Vec3d& normal, const Vec3d& eye, const Vec3d& to, double most,
             double strength) const {
    double t = 0;
    if (program_.shadows && nearest(point, to, 0.001, most, t)) return 0;
    double sum = 0;
    const double facing = dot(normal, to);
    if (program_.diffuse && facing > 0) sum += strength * facing / length(to);
    const Vec3d mirrored = normal * (2 * facing) - to;
    const double along_eye = dot(mirrored, eye);
    if (program_.highlights && along_eye > 0)
      sum += strength * std::pow(along_eye / (length(mirrored) * length(eye)), ball.shine);
    return sum;
  }

  const Program program_;
  std::vector<Ball> balls_;
};

MissingFeature missing_in(const Image<Rgb8>& file, const Scene& scene, const Settings& settings) {
  StudyControl control;
  return find_missing_feature(
      {.scene = scene, .view = {scene.camera, file.width(), file.height()}, .settings = settings, .file = file},
      control);
}

MissingFeature missing_in(const Program& program) {
  const Scene scene = load_scene("cgfs/shadows");
  return missing_in(StudentTracer(program).picture(), scene, settings_for(scene));
}

using Keys = std::vector<std::string>;

Keys sorted(Keys keys) {
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// The file is named by these changes, and by no other.
void expect_found(const MissingFeature& found, const Keys& keys, double least_share = 0.98) {
  EXPECT_EQ(found.verdict, MissingFeature::Verdict::found) << missing_sentence(found);
  EXPECT_EQ(sorted(found.best.keys), sorted(keys)) << missing_sentence(found);
  EXPECT_GE(found.best.near_share(), least_share) << missing_sentence(found);
  EXPECT_GT(found.best.equal, found.as_is.equal) << missing_sentence(found);
}

TEST(MissingFeature, TheSamePictureLacksNothing) {
  const MissingFeature found = missing_in(Program{});
  EXPECT_EQ(found.verdict, MissingFeature::Verdict::nothing_missing) << missing_sentence(found);
  EXPECT_TRUE(found.best.keys.empty());
  EXPECT_NE(missing_sentence(found).find("nothing is missing"), std::string::npos);
}

TEST(MissingFeature, OneThingMissing) {
  const MissingFeature highlights = missing_in({.highlights = false});
  expect_found(highlights, {"specular=off"});
  EXPECT_TRUE(missing_sentence(highlights).starts_with("A without highlights equals your file in "))
      << missing_sentence(highlights);
  expect_found(missing_in({.shadows = false}), {"shadows=none"});
  expect_found(missing_in({.ground = false}), {"object.3=off"});
  expect_found(missing_in({.point_light = 0}), {"light.1=off"});
  expect_found(missing_in({.ambient_light = 0}), {"light.0=off"});
}

TEST(MissingFeature, OneThingTooMuch) {
  expect_found(missing_in({.point_light = 1.2}), {"light.1=twice"});
  const Scene scene = load_scene("cgfs/shadows");
  Settings settings = settings_for(scene);
  settings.shadows = Shadows::none;
  expect_found(missing_in(StudentTracer({}).picture(), scene, settings), {"shadows=traced"});
  settings = settings_for(scene);
  settings.specular = false;
  expect_found(missing_in(StudentTracer({}).picture(), scene, settings), {"specular=on"});
}

TEST(MissingFeature, HalfAPixelAside) {
  expect_found(missing_in({.sample = {0, 1}}), {"sample-position=corner"});
  expect_found(missing_in({.sample = {0, 0}}), {"sample=top-left"});
  expect_found(missing_in({.sample = {1, 0}}), {"sample=top-right"});
  expect_found(missing_in({.sample = {1, 1}}), {"sample=bottom-right"});
}

TEST(MissingFeature, StoredOtherwise) {
  expect_found(missing_in({.truncates = true}), {"stored=truncated"});
  expect_found(missing_in({.sideways = true}), {"stored=mirrored"});
  expect_found(missing_in({.upside_down = true}), {"stored=upside-down"});
  expect_found(missing_in({.red_as_blue = true}), {"stored=red-as-blue"});
  expect_found(missing_in({.gamma = 2.2}), {"gamma=2.2"});
}

TEST(MissingFeature, TwoAtOnceAndThree) {
  expect_found(missing_in({.shadows = false, .highlights = false}), {"shadows=none", "specular=off"});
  expect_found(missing_in({.diffuse = false, .highlights = false}), {"diffuse=off", "specular=off"});
  expect_found(missing_in({.highlights = false, .truncates = true}), {"specular=off", "stored=truncated"});
  expect_found(missing_in({.shadows = false, .upside_down = true}), {"shadows=none", "stored=upside-down"});
  expect_found(missing_in({.highlights = false, .gamma = 2.2}), {"specular=off", "gamma=2.2"});
  // The book's programs: sampled at the corner; and with a truncated level.
  expect_found(missing_in({.sample = {0, 1}, .truncates = true}), {"sample-position=corner", "stored=truncated"});
  expect_found(missing_in({.sample = {0, 1}, .highlights = false, .truncates = true}),
               {"sample-position=corner", "specular=off", "stored=truncated"});
}

/// Listings sample where the book does, so A does, too.
MissingFeature missing_in_listing(const char* listing, const char* bug, const char* scene_name) {
  const Scene scene = load_scene(scene_name);
  Settings a = settings_for(scene);
  a.sample_position = SamplePosition::corner;
  Settings textbook = a;
  parse_assignment("renderer=textbook", textbook);
  parse_assignment(std::string("listing=") + listing, textbook);
  parse_assignment(std::string("listing-bug=") + bug, textbook);
  return missing_in(test::levels_of(scene, textbook, side, side), scene, a);
}

TEST(MissingFeature, ListingsWithAWrongLine) {
  expect_found(missing_in_listing("cgfs-02-basic-ray-tracing", "no-horizon", "cgfs/spheres"), {"object.3=off"});
}

/// This line takes the highlights away where they belong, and puts faint ones elsewhere: the nearest is named as such.
TEST(MissingFeature, TheNearestWhereNoneFitsWholly) {
  const MissingFeature found = missing_in_listing("cgfs-03-light", "lost-highlights", "cgfs/lights");
  EXPECT_EQ(found.verdict, MissingFeature::Verdict::unexplained);
  EXPECT_EQ(found.best.keys, Keys{"specular=off"}) << missing_sentence(found);
  EXPECT_GT(found.best.near_share(), 0.95);
  EXPECT_NE(missing_sentence(found).find("Nearest: A without highlights equals it in 9"), std::string::npos);
}

/// A wrong formula is not a feature: then none is named as the cause.
TEST(MissingFeature, NothingThatFits) {
  for (const auto& [listing, bug, scene] :
       {std::tuple{"cgfs-03-light", "black-fronts", "cgfs/lights"},
        std::tuple{"cgfs-03-light", "dazzling", "cgfs/lights"},
        std::tuple{"cgfs-02-basic-ray-tracing", "sunken-spheres", "cgfs/spheres"}}) {
    const MissingFeature found = missing_in_listing(listing, bug, scene);
    EXPECT_EQ(found.verdict, MissingFeature::Verdict::unexplained) << bug << ": " << missing_sentence(found);
    EXPECT_TRUE(missing_sentence(found).starts_with("None of ")) << missing_sentence(found);
  }
  const Scene shadows = load_scene("cgfs/shadows"), cubes = load_scene("cgfs/cubes");
  const MissingFeature other =
      missing_in(test::levels_of(cubes, settings_for(cubes), side, side), shadows, settings_for(shadows));
  EXPECT_EQ(other.verdict, MissingFeature::Verdict::unexplained) << missing_sentence(other);
}

TEST(MissingFeature, AnotherSizeIsRefused) {
  const Scene scene = load_scene("cgfs/shadows");
  const std::string refusal = test::refusal_of([&] {
    StudyControl control;
    find_missing_feature({.scene = scene, .view = {scene.camera, 20, 10}, .settings = {}, .file = Image<Rgb8>(10, 10)},
                         control);
  });
  EXPECT_EQ(refusal, "the file has 10 x 10 pixels, expected 20 x 10");
}

TEST(MissingFeature, TheCommandLineSaysTheSame) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("dull.png");
  save_image(file, StudentTracer({.highlights = false}).picture());
  const auto answer =
      nlohmann::json::parse(test::run_cli_well({"missing", "cgfs/shadows", file, "--pixel", "31,40", "--json"}).out);
  EXPECT_EQ(answer["verdict"], "found");
  EXPECT_EQ(answer["best"]["changes"], Keys{"specular=off"});
  EXPECT_EQ(answer["best"]["pixels"], side * side);
  EXPECT_GT(answer["pixel"]["rows"].size(), 2u);
  EXPECT_TRUE(answer.contains("provenance"));
  const std::string text = test::run_cli_well({"missing", "cgfs/shadows", file}).out;
  EXPECT_TRUE(text.starts_with("A without highlights equals " + file + " in ")) << text;
  EXPECT_EQ(test::run_cli({"missing", "cgfs/shadows", file, "--size", "9x9"}).status, 2);
  EXPECT_EQ(test::run_cli({"missing", "cgfs/shadows", file, "--pixel", "64,3"}).status, 2);
}

/// The story of A at the pixel where the file differs most, beside the file's levels there.
struct Asked {
  PixelStory story;
  MissingTerm term;
};
Asked most_different(const Program& program, const Settings* asked = nullptr) {
  const Scene scene = load_scene("cgfs/shadows");
  const Settings settings = asked ? *asked : settings_for(scene);
  const Image<Rgb8> ours = test::levels_of(scene, settings, side, side), file = StudentTracer(program).picture();
  Vec2i most{0, 0};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (largest_difference(ours.at(x, y), file.at(x, y)) >
          largest_difference(ours.at(most.x, most.y), file.at(most.x, most.y)))
        most = {x, y};
  Asked answer{inspect(scene, {scene.camera, side, side}, settings, most), {}};
  answer.term = find_missing_term(answer.story, display_transform(settings), file.at(most.x, most.y));
  return answer;
}

std::string named(const Asked& asked) {
  std::string terms;
  for (const std::size_t line : asked.term.named) {
    const std::string& term = asked.story.ledger[line].term;
    terms += term.substr(0, term.find(": ")) + ";";
  }
  return terms;
}

TEST(MissingTerm, NamesTheRowOfTheSum) {
  const Asked highlight = most_different({.highlights = false});
  EXPECT_EQ(highlight.term.change, MissingTerm::Change::left_out) << highlight.term.sentence;
  EXPECT_EQ(named(highlight), "light 1 (point) specular;") << highlight.term.sentence;
  EXPECT_NE(highlight.term.sentence.find(" levels too dark: that is the highlight of light 1 (point), "),
            std::string::npos)
      << highlight.term.sentence;
  EXPECT_EQ(named(most_different({.ambient_light = 0})), "light 0 (ambient);");
  const Asked twice = most_different({.ambient_light = 0.4});
  EXPECT_EQ(twice.term.change, MissingTerm::Change::counted_twice) << twice.term.sentence;
  EXPECT_EQ(named(twice), "light 0 (ambient);") << twice.term.sentence;
}

TEST(MissingTerm, NamesTwoRowsTogether) {
  const Asked point = most_different({.point_light = 0});
  EXPECT_EQ(named(point), "light 1 (point) diffuse;light 1 (point) specular;") << point.term.sentence;
}

TEST(MissingTerm, NamesNoRowWhereNoneFits) {
  const Asked gamma = most_different({.gamma = 2.2});
  EXPECT_EQ(gamma.term.change, MissingTerm::Change::none) << gamma.term.sentence;
  EXPECT_TRUE(gamma.term.named.empty());
  EXPECT_EQ(most_different({}).term.change, MissingTerm::Change::none);
}

/// A mirror without reflections shows its own colour whole: no row is left out or doubled.
TEST(MissingTerm, NamesALocalColourThatCountsWhole) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = settings_for(scene);
  const Vec2i pixel{33, 45};  // on the red ball
  settings.reflection_depth = 0;
  const Rgb8 other = test::levels_of(scene, settings, side, side).at(pixel.x, pixel.y);
  const PixelStory story = inspect(scene, {scene.camera, side, side}, settings_for(scene), pixel);
  const MissingTerm term = find_missing_term(story, {}, other);
  EXPECT_EQ(term.change, MissingTerm::Change::unmixed) << term.sentence;
  EXPECT_TRUE(term.sentence.ends_with("red: 0.8 x local colour counted whole, and nothing reflected."))
      << term.sentence;
}

/// Beside a clamped sum a row counts for what is seen of it.
TEST(MissingTerm, CountsWhatIsSeenOfAClampedSum) {
  PixelStory story;
  story.linear = {1.5, 0.2, 0};
  story.display = {255, 51, 0};
  story.ledger = {{0, LedgerTerm::light, "light 0 (ambient): all", {0.9, 0.2, 0}, -1, "light 0 (ambient)"},
                  {0, LedgerTerm::specular, "light 1 (point) specular: all", {0.6, 0, 0}, -1, "light 1 (point)"}};
  const MissingTerm term = find_missing_term(story, {}, {230, 51, 0});
  EXPECT_EQ(term.sentence, "Red is 25 levels too dark: that is the highlight of light 1 (point), 25.");
  EXPECT_EQ(term.rows[1].adds[0], 25);
}

}  // namespace
}  // namespace ps::missing_feature_test
