// The same drawing on the screen and on paper: each thing lies in the same place in the same colour, and what can be
// read from the file can be read from the window's draw list.
#include "image/painter.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cstdio>
#include <functional>
#include <numbers>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "gui/theme/contrast.h"
#include "gui/theme/shade.h"
#include "gui/widgets/screen_painter.h"
#include "image/svg.h"
#include "inspect/microscope/drawing.h"
#include "inspect/space_drawing.h"

namespace painter_test {
namespace {

using namespace ps;

/// Where something was drawn, and in which colours.
struct Drawn {
  Vec2d low{1e9, 1e9}, high{-1e9, -1e9};
  std::set<std::string> colours;
  void add(const Vec2d& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
};

std::string hex(unsigned r, unsigned g, unsigned b) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", r, g, b);
  return text;
}

/// Numbers in an attribute of an element, "x1" of <line x1="3.5">.
std::vector<double> numbers(const std::string& element, const std::string& name) {
  const std::size_t at = element.find(" " + name + "=\"");
  std::vector<double> found;
  if (at == std::string::npos) return found;
  const std::size_t from = at + name.size() + 3;
  std::string text = element.substr(from, element.find('"', from) - from);
  for (char& c : text)
    if (c == ',') c = ' ';
  std::istringstream words(text);
  for (double number; words >> number;) found.push_back(number);
  return found;
}

double number(const std::string& element, const std::string& name, double otherwise = 0) {
  const auto all = numbers(element, name);
  return all.empty() ? otherwise : all.front();
}

/// Reads the elements of an SVG file after its ground.
Drawn of_paper(const std::string& svg) {
  Drawn drawn;
  const std::size_t ground = svg.find("fill=\"#ffffff\"/>");
  const std::string body =
      std::regex_replace(svg.substr(svg.find('\n', ground)), std::regex("<clipPath.*</clipPath>"), "");
  static const std::regex element("<(line|polyline|polygon|rect|circle|text)\\b[^>]*>");
  for (auto it = std::sregex_iterator(body.begin(), body.end(), element); it != std::sregex_iterator(); ++it) {
    const std::string text = it->str(), kind = (*it)[1];
    const double wide = text.find("stroke=") == std::string::npos ? 0 : number(text, "stroke-width") / 2;
    const auto add = [&](double x, double y, double by) {
      drawn.add(Vec2d(x, y) - by);
      drawn.add(Vec2d(x, y) + by);
    };
    if (kind == "line") {
      add(number(text, "x1"), number(text, "y1"), wide);
      add(number(text, "x2"), number(text, "y2"), wide);
    } else if (kind == "circle") {
      add(number(text, "cx"), number(text, "cy"), number(text, "r") + wide);
    } else if (kind == "rect") {
      add(number(text, "x"), number(text, "y"), wide);
      add(number(text, "x") + number(text, "width"), number(text, "y") + number(text, "height"), wide);
    } else if (kind == "text") {
      add(number(text, "x"), number(text, "y"), 0);
    } else {
      const auto points = numbers(text, "points");
      for (std::size_t i = 0; i + 1 < points.size(); i += 2) add(points[i], points[i + 1], wide);
    }
    static const std::regex colour("(?:fill|stroke)=\"(#[0-9a-f]{6})\"");
    for (auto c = std::sregex_iterator(text.begin(), text.end(), colour); c != std::sregex_iterator(); ++c)
      drawn.colours.insert((*c)[1]);
  }
  return drawn;
}

/// Reads the vertices that a draw list has got, from the `first` on.
Drawn of_screen(const ImDrawList& list, int first) {
  Drawn drawn;
  for (int i = first; i < list.VtxBuffer.Size; ++i) {
    const ImDrawVert& vertex = list.VtxBuffer[i];
    drawn.add({vertex.pos.x, vertex.pos.y});
    if ((vertex.col >> IM_COL32_A_SHIFT & 255u) == 0) continue;  // the soft edge of a shape
    drawn.colours.insert(hex(vertex.col >> IM_COL32_R_SHIFT & 255u, vertex.col >> IM_COL32_G_SHIFT & 255u,
                             vertex.col >> IM_COL32_B_SHIFT & 255u));
  }
  return drawn;
}

class PainterTest : public testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {800, 800};
    gui::theme().set_brightness(gui::Brightness::light);
    for (const double scale : {1.25, 1.0}) {  // fonts belong to a context, and are loaded where the scale changes
      gui::theme().set_scale(scale);
      gui::theme().prepare();
    }
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImGui::NewFrame();
  }
  void TearDown() override { ImGui::DestroyContext(); }

