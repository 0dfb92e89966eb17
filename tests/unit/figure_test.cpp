// Figures of lessons: their kinds against closed forms that are written anew, the places of faults, and that no label
// of a shipped figure leaves its column or lies on another.
#include "engine/figure.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/figure_rules.h"
#include "engine/handout.h"
#include "engine/lesson.h"
#include "engine/maths_writers.h"
#include "image/svg.h"
#include "support/read_figures.h"
#include "support/render_once.h"

namespace ps::figure_test {
namespace {

using test::figure_fault;
using test::figure_of;
using test::marks_of;

std::string text_of(const FigureLabel& label) {
  return label.formula.empty() ? label.words : plain_maths(label.formula);
}

std::vector<FigureLine> lines_in(const Figure& figure, Role role, LineTip tip) {
  std::vector<FigureLine> lines;
  for (const FigureLine& line : marks_of<FigureLine>(figure))
    if (line.stroke.tint.role == role && line.tip == tip) lines.push_back(line);
  return lines;
}

FigureLabel label_in(const Figure& figure, const std::string& text) {
  for (const FigureLabel& label : marks_of<FigureLabel>(figure))
    if (text_of(label) == text) return label;
  ADD_FAILURE() << "no label " << text;
  return {};
}

double angle_from_vertical(const Vec2d& way) { return std::atan2(std::abs(way.x), std::abs(way.y)); }

TEST(Figure, MarksLieWhereTheDescriptionPutsThem) {
  const Figure figure =
      figure_of("place A (1, 2)\nplace B along A (5, 2) 0.25\nplace C turn B A 90\n"
                "place D foot (3, 7) A B\nplace T tangent (0, 0) (5, 0) 3\nplace E meet (0, 0) (2, 2) (0, 2) (2, 0)\n"
                "arrow A B light dashed : $\\vec L$\nline C D E T");
  EXPECT_EQ(figure.description, "Words.");
  const auto lines = marks_of<FigureLine>(figure);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].places, (std::vector<Vec2d>{{1, 2}, {2, 2}}));
  EXPECT_EQ(lines[0].tip, LineTip::arrow);
  EXPECT_EQ(lines[0].stroke.dash, dashed);
  const std::vector<Vec2d> others{{1, 3}, {3, 2}, {1, 1}, {4 * 0.8, -4 * 0.6}};  // the last: 3, 4, 5
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_NEAR(lines[1].places.at(i).x, others[i].x, 1e-12);
    EXPECT_NEAR(lines[1].places.at(i).y, others[i].y, 1e-12);
  }
  EXPECT_EQ(text_of(label_in(figure, "L")), "L");
}

TEST(Figure, EveryFaultIsNamedWithItsPlace) {
  EXPECT_EQ(figure_fault("alt A.\narow (0, 0) (1, 1)"), "lesson.md:11:1: found 'arow', expected 'arrow'");
  EXPECT_EQ(figure_fault("alt A.\n  line (0, 0) (1, x)"), "lesson.md:11:19: found 'x', expected a number");
  EXPECT_EQ(figure_fault("alt A.\nplace Peak (0, 0)\nline (0, 0) Pek"),
            "lesson.md:12:13: found 'Pek', expected (x, y) or a place that has a name; did you mean 'Peak'?");
  EXPECT_EQ(figure_fault("alt A.\ndot (0, 0) : $\\vecc N$"),
            "lesson.md:11:15: found the unknown command '\\vecc', expected '\\vec'");
  EXPECT_EQ(figure_fault("alt A.\nrefraction angle=95"), "lesson.md:11:18: found '95', expected a number from 0 to 89");
  EXPECT_EQ(figure_fault("alt A.\nrefraction angel=40"), "lesson.md:11:12: found 'angel', expected 'angle'");
  EXPECT_EQ(figure_fault("alt A.\nintervals a=1,4,2"),
            "lesson.md:11:13: found '1,4,2', expected pairs of ends, each larger than the one before");
  EXPECT_EQ(figure_fault("alt A.\nline (0, 0) (1, 1"),
            "lesson.md:11:13: found '(' without its partner, expected (x, y)");
  EXPECT_EQ(figure_fault("line (0, 0) (1, 1)"),
            "lesson.md:10:1: found a figure without a description, expected a line 'alt What it shows.'");
  EXPECT_EQ(figure_fault("alt A.\n"),
            "lesson.md:10:1: found a figure without marks, expected lines such as 'arrow (0, 0) (2, 1)'");
}

