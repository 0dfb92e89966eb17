// The textbook listings and how they are shown with the values of a pixel.
#include <gtest/gtest.h>

#include <cmath>

#include "frame/display_frame.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"
#include "support/trials.h"
#include "textbook/book_math.h"
#include "textbook/listing_events.h"
#include "textbook/listing_view.h"

namespace ps::listing_test {
namespace {

Settings textbook(const Scene& scene) {
  Settings settings = settings_for(scene, Renderer::textbook);
  return settings;
}

constexpr const char* overlap = "chapters/cgfs_01_pixels_and_colours/overlap.scene";
constexpr const char* yard = "chapters/cgfs_15_shadows_in_the_rasterizer/yard.scene";

ListingTrace trace(const Scene& scene, const Settings& settings, Vec2i pixel) {
  return trace_listing(scene, {scene.camera, scene.canvas_width, scene.canvas_height}, settings, pixel);
}

const ListingRow& row_with(const std::vector<ListingRow>& rows, const std::string& text) {
  for (const ListingRow& row : rows)
    if (row.text.find(text) != std::string::npos) return row;
  ADD_FAILURE() << "no line has " << text;
  return rows.front();
}

std::string value_of(const ListingRow& row, const std::string& name) {
  for (const ListingValue& value : row.values)
    if (value.name == name) return value.value;
  return "nothing";
}

TEST(Listing, EachChapterSuitsItsScene) {
  const std::pair<const char*, const char*> suited[] = {{"cgfs/spheres", "cgfs_02_basic_ray_tracing"},
                                                        {"cgfs/lights", "cgfs_03_light"},
                                                        {"cgfs/shadows", "cgfs_04_shadows_and_reflections"},
                                                        {"cgfs/reflections", "cgfs_04_shadows_and_reflections"},
                                                        {"cgfs/lines", "cgfs_06_lines"},
                                                        {"cgfs/triangles", "cgfs_07_filled_triangles"},
                                                        {"cgfs/shaded-triangle", "cgfs_08_shaded_triangles"},
                                                        {"cgfs/wireframe", "cgfs_10_scenes"},
                                                        {"cgfs/cubes", "cgfs_12_hidden_surfaces"},
                                                        {"cgfs/shading", "cgfs_13_shading"},
                                                        {"cgfs/crates", "cgfs_14_textures"},
                                                        {yard, "cgfs_15_shadows_in_the_rasterizer"}};
  for (const auto& [name, folder] : suited) {
    const Scene scene = load_scene(name);
    EXPECT_EQ(listing_of(textbook(scene), scene_traits(scene)).folder, folder) << name;
  }
}

/// The colour at a place is the base colour times h, by the weights of the place in the triangle: to one level, since
/// the routine rounds the ends of a row to whole pixels.
TEST(Listing, ShadedTriangleInterpolatesTheIntensities) {
  const Scene scene = load_scene("cgfs/shaded-triangle");
  const Frame frame = render(scene, {scene.camera, 600, 600}, textbook(scene));
  const Vec2d a{-200, -250}, b{200, 50}, c{20, 250};
  const auto area = [](const Vec2d& p, const Vec2d& q, const Vec2d& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  int inside = 0;
  for (int y = -250; y <= 250; y += 7)
    for (int x = -200; x <= 200; x += 7) {
      const Vec2d p(x, y);
      const double wa = area(b, c, p) / area(a, b, c), wb = area(c, a, p) / area(a, b, c), wc = 1 - wa - wb;
      if (wa < 0.02 || wb < 0.02 || wc < 0.02) continue;
      ++inside;
      const Vec3d colour = frame.colour_double.at(300 + x, 299 - y);
      EXPECT_NEAR(colour.y, 0.3 * wa + 0.1 * wb + 1.0 * wc, 1.0 / 255) << x << "," << y;
      EXPECT_EQ(colour.x, 0);
    }
  EXPECT_GT(inside, 1000);
}

/// The routine of chapter 7 shows neither intensities nor gradients, and this is said.
TEST(Listing, SaysThatIntensitiesAreLeftOut) {
  const auto left_out_by = [](const char* listing, const Scene& scene) {
    Settings settings = textbook(scene);
    parse_assignment(listing, settings);
    std::string all;
    for (const LeftOut& one : left_out(scene_traits(scene), settings)) all += brief_text(one.brief) + ";";
    return all;
  };
  const Scene shaded = load_scene("cgfs/shaded-triangle");
  EXPECT_NE(left_out_by("listing=cgfs-07-filled-triangles", shaded).find("intensities"), std::string::npos);
  EXPECT_EQ(left_out_by("listing=cgfs-08-shaded-triangles", shaded), "");
  const Scene colours = load_scene("chapters/cgfs_08_shaded_triangles/colours.scene");
  EXPECT_NE(left_out_by("listing=cgfs-08-shaded-triangles", colours).find("gradients"), std::string::npos);
  EXPECT_EQ(left_out_by("listing=cgfs-07-filled-triangles", load_scene("cgfs/triangles")), "");
}

TEST(Listing, TextLeavesTheWatchesOut) {
  const ListingText text =
      parse_listing("#include <x>\nnamespace ps {\nnamespace {\n\nint f() {\n  int a = 1;\n"
                    "  PS_WATCH(\"a\",\n           a);\n  return a;\n}\n\n}  // namespace\nint g();\n");
  ASSERT_EQ(text.lines.size(), 4u);
  EXPECT_EQ(text.lines[0].text, "int f() {");
  EXPECT_EQ(text.lines[0].number, 5);
  EXPECT_EQ(text.shown_at.at(7), 1);  // the watch belongs to "int a = 1;"
  EXPECT_EQ(text.shown_at.at(8), 1);
  EXPECT_EQ(text.lines[2].number, 9);
  EXPECT_EQ(text.shown_at.at(13), -1);
}

/// Every listing shows some code, and every value that it has for its scene's start pixel stands beside a line of it.
TEST(Listing, EveryValueHasALine) {
  for (const char* name :
       {"cgfs/spheres", "cgfs/lights", "cgfs/reflections", "cgfs/lines", "cgfs/triangles", "cgfs/shaded-triangle",
        "cgfs/wireframe", "cgfs/cubes", "cgfs/shading", "cgfs/crates", yard}) {
    const Scene scene = load_scene(name);
    const ListingTrace traced = trace(scene, textbook(scene), scene.start_pixel);
    const ListingText text = load_listing_text(traced.listing);
    EXPECT_GT(text.lines.size(), 15u) << name;
    EXPECT_GT(traced.watches.size(), 3u) << name;
    EXPECT_EQ(traced.dropped, 0u) << name;
    for (const Watch& watch : traced.watches) EXPECT_GE(text.shown_at.at(static_cast<std::size_t>(watch.line)), 0);
    for (const ListingLine& line : text.lines) EXPECT_EQ(line.text.find("PS_"), std::string::npos) << line.text;
    std::size_t shown = 0;
    for (const ListingRow& row : ListingView(traced, text).rows()) shown += row.values.size();
    EXPECT_GE(shown, 3u) << name;
  }
}

/// The values are those of the picture: a traced pixel is the one that `render` stores, for every pixel tried.
TEST(Listing, TraceGivesTheColourOfThePicture) {
  for (const char* name : {"cgfs/reflections", "cgfs/lines", "cgfs/triangles", "cgfs/shaded-triangle", "cgfs/mixing",
                           "cgfs/wireframe", "cgfs/crates", yard}) {
    const Scene scene = load_scene(name);
    const Settings settings = textbook(scene);
    const View view{scene.camera, 120, 100};
    const Frame frame = render(scene, view, settings);
    for (int y = 3; y < 100; y += 16)
      for (int x = 1; x < 120; x += 13 * static_cast<int>(test::list_step)) {
        const PixelStory story = inspect(scene, view, settings, {x, y});
        EXPECT_EQ(story.linear, frame.colour_double.at(x, y)) << name << " " << x << "," << y;
        EXPECT_FALSE(story.verdict.empty());
      }
  }
}

/// Triangles far from the pixel leave nothing in a trace: with and without them it is the same.
TEST(Listing, TraceNeedsOnlyWhatIsNearThePixel) {
  const Progress progress;
  for (const char* name : {"cgfs/wireframe", "cgfs/cubes", "cgfs/shading", "cgfs/crates", "lab/tea-party",
                           "lab/depth-complexity", "lab/flattened", "models/dice", "lab/hierarchy"}) {
    const Scene scene = load_scene(name);
    // Of tea-party's 54,240 triangles each trace lists all: too much for a sanitizer.
    if (test::trial_divisor > 1 && scene.geometry->objects.size() > 100) continue;
    const View view{scene.camera, 150, 100};
    std::size_t seen = 0, listed = 0;
    for (const NamedListing& listing : listings()) {
      if (listing.listing->order != ListingOrder::object_by_object || listed++ % test::list_step != 0) continue;
      Settings settings = textbook(scene);
      settings.listing = static_cast<int>(&listing - listings().data()) + 1;
      settings.shadow_map_size = 32;  // each trace draws it anew
      const int step = scene.geometry->objects.size() > 100 ? 45 : 17;
      for (int y = 1; y < 100; y += step)
        for (int x = 2; x < 150; x += step + 6) {
          const auto all = trace_listing(scene, view, settings, {x, y}, &progress, TracedTriangles::all);
          const auto near = trace_listing(scene, view, settings, {x, y}, &progress, TracedTriangles::near_pixel);
          ASSERT_EQ(near.watches, all.watches) << name << " " << listing.folder << " " << x << "," << y;
          ASSERT_EQ(near.instances, all.instances) << name << " " << listing.folder << " " << x << "," << y;
          EXPECT_EQ(near.linear, all.linear);
          EXPECT_EQ(near.dropped, all.dropped);
          seen += all.instances.size();
        }
    }
    EXPECT_GT(seen, 20u) << name;
  }
}

/// The colour that the last surface, mirror, fragment or line of a story says the pixel has.
Vec3d last_colour(const PixelStory& story) {
  Vec3d colour(NAN);
  for (const Event& event : story.events) {
    if (const auto* miss = std::get_if<MissEvent>(&event.data)) colour = miss->background;
    if (const auto* shade = std::get_if<ShadeEvent>(&event.data)) colour = shade->local;
    if (const auto* mirror = std::get_if<ReflectionEvent>(&event.data)) colour = mirror->result;
    if (const auto* write = std::get_if<WriteEvent>(&event.data)) colour = write->after;
    if (const auto* line = std::get_if<LineEvent>(&event.data)) colour = line->colour;
  }
  return colour;
}

/// A listing's steps, as the events of the renderers, come to the colour that it put into the canvas.
TEST(Listing, EventsEndInItsColour) {
  constexpr int columns = test::trial_divisor > 1 ? 14 : 7;  // from one pixel to the next
  for (const char* name :
       {"cgfs/spheres", "cgfs/lights", "cgfs/shadows", "cgfs/reflections", "cgfs/lines", "cgfs/triangles",
        "cgfs/mixing", "cgfs/wireframe", "cgfs/cubes", "cgfs/shading", "cgfs/crates", yard}) {
    const Scene scene = load_scene(name);
    const Settings settings = textbook(scene);
    const View view{scene.camera, 120, 100};
    int compared = 0;
    for (int y = 2; y < 100; y += 17)
      for (int x = 4; x < 120; x += columns) {
        const PixelStory story = inspect(scene, view, settings, {x, y});
        if (story.events.size() < 2) continue;  // nothing reached the pixel
        ++compared;
        EXPECT_LT(length(last_colour(story) - story.linear), 1e-9) << name << " " << x << "," << y;
        for (std::size_t i = 0; i < story.events.size(); ++i) EXPECT_LT(story.events[i].parent, static_cast<int>(i));
      }
    EXPECT_GT(compared, 0) << name;
  }
}

/// Two lights on a wall (CGFS ch. 1 and 7): where both shine there is twice the light, in the listing as in the kernel
/// that knows nothing of it.
TEST(Listing, LightAddsUp) {
  const Scene scene = load_scene("chapters/cgfs_07_filled_triangles/lamps.scene");
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  Settings settings = settings_for(scene);
  settings.sample_position = SamplePosition::corner;
  settings.fill_rule = FillRule::inclusive;
  const Image<Rgb8> drawn = display_frame(render(scene, view, settings), settings);
  settings.renderer = Renderer::textbook;
  const Image<Rgb8> listed = display_frame(render(scene, view, settings), settings);
  EXPECT_EQ(listed.at(20, 19), (Rgb8{240, 180, 80}));  // on the seam
  EXPECT_EQ(listed.at(24, 19), (Rgb8{120, 90, 40}));
  int different = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) different += listed.at(x, y) == drawn.at(x, y) ? 0 : 1;
  EXPECT_EQ(different, 0);
  settings.renderer = Renderer::rasterizer;
  const PixelStory story = inspect(scene, view, settings, {20, 19});
  EXPECT_NE(story.verdict.find("its colour is added to 1 earlier colour"), std::string::npos) << story.verdict;
}

/// The same numbers as the ray tracer's own story, which knows nothing of listings.
TEST(Listing, EventsAreThoseOfTheRayTracer) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = settings_for(scene);
  settings.precision = Precision::float64;
  settings.sample_position = SamplePosition::corner;
  settings.self_hit = SelfHit::epsilon;
  settings.sphere_test = SphereTest::quadratic;
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  for (const Vec2i pixel : {Vec2i{300, 420}, Vec2i{180, 330}, Vec2i{430, 320}, Vec2i{300, 550}}) {
    settings.renderer = Renderer::ray_tracer;
    const PixelStory traced = inspect(scene, view, settings, pixel);
    settings.renderer = Renderer::textbook;
    const PixelStory listed = inspect(scene, view, settings, pixel);
    const auto hits_traced = events_of<HitEvent>(traced.events), hits_listed = events_of<HitEvent>(listed.events);
    const auto lights_traced = events_of<LightEvent>(traced.events),
               lights_listed = events_of<LightEvent>(listed.events);
    ASSERT_FALSE(hits_traced.empty() || lights_traced.empty());
    ASSERT_EQ(hits_listed.size(), hits_traced.size());
    ASSERT_EQ(lights_listed.size(), lights_traced.size());
    for (std::size_t i = 0; i < hits_traced.size(); ++i) {
      EXPECT_EQ(hits_listed[i]->id, hits_traced[i]->id);
      EXPECT_NEAR(hits_listed[i]->t, hits_traced[i]->t, 1e-9);
      EXPECT_LT(length(hits_listed[i]->shading_normal - hits_traced[i]->shading_normal), 1e-9);
    }
    for (std::size_t i = 0; i < lights_traced.size(); ++i) {
      EXPECT_NEAR(lights_listed[i]->diffuse, lights_traced[i]->diffuse, 1e-9);
      EXPECT_NEAR(lights_listed[i]->specular, lights_traced[i]->specular, 1e-9);
      EXPECT_EQ(lights_listed[i]->blocker.has_value(), lights_traced[i]->blocker.has_value());
      EXPECT_EQ(lights_listed[i]->below_horizon, lights_traced[i]->below_horizon);
    }
  }
}

/// A discriminant worked out by hand: cgfs/spheres through the middle of the canvas, D = (0, 0, 1) from the origin;
/// for the red sphere (0, -1, 3) with r = 1: a = 1, b = -6, c = 9, so 36 - 36 = 0 and t = 3.
// A listing says itself what it does; the name of its folder means nothing.
TEST(Listing, SettingsComeFromTheListing) {
  Listing listing;
  listing.order = ListingOrder::object_by_object;
  listing.draws = {.models = true, .light = true};
  listing.as_settings = [](Settings& settings) { settings.draw = Draw::points; };
  const NamedListing named{"a_folder_without_number", "a-folder-without-number", &listing};
  Settings chosen;
  chosen.reflection_depth = 5;
  chosen.specular = false;
  Settings as = settings_as_listed(named, Scene{}, chosen);
  EXPECT_EQ(as.renderer, Renderer::rasterizer);
  EXPECT_TRUE(as.lighting);
  EXPECT_FALSE(as.textures);
  EXPECT_EQ(as.shadows, Shadows::none);
  EXPECT_EQ(as.draw, Draw::points);
  EXPECT_EQ(as.precision, Precision::float64);
  EXPECT_EQ(as.reflection_depth, 5) << "triangles reflect nothing anyway";
  EXPECT_FALSE(as.specular) << "what the listing may read stays as it is";
  listing.order = ListingOrder::pixel_by_pixel;
  listing.as_settings = nullptr;
  listing.draws = {.spheres = true, .shadows = true};
  as = settings_as_listed(named, Scene{}, chosen);
  EXPECT_EQ(as.renderer, Renderer::ray_tracer);
  EXPECT_FALSE(as.lighting);
  EXPECT_EQ(as.shadows, Shadows::traced);
  EXPECT_EQ(as.reflection_depth, 0);
  EXPECT_EQ(as.draw, Draw::filled);
}

/// These share no code with the renderer whose picture they give, to the last pixel: other tests of triangles, other
/// trees, other edge functions. Each option takes its routine another way.
TEST(Listing, PictureIsThatOfTheRenderer) {
  struct Case {
    const char *listing, *scene;
    std::vector<const char*> set;
  };
  const Case cases[] = {{"cgpp-15-6-exact-edges", "chapters/cgpp_15_6_exact_edges/fan.scene", {}},
                        {"cgpp-15-6-exact-edges", "chapters/cgpp_15_6_exact_edges/fan.scene", {"fill-rule=inclusive"}},
                        {"cgpp-15-6-exact-edges", "cgfs/mixing", {"subpixel-bits=2"}},
                        {"lab-cornell", "lab/polygon-rows", {}},
                        {"cgpp-15-4-measured-light", "cgpp/ground", {"shadow-epsilon=0.001"}},
                        {"cgpp-15-4-measured-light", "cgpp/triangle", {}},
                        {"oct-dont-test-everything", "cgfs/cubes", {"octree-leaf=2", "octree-depth=6"}},
                        {"oct-dont-test-everything", "lab/hierarchy", {"octree-depth=3"}},
                        {"cgfs-01-pixels-and-colours", overlap, {}},
                        {"cgfs-01-pixels-and-colours", overlap, {"exposure=1.7"}},
                        {"cgfs-01-pixels-and-colours", overlap, {"exposure=0.3", "gamma=1"}},
                        {"cgfs-01-pixels-and-colours", "cgfs/mixing", {"gamma=1.8"}},
                        {"cgfs-05-camera", "cgfs/spheres", {}},
                        {"cgfs-05-camera", "chapters/cgfs_05_camera/turned.scene", {}},
                        {"cgfs-05-solids", "cgfs/cubes", {}},
                        {"cgfs-05-solids", "lab/hierarchy", {}},
                        {"cgfs-09-perspective", "chapters/cgfs_09_perspective/cube.scene", {}},
                        {"cgpp-15-6-which-pixels", "cgfs/cubes", {"coverage=ray-test"}},
                        {"cgpp-15-6-which-pixels", "cgfs/cubes", {"coverage=bounding-box"}},
                        {"cgpp-15-6-which-pixels", "cgfs/cubes", {"coverage=barycentric"}},
                        {"cgpp-15-6-which-pixels", "cgpp/triangle", {"coverage=barycentric"}},
                        {"cgfs-11-clipping", "cgfs/behind", {}},
                        {"cgfs-11-clipping", "cgfs/behind", {"near=6", "backface-culling=off"}},
                        {"cgfs-11-clipping", "chapters/cgfs_11_clipping/one.scene", {}},
                        {"cgfs-11-clipping", "chapters/cgfs_11_clipping/two.scene", {}},
                        {"cgfs-15-shadows-in-the-rasterizer", yard, {}},
                        {"cgfs-15-shadows-in-the-rasterizer", yard, {"shadow-map-size=64", "specular=off"}},
                        {"cgfs-15-shadows-in-the-rasterizer", yard, {"shadow-bias=0.4", "shadow-slope-bias=0"}},
                        {"cgfs-15-shadows-in-the-rasterizer", yard, {"shadow-slope-bias=0.2"}}};
  for (const Case& each : cases) {
    const Scene scene = load_scene(each.scene);
    Settings settings = textbook(scene);
    parse_assignment(std::string("listing=") + each.listing, settings);
    for (const char* change : each.set) parse_assignment(change, settings);
    const SceneTraits traits = scene_traits(scene);
    const NamedListing& listing = listing_of(settings, traits);
    ASSERT_EQ(listing.key, each.listing);
    const int width = std::min(scene.canvas_width, 200);
    const int height = width * scene.canvas_height / scene.canvas_width / 2 * 2;  // even: the book has no middle pixel
    const View view{scene.camera, width, height};
    const Settings as = settings_as_listed(listing, scene, settings);
    const Image<Rgb8> listed = display_frame(render(scene, view, settings), settings);
    const Image<Rgb8> drawn = display_frame(render(scene, view, as), as);
    int different = 0, empty = 0;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        different += listed.at(x, y) == drawn.at(x, y) ? 0 : 1;
        empty += listed.at(x, y) == listed.at(0, 0) ? 1 : 0;
      }
    EXPECT_EQ(different, 0) << each.listing << " " << each.scene;
    EXPECT_LT(empty, view.width * view.height) << each.listing << " " << each.scene;
  }
}