  struct Both {
    Drawn screen, paper;
    std::string svg;
  };
  /// Draws on both, and leaves `picture` out on the screen, which comes first if there is one.
  template <class Draw>
  static Both both(const Draw& draw, const Image<Rgb8>* picture = nullptr) {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    const std::array pictures{gui::ScreenPicture{picture, list._CmdHeader.TextureId}};
    gui::ScreenPainter screen(list, pictures);
    draw(screen);
    SvgPainter paper(800, 800, "test");
    draw(paper);
    return {of_screen(list, picture ? 4 : 0), of_paper(paper.finish()), paper.finish()};
  }

  /// Same colours, and the same place but for the soft edge of about a pixel around what the screen shows.
  static void expect_same(const Both& both, double room, const std::string& what) {
    EXPECT_EQ(both.screen.colours, both.paper.colours) << what << "\n" << both.svg;
    EXPECT_LE(glm::length(both.screen.low - both.paper.low), room) << what << "\n" << both.svg;
    EXPECT_LE(glm::length(both.screen.high - both.paper.high), room) << what << "\n" << both.svg;
  }
};

constexpr double soft_edge = 2.6;  // diagonal of a pixel and of its soft edge
constexpr double sharp_tip = 2.4;  // how far the tip of a sharp corner reaches beyond its lines

TEST_F(PainterTest, EachShapeIsTheSameOnTheScreenAndOnPaper) {
  const std::vector<Vec2d> bent{{100, 100}, {180, 140}, {150, 220}}, square{{50, 60}, {90, 60}, {90, 110}, {50, 110}};
  const Stroke blue{{Role::mirror}, 3}, cut{{Role::wrong, 0.5}, 2, dashed};
  const ShapeLook full{Tint{Role::attention}, Stroke{{Role::ink}, 2}};
  const std::vector<std::pair<std::string, std::function<void(Painter&)>>> shapes{
      {"line",
       [&](Painter& p) {
         p.line({10, 20}, {200, 120}, blue);
       }},
      {"polyline", [&](Painter& p) { p.polyline(bent, blue); }},
      {"filled polygon",
       [&](Painter& p) {
         p.polygon(square, {.fill = Tint{Role::right, 0.4}});
       }},
      {"outlined polygon", [&](Painter& p) { p.polygon(square, {.stroke = blue}); }},
      {"polygon", [&](Painter& p) { p.polygon(square, full); }},
      {"dashed polygon", [&](Painter& p) { p.polygon(square, {.stroke = cut}); }},
      {"rectangle",
       [&](Painter& p) {
         p.rectangle({{20, 30}, {70, 50}}, full);
       }},
      {"rounded rectangle",
       [&](Painter& p) {
         p.rectangle({{20, 30}, {70, 50}}, full, 4);
       }},
      {"circle",
       [&](Painter& p) {
         p.circle({300, 200}, 40, full);
       }},
      {"ring",
       [&](Painter& p) {
         p.circle({300, 200}, 40, {.stroke = blue});
       }},
      {"arc",
       [&](Painter& p) {
         p.arc({300, 200}, 40, 0, std::numbers::pi / 2, blue);
       }},
      {"colour of its own", [&](Painter& p) {
         p.line({1, 1}, {9, 9}, {{Role::own, 1, {1, 2, 3}}, 2});
       }}};
  for (const auto& [name, draw] : shapes) expect_same(both(draw), soft_edge, name);
}

TEST_F(PainterTest, EveryRoleIsThatOfALightWindowAndStandsOutOnPaper) {
  using gui::shade;
  const gui::Palette light = gui::make_palette(gui::Brightness::light), dark = gui::make_palette(gui::Brightness::dark);
  for (int i = 0; i < static_cast<int>(Role::own); ++i) {
    const auto role = static_cast<Role>(i);
    const Rgb8 paper = paper_shade(role);
    EXPECT_EQ(gui::colour_u32(shade(light, role)), IM_COL32(paper.r, paper.g, paper.b, 255)) << i;
    const bool mark = role <= Role::border || (role >= Role::a && role <= Role::wrong);
    if (!mark) continue;
    EXPECT_GE(gui::contrast(shade(light, role), shade(light, Role::paper)), gui::mark_contrast) << i;
    EXPECT_GE(gui::contrast(shade(dark, role), shade(dark, Role::paper)), gui::mark_contrast) << i;
  }
}