TEST(Figure, ProjectionHasSimilarTriangles) {
  const Figure figure = figure_of("projection distance=1.5 points=(6,4)");
  const Vec2d image = label_in(figure, "P′").at;
  EXPECT_DOUBLE_EQ(image.x, 1.5);
  EXPECT_DOUBLE_EQ(image.y / 1.5, 4.0 / 6);  // the same slope as that of P
}

/// Snell: n1 sin θ1 = n2 sin θ2, read off the directions of the arrows.
TEST(Figure, RefractionFollowsSnell) {
  for (const auto& [angle, from, to] : {std::array{50.0, 1.0, 1.5}, {20, 1.5, 1}, {70, 1.33, 2.4}}) {
    const Figure figure = figure_of(fmt::format("refraction angle={} from={} to={}", angle, from, to));
    const auto beyond = lines_in(figure, Role::a, LineTip::arrow), came = lines_in(figure, Role::light, LineTip::arrow);
    ASSERT_EQ(beyond.size(), 1u);
    const double theta_1 = angle_from_vertical(came.at(0).places[1] - came[0].places[0]),
                 theta_2 = angle_from_vertical(beyond[0].places[1] - beyond[0].places[0]);
    EXPECT_NEAR(theta_1, angle * 3.14159265358979 / 180, 1e-9);
    EXPECT_NEAR(from * std::sin(theta_1), to * std::sin(theta_2), 1e-12);
    EXPECT_LT(beyond[0].places[1].y, 0);
  }
  const double critical = std::asin(1 / 1.5) * 180 / 3.14159265358979;
  EXPECT_TRUE(
      lines_in(figure_of(fmt::format("refraction angle={} from=1.5 to=1", critical + 0.1)), Role::a, LineTip::arrow)
          .empty());
  EXPECT_FALSE(
      lines_in(figure_of(fmt::format("refraction angle={} from=1.5 to=1", critical - 0.1)), Role::a, LineTip::arrow)
          .empty());
}

/// R lies as far beyond N as L before it, and H halves the angle between L and V.
TEST(Figure, SurfaceVectorsHaveTheirAngles) {
  const Figure figure = figure_of("surface light=50 eye=20");
  const auto degrees = [&](const std::string& name) {
    const Vec2d tip = label_in(figure, name).at;
    EXPECT_NEAR(std::hypot(tip.x, tip.y), 1, 1e-12) << name;
    return std::atan2(tip.x, tip.y) * 180 / 3.14159265358979;
  };
  EXPECT_NEAR(degrees("L"), -50, 1e-9);
  EXPECT_NEAR(degrees("R"), 50, 1e-9);
  EXPECT_NEAR(degrees("V"), 20, 1e-9);
  EXPECT_NEAR(degrees("H"), -15, 1e-9);
}

bool inside(const std::vector<FigureInterval>& parts, double t) {
  for (const auto& [from, to] : parts)
    if (from < t && t < to) return true;
  return false;
}