// CGFS ch. 10 draws edges; ch. 13 interpolates affinely; ch. 14 shades each pixel, with whatever interpolation is
// chosen.
TEST(Listing, ChaptersOfTheBookSetWhatTheyDo) {
  const auto as = [](std::string_view key, const Settings& chosen) {
    for (const NamedListing& listing : listings())
      if (listing.key == key) return settings_as_listed(listing, Scene{}, chosen);
    ADD_FAILURE() << "no listing " << key;
    return chosen;
  };
  Settings chosen;
  chosen.backface_culling = false;
  chosen.visibility = Visibility::painter;
  chosen.shading = Shading::flat;
  chosen.draw = Draw::points;
  EXPECT_EQ(as("cgfs-10-scenes", chosen).draw, Draw::wireframe);
  EXPECT_EQ(as("cgfs-12-hidden-surfaces", chosen).draw, Draw::filled);
  EXPECT_EQ(as("cgfs-12-hidden-surfaces", chosen).visibility, Visibility::painter);
  EXPECT_FALSE(as("cgfs-12-hidden-surfaces", chosen).lighting);
  const Settings shading = as("cgfs-13-shading", chosen), textures = as("cgfs-14-textures", chosen);
  EXPECT_TRUE(shading.lighting && textures.lighting && shading.backface_culling && textures.backface_culling);
  EXPECT_EQ(shading.visibility, Visibility::depth_buffer);
  EXPECT_EQ(shading.interpolation, Interpolation::affine);
  EXPECT_EQ(textures.interpolation, Interpolation::perspective);
  EXPECT_EQ(shading.shading, Shading::flat);
  EXPECT_EQ(textures.shading, Shading::phong);
  EXPECT_TRUE(textures.textures && !shading.textures);
  EXPECT_EQ(as("cgfs-04-shadows-and-reflections", chosen).shadows, Shadows::traced);
  EXPECT_EQ(as("cgfs-03-light", chosen).shadows, Shadows::none);
  EXPECT_FALSE(as("cgfs-02-basic-ray-tracing", chosen).lighting);
}