TEST_F(PainterTest, TextHasTheSameSizeAndPlaceAndTheSameAnchors) {
  const auto face_size = [](Lettering lettering) {
    return lettering < Lettering::body       ? gui::type_size(gui::Face::small)
           : lettering < Lettering::heading  ? gui::type_size(gui::Face::body)
           : lettering == Lettering::heading ? gui::type_size(gui::Face::heading)
                                             : gui::type_size(gui::Face::script);
  };
  for (int i = 0; i <= static_cast<int>(Lettering::script_italic); ++i)
    EXPECT_DOUBLE_EQ(em_of(static_cast<Lettering>(i)), face_size(static_cast<Lettering>(i))) << i;
  // The same place of letters under all anchors, as far as a file can know their width.
  const std::string words = "normal of the triangle";
  for (const TextAnchor anchor : {TextAnchor::start, TextAnchor::middle, TextAnchor::end})
    for (const TextLevel level : {TextLevel::baseline, TextLevel::middle, TextLevel::top}) {
      TextLook look{.anchor = anchor, .level = level, .ground = TextGround::plate};
      const Both drawn = both([&](Painter& painter) { painter.text({400, 300}, words, look); });
      const double width = drawn.paper.high.x - drawn.paper.low.x;
      EXPECT_EQ(drawn.screen.colours, drawn.paper.colours);
      EXPECT_NEAR(drawn.screen.low.y, drawn.paper.low.y, 2);
      EXPECT_NEAR(drawn.screen.high.y, drawn.paper.high.y, 2);
      EXPECT_NEAR(drawn.screen.high.x - drawn.screen.low.x, width, 0.25 * width);
      if (anchor == TextAnchor::middle) {
        EXPECT_NEAR(drawn.screen.low.x + drawn.screen.high.x, 800, 2);
      }
    }
  EXPECT_EQ(both([](Painter& p) { p.text({9, 9}, "", {}); }).screen.colours.size(), 0u);
}

/// Every kind of item of the space view, one by one.
TEST_F(PainterTest, ItemsOfTheSpaceViewAreTheSameOnTheScreenAndOnPaper) {
  View view{Camera{}, 800, 800};
  const Image<float> depth(800, 800, 1e9f);
  const SpaceProjection projection(view, Settings{}, 0.1);
  const PaintArea area{{0, 0}, {800, 800}};
  const auto shape_of = [](SpaceKind kind) {
    switch (group_of(kind)) {
    case SpaceGroup::lights:
      return SpaceShape::point;
    case SpaceGroup::nodes:
      return SpaceShape::box;
    case SpaceGroup::normals:
      return SpaceShape::arrow;
    default:
      break;
    }
    return kind == SpaceKind::hit_point ? SpaceShape::point
           : kind == SpaceKind::barycentric_area || kind == SpaceKind::pixel_cell ||
                   kind == SpaceKind::triangle_on_image || kind == SpaceKind::shadow_volume
               ? SpaceShape::area
               : SpaceShape::outline;
  };
  SpaceLook look;
  look.groups.fill(true);
  for (int i = 0; i <= static_cast<int>(SpaceKind::shadow_map); ++i)
    for (const bool bright : {false, true}) {
      const auto kind = static_cast<SpaceKind>(i);
      SpaceModel model;
      model.items.push_back({kind, shape_of(kind), {{-1, -1, 6}, {1, 0.5, 8}, {0.2, 1, 7}}, 4});
      look.highlighted = bright ? 4 : -1;
      const Both drawn = both([&](Painter& painter) { draw_space(painter, area, model, projection, depth, look); });
      EXPECT_FALSE(drawn.paper.colours.empty()) << i;
      expect_same(drawn, soft_edge + sharp_tip, "kind " + std::to_string(i));
    }
}

TEST_F(PainterTest, ItemsOfTheMicroscopeAreTheSameOnTheScreenAndOnPaper) {
  const PaintArea area{{100, 100}, {700, 700}};
  for (int i = 0; i <= static_cast<int>(MicroKind::place); ++i)
    for (const bool on_dark : {false, true}) {
      MicroDrawing drawing;
      drawing.backdrop = Image<Rgb8>(2, 2);
      drawing.items.push_back({.kind = static_cast<MicroKind>(i),
                               .shape = MicroShape::outline,
                               .points = {{0.2, 0.3}, {0.7, 0.6}, {0.3, 0.9}},
                               .label = "12",
                               .on_dark = on_dark});
      const auto draw = [&](Painter& painter) { draw_micro(painter, drawing, area); };
      expect_same(both(draw, &drawing.backdrop), soft_edge + sharp_tip, "kind " + std::to_string(i));
    }
}

}  // namespace
}  // namespace painter_test