/// At random places of the ray, the result is what the operation says of the two solids there.
TEST(Figure, IntervalsFollowTheOperation) {
  constexpr unsigned seed = 471;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> end(0, 12);
  const auto some = [&] {
    std::vector<FigureInterval> parts;
    for (int t = end(random) % 4; t < 12; t += 1 + end(random) % 3) {
      const int to = t + 1 + end(random) % 4;
      parts.emplace_back(t, to);
      t = to;
    }
    return parts;
  };
  for (int i = 0; i < 200; ++i) {
    const auto a = some(), b = some();
    const auto join = combined(a, b, FigureOperation::join), overlap = combined(a, b, FigureOperation::overlap),
               cut = combined(a, b, FigureOperation::cut);
    for (double t = 0.25; t < 20; t += 0.5) {
      EXPECT_EQ(inside(join, t), inside(a, t) || inside(b, t)) << "seed " << seed;
      EXPECT_EQ(inside(overlap, t), inside(a, t) && inside(b, t)) << "seed " << seed;
      EXPECT_EQ(inside(cut, t), inside(a, t) && !inside(b, t)) << "seed " << seed;
    }
    for (std::size_t k = 1; k < join.size(); ++k) EXPECT_LT(join[k - 1].second, join[k].first);
  }
  EXPECT_EQ(label_in(figure_of("intervals a=1,5 b=3,7 operation=difference"), "A − B").at.x, 0);
}

/// Perspective halves the image of a span where the depth is the harmonic mean of its ends.
TEST(Figure, DepthAlongASpanIsNotStraight) {
  EXPECT_DOUBLE_EQ(depth_on_screen(1, 6, 0.5), 2.0 * 1 * 6 / (1 + 6));
  EXPECT_DOUBLE_EQ(depth_on_screen(2, 5, 0), 2);
  EXPECT_DOUBLE_EQ(depth_on_screen(2, 5, 1), 5);
  const Figure figure = figure_of("depth-along-span first=1 last=6");
  EXPECT_GT(label_in(figure, "3.5").at.y, label_in(figure, "1.714").at.y);
}

/// The signs are those of the barycentric coordinates, from areas.
TEST(Figure, EdgeSignsAreThoseOfBarycentricCoordinates) {
  const std::array<Vec2d, 3> v{{{1, 0.5}, {6, 1.5}, {3, 5}}};
  const auto area = [](const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    return (a.x * (b.y - c.y) + b.x * (c.y - a.y) + c.x * (a.y - b.y)) / 2;
  };
  int labels = 0;
  for (const FigureLabel& label : marks_of<FigureLabel>(figure_of("edge-signs"))) {
    std::string signs;
    for (std::size_t i = 0; i < 3; ++i) signs += area(v[i], v[(i + 1) % 3], label.at) > 0 ? "+" : "−";
    EXPECT_EQ(text_of(label), signs);
    ++labels;
  }
  EXPECT_EQ(labels, 7);
}

/// The count at the surface is the number of volumes that it lies in, minus those that hold the eye.
TEST(Figure, VolumesAreCountedUpToTheSurface) {
  label_in(figure_of("volume-count volumes=2,6 surface=4"), "sum 1");
  label_in(figure_of("volume-count volumes=2,6 surface=7"), "sum 0");
  label_in(figure_of("volume-count volumes=-1,3,4,9 surface=7"), "sum 0");  // the eye in a volume: one too few
}

TEST(Figure, LeavesOfATreeTileItAndHoldFewPoints) {
  constexpr unsigned seed = 472;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 8);
  std::vector<Vec2d> points(60);
  for (Vec2d& point : points) point = {place(random), place(random)};
  const auto leaves = quadtree_leaves(points, {{0, 0}, 8, 0}, 2, 6);
  double area = 0;
  int count = 0;
  for (const FigureCell& cell : leaves) {
    area += cell.size * cell.size;
    count += cell.count;
    EXPECT_TRUE(cell.count <= 2 || cell.size <= 8.0 / 64) << "seed " << seed;
  }
  EXPECT_DOUBLE_EQ(area, 64);
  EXPECT_EQ(count, 60) << "seed " << seed;
}

/// Rays through the four edges of the pixel, met with the ground.
TEST(Figure, FootprintIsWhereThePixelsEdgesMeetTheGround) {
  const Footprint print = footprint_of(4, 12, 0.1);
  EXPECT_NEAR(print.near * (4.0 / 12 + 0.05), 4, 1e-12);
  EXPECT_NEAR(print.far * (4.0 / 12 - 0.05), 4, 1e-12);
  EXPECT_NEAR(print.far_width / print.near_width, print.far / print.near, 1e-12);
}