TEST(Listing, NumbersAreThoseOfTheBook) {
  const Scene scene = load_scene("cgfs/spheres");
  const ListingTrace traced = trace(scene, textbook(scene), {300, 299});
  const ListingText text = load_listing_text(traced.listing);
  const ListingView view(traced, text);
  const auto rows = view.rows();
  EXPECT_EQ(row_with(rows, "for (const BookSphere& sphere").instance, "sphere red");
  EXPECT_EQ(row_with(rows, "for (const BookSphere& sphere").count, 4);
  EXPECT_EQ(value_of(row_with(rows, "const double c = "), "a, b, c"), "(1, -6, 9)");
  EXPECT_EQ(value_of(row_with(rows, "const double discriminant ="), "discriminant"), "0");
  EXPECT_EQ(value_of(row_with(rows, "const double t2 = "), "t1, t2"), "(3, 3)");
}

TEST(Listing, LoopsAreSteppedThrough) {
  const Scene scene = load_scene("cgfs/reflections");
  const ListingTrace traced = trace(scene, textbook(scene), {300, 420});
  const ListingText text = load_listing_text(traced.listing);
  ListingView view(traced, text);
  auto rows = view.rows();
  const auto find = [&](const std::string& words) -> std::size_t {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].text.find(words) != std::string::npos) return i;
    ADD_FAILURE() << words;
    return 0;
  };
  const std::size_t light = find("for (const Light& light");
  EXPECT_EQ(rows[light].instance, "light ambient");
  view.step(light, 1);
  rows = view.rows();
  EXPECT_EQ(rows[light].instance, "light point");
  EXPECT_EQ(rows[light].place, 2);
  // The spheres that are shown are now those of this light's shadow ray, not those of the eye ray.
  const std::size_t sphere = find("for (const BookSphere& sphere");
  EXPECT_EQ(rows[sphere].count, 4);
  const WatchInstance& focus = traced.instances.at(static_cast<std::size_t>(view.focus()));
  EXPECT_EQ(watch_text(focus.value), "point");
  for (int i = 0; i < 100; ++i) view.step(light, 1);  // stops at the end
  rows = view.rows();
  EXPECT_EQ(rows[light].instance, "light directional");

  // Three bounces: four rays, one inside the other.
  ListingView again(traced, text);
  rows = again.rows();
  const std::size_t traced_ray = find("int recursion_depth) {");
  EXPECT_EQ(rows[traced_ray].instance, "remaining bounces 3");
  again.step(traced_ray, 1);
  EXPECT_EQ(again.rows()[traced_ray].instance, "remaining bounces 2");
}

TEST(Listing, OptionsThatItDoesNotReadAreGreyed) {
  const Scene scene = load_scene("cgfs/reflections");
  const Settings settings = textbook(scene);
  const SceneTraits traits = scene_traits(scene);
  EXPECT_FALSE(inactive_reason(*find_option("reflection-depth"), settings, traits));
  EXPECT_FALSE(inactive_reason(*find_option("listing"), settings, traits));
  EXPECT_TRUE(inactive_reason(*find_option("sphere-test"), settings, traits));
  EXPECT_TRUE(inactive_reason(*find_option("shading"), settings, traits));
}

/// Also one of the machine, as the limit of an octree's leaves is for the ray tracer.
TEST(Listing, EveryOptionThatItReadsActs) {
  const SceneTraits traits = scene_traits(load_scene("cgfs/cubes"));
  std::size_t read = 0;
  for (std::size_t i = 0; i < listings().size(); ++i) {
    Settings settings{.renderer = Renderer::textbook};
    settings.listing = static_cast<int>(i) + 1;
    for (const std::string_view key : listings()[i].listing->reads) {
      EXPECT_FALSE(inactive_reason(*find_option(key), settings, traits)) << listings()[i].folder << " " << key;
      ++read;
    }
    EXPECT_EQ(inactive_reason(*find_option("octree-leaf"), settings, traits).has_value(),
              !listing_reads(listings()[i], "octree-leaf"));
  }
  EXPECT_GT(read, 10u);
}

}  // namespace
}  // namespace ps::listing_test