TEST(Figure, HitsAreOnTheCircleAndTheRay) {
  const Figure figure = figure_of("hits (0, 0) (8, 1.4) (5, 0.5) 1.5");
  const auto dots = marks_of<FigureDot>(figure);
  ASSERT_EQ(dots.size(), 2u);
  for (const FigureDot& dot : dots) {
    EXPECT_NEAR(std::hypot(dot.at.x - 5, dot.at.y - 0.5), 1.5, 1e-12);
    EXPECT_NEAR(dot.at.y / dot.at.x, 1.4 / 8, 1e-12);
  }
  EXPECT_LT(dots[0].at.x, dots[1].at.x);
}

/// One pixel a column of the longer side, none farther than half a pixel from the line.
TEST(Figure, PixelsOfALineAreWithinHalfAPixelOfIt) {
  const auto cells = marks_of<FigureArea>(figure_of("grid (0, 0) (10, 6)\npixels (0, 1) (9, 5)"));
  ASSERT_EQ(cells.size(), 10u);
  for (const FigureArea& cell : cells) EXPECT_LE(std::abs(cell.corners[0].y - (1 + 4.0 / 9 * cell.corners[0].x)), 0.5);
}

/// Bias lifts what is stored; half a texel's rise leaves no acne.
TEST(Figure, ABiasOfHalfATexelsSlopeEndsAcne) {
  const auto wrong = [](double bias) {
    return lines_in(figure_of(fmt::format("map-steps angle=45 texels=5 bias={}", bias)), Role::wrong, LineTip::plain);
  };
  ASSERT_EQ(wrong(0).size(), 5u);
  EXPECT_NEAR(wrong(0)[0].places[0].x, 0.5, 1e-12);
  EXPECT_NEAR(wrong(0.25)[0].places[0].x, 0.75, 1e-12);
  EXPECT_TRUE(wrong(0.51).empty());
}

/// A painter that only notes where texts lie, each letter half an em wide.
class NotingPainter final : public Painter {
 public:
  struct Text {
    PaintArea area;
    std::string words;
  };
  explicit NotingPainter(double scale) : Painter(scale) {}
  void polyline(std::span<const Vec2d>, const Stroke&) override {}
  void polygon(std::span<const Vec2d>, const ShapeLook&) override {}
  void rectangle(const PaintArea&, const ShapeLook&, double) override {}
  void circle(const Vec2d& middle, double radius, const ShapeLook&) override {
    const Vec2d reach(radius, radius);
    dots.push_back({middle - reach, middle + reach});
  }
  void picture(const PaintArea&, const Image<Rgb8>&) override {}
  void begin_clip(const PaintArea&) override {}
  void end_clip() override {}
  TextExtent extent(std::string_view text, Lettering lettering) const override {
    const auto letters = std::count_if(text.begin(), text.end(),
                                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; });
    const double em = px(em_of(lettering));
    return {0.5 * em * static_cast<double>(letters), em, 0.25 * em};
  }
  std::vector<Text> texts;
  std::vector<PaintArea> dots;

 private:
  void write(const Vec2d& at, std::string_view words, const TextLook& look) override {
    const double em = px(em_of(look.lettering)), width = extent(words, look.lettering).width;
    const double from = at.x - (look.anchor == TextAnchor::middle ? width / 2 : 0);
    texts.push_back({{{from, at.y - 0.7 * em}, {from + width, at.y}}, std::string(words)});
  }
};

bool overlap(const PaintArea& a, const PaintArea& b) {
  return std::min(a.high.x, b.high.x) > std::max(a.low.x, b.low.x) + 1 &&
         std::min(a.high.y, b.high.y) > std::max(a.low.y, b.low.y) + 1;
}

/// The first fault of the labels of a figure in a column of this width; empty if they are free.
std::string fault_of_labels(const Figure& figure, double width) {
  NotingPainter painter(1);
  const double height = figure_height(painter, figure, width);
  draw_figure(painter, figure, {0, 0}, width);
  for (std::size_t i = 0; i < painter.texts.size(); ++i) {
    const auto& [area, words] = painter.texts[i];
    if (area.low.x < -1 || area.low.y < -1 || area.high.x > width + 1 || area.high.y > height + 1)
      return "'" + words + "' leaves the figure";
    for (std::size_t k = 0; k < i; ++k)
      if (overlap(area, painter.texts[k].area)) return "'" + words + "' lies on '" + painter.texts[k].words + "'";
  }
  return {};
}

TEST(Figure, LabelsThatLieOnEachOtherAreFound) {
  EXPECT_EQ(fault_of_labels(figure_of("label (0, 0) : first\nlabel (0, 0) : second\nline (-1, -1) (1, 1)"), 400),
            "'second' lies on 'first'");
  EXPECT_EQ(fault_of_labels(figure_of("dot (0, 0) to-the-left : a label\ndot (1, 1) to-the-right : another"), 400), "");
}

TEST(Figure, LabelsOfAllLessonsAreFree) {
  int figures = 0, lessons = 0;
  for (const std::string& name : lesson_names()) {
    const Lesson lesson = load_lesson(name);
    const int before = figures;
    for (const LessonStep& step : lesson.steps)
      for (const TextBlock& block : step.blocks) {
        if (!block.figure) continue;
        ++figures;
        for (const double width : {330.0, 420.0, 700.0})
          EXPECT_EQ(fault_of_labels(*block.figure, width), "") << name << ": " << step.title << " at " << width;
      }
    lessons += figures > before ? 1 : 0;
  }
  EXPECT_GE(lessons, 25);
  RecordProperty("figures", figures);
}

/// The story of a pixel in the pictures of a step.
PixelStory story_of(const Document& document, const Vec2i& pixel, Prepared& prepared) {
  Progress progress;
  return inspect(document.scene, view_of(document), side_of(document, document.picked).settings, pixel, prepared,
                 progress);
}

TEST(Figure, ThoseOfAPixelHaveFreeLabelsAtEveryPixel) {
  int figures = 0, followed = 0;
  for (const std::string& name : lesson_names()) {
    const Lesson lesson = load_lesson(name);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      std::optional<Document> document;
      Prepared prepared;
      for (const TextBlock& block : lesson.steps[i].blocks) {
        if (!block.figure || block.figure->of_pixel.empty()) continue;
        if (!document) document = lesson_document(lesson, static_cast<int>(i), Document{});
        ++figures;
        const View view = view_of(*document);
        for (int y = view.height / 16; y < view.height; y += view.height / 8)
          for (int x = view.width / 16; x < view.width; x += view.width / 8) {
            const PixelStory story = story_of(*document, {x, y}, prepared);
            const auto figure = figure_of_pixel(block.figure, &story);
            followed += figure->note.starts_with("At pixel") ? 1 : 0;
            for (const double width : {330.0, 700.0})
              EXPECT_EQ(fault_of_labels(*figure, width), "") << name << " " << i + 1 << ": " << figure->note;
          }
      }
    }
  }
  EXPECT_GE(figures, 3);
  EXPECT_GE(followed, 10 * figures);
}

TEST(Figure, HandoutsHaveThemAsDrawingsWithTheirWords) {
  const Lesson lesson =
      parse_lesson("# Title\nsource: none\n```settings\nscene cgfs/spheres\n```\n## Step\n\nBefore.\n\n"
                   "```figure\nalt A < B.\narrow (0, 0) (2, 1) : $\\vec v$\n```\n\nBehind.\n",
                   "figures", "lesson.md");
  const std::vector<TextBlock>& blocks = lesson.steps.at(0).blocks;
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_EQ(blocks[1].kind, BlockKind::figure);
  EXPECT_EQ(plain_text(blocks[1]), "A < B.");
  EXPECT_EQ(plain_text(blocks[2]), "Behind.");
  const std::string html = block_html(blocks);
  EXPECT_NE(html.find("<p>Before.</p>\n<figure class=\"drawing\" role=\"img\" aria-label=\"A &lt; B.\"><svg"),
            std::string::npos);
  EXPECT_NE(html.find(">v</text>"), std::string::npos);
}

}  // namespace
}  // namespace ps::figure_test
