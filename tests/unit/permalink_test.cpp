#include "document/permalink.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "base/resources.h"
#include "document/command_line.h"
#include "document/permalink_file.h"
#include "image/file.h"
#include "support/run_cli.h"
#include "support/stories.h"

namespace ps::permalink_test {
namespace {

TEST(Permalink, DefaultsLeaveNothing) { EXPECT_EQ(permalink(Document{}), ""); }

TEST(Permalink, HoldsOnlyDifferences) {
  Document document;
  document.scene_name = "cgfs/reflections";
  document.a.settings.reflection_depth = 1;
  document.b.settings.renderer = Renderer::rasterizer;
  document.pixel = {312, 204};
  document.edits = {{"light.2.position", "(1, 2, 3)"}};
  EXPECT_EQ(permalink(document), "scene=cgfs/reflections&pixel=312,204&edit.light.2.position=%281,%202,%203%29&"
                                 "a.reflection-depth=1&b.renderer=rasterizer");
}

// A handout is read on other machines than the one that wrote it.
TEST(Permalink, NamesFilesOfLessonsByTheirPlaceInTheProject) {
  Document document;
  document.scene_name = (chapter_dir() / "cgfs_09_perspective" / "square.scene").string();
  EXPECT_EQ(permalink(document), "scene=chapters/cgfs_09_perspective/square.scene");
  EXPECT_EQ(parse_permalink(permalink(document)).scene_name, document.scene_name);
  document.scene_name = "chapters/nothing/there.scene";  // a file of the user's in a folder of that name
  EXPECT_EQ(parse_permalink(permalink(document)).scene_name, document.scene_name);
}

TEST(Permalink, EscapesSurvive) {
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  EXPECT_EQ(percent_unescape(percent_escape(all)), all);
  EXPECT_EQ(percent_escape("a b&c=d%"), "a%20b%26c%3Dd%25");
  EXPECT_THROW(percent_unescape("%4"), InputError);
  EXPECT_THROW(percent_unescape("%zz"), InputError);
}

TEST(Permalink, BadTextIsAnInputError) {
  for (const char* bad : {"scene",
                          "colour=red",
                          "a.unknown=1",
                          "a.renderer=raytracer",
                          "size=0x0",
                          "size=100000x100000",
                          "pixel=x",
                          "region=1,2,3",
                          "region=1,2,3,4,5",
                          "region=1,2,0,4",
                          "region=-1,2,3,4",
                          "region=1,2,3,99999999999",
                          "zoom=-1",
                          "split=2",
                          "split=nan",
                          "range=depth",
                          "range=depth,1",
                          "range=depth,2,1",
                          "range=depth,0,nan",
                          "range=normal,0,1",
                          "compare=both",
                          "step=1.5",
                          "event=-1",
                          "event=2.5",
                          "picked=c",
                          "panels=1",
                          "show-a=nothing",
                          "slow-motion-a=triangles",
                          "camera=1,2",
                          "scene=%4",
                          "b.reflection-depth=65",
                          "look=below",
                          "orbit=0,0,0,1,1",
                          "orbit=0,0,0,1,1,0",
                          "until=end",
                          "instance=-1",
                          "sample=0.5",
                          "vertex=-1,2",
                          "vertex-order=turn-then-move",
                          "vertex-near=x",
                          "least=2",
                          "filled=top",
                          "pin=3",
                          "pin=-1,2",
                          "pin.a.reflection-depth=1",
                          "pin=1,2&pin.colour=red",
                          "pin=1,2&pin.a.unknown=1",
                          "pin=1,2&pin.size=0x4",
                          "=",
                          "&"})
    EXPECT_THROW(parse_permalink(bad), InputError) << bad;
}

TEST(Permalink, PinHoldsWhatThePixelWasInspectedWith) {
  Document document = open_document("spheres", test::book_spheres());
  document.pixel = {312, 204};
  document.a.settings = document.b.settings = Settings{};
  document.a.settings.reflection_depth = 1;
  edit_scene(document, {"light.2.direction", "(1, 2, 3)"});
  pin_pixel(document);
  document.a.settings.reflection_depth = 2;
  document.pixel = {1, 2};
  EXPECT_EQ(permalink(document), "scene=spheres&pixel=1,2&pin=312,204&pin.edit.light.2.direction=%281,%202,%203%29&"
                                 "pin.a.reflection-depth=1&edit.light.2.direction=%281,%202,%203%29&"
                                 "a.reflection-depth=2");
  EXPECT_EQ(parse_permalink(permalink(document)).pin, document.pin);
}

// A pin without a place in its scene is refused with the scene, not found out by whoever inspects it.
TEST(Permalink, PinMustFitTheScene) {
  for (const char* bad :
       {"pin=600,10", "pin=10,600", "pin=100,10&pin.size=100x100", "pin=1,1&pin.edit.light.9.position=1"}) {
    Document document = parse_permalink(bad);
    EXPECT_THROW(attach_scene(document, test::book_spheres()), InputError) << bad;
  }
  Document document = parse_permalink("pin=599,599&pin.size=600x600");
  EXPECT_NO_THROW(attach_scene(document, test::book_spheres()));
}

TEST(Permalink, HoldsTheRectangleAndThePictureInBsPlace) {
  Document document;
  document.view.region = TileRect{10, 20, 310, 220};
  document.picture_b = "my pictures/spheres.png";
  EXPECT_EQ(permalink(document), "region=10,20,300,200&picture-b=my%20pictures/spheres.png");
  EXPECT_EQ(parse_permalink(permalink(document)), document);
}

// A rectangle is no reason to refuse a scene that has become smaller.
TEST(Permalink, RectangleIsCutOffAtThePicturesEdges) {
  Document across = parse_permalink("region=500,590,200,20");
  attach_scene(across, test::book_spheres());
  EXPECT_EQ(across.view.region, (TileRect{500, 590, 600, 600}));
  Document outside = parse_permalink("region=600,0,10,10");
  attach_scene(outside, test::book_spheres());
  EXPECT_EQ(outside.view.region, std::nullopt);
}

TEST(Permalink, KeepsTheSelectedEventsOfBothStories) {
  Document document;
  document.events = {3, 7};
  document.picked = Side::b;
  const std::string link = permalink(document);
  EXPECT_NE(link.find("event=7"), std::string::npos) << link;
  EXPECT_EQ(parse_permalink(link).events, document.events);
  // In whichever order its parts come.
  EXPECT_EQ(parse_permalink("other-event=3&event=7&picked=b").events, document.events);
}

TEST(Permalink, OfALessonOpensItsModeUnlessItNamesAnother) {
  EXPECT_EQ(parse_permalink("scene=cgfs/crates").mode, ScreenMode::explore);
  Document document = parse_permalink("scene=cgfs/crates&lesson=cgfs_03_light&step=2");
  EXPECT_EQ(document.mode, ScreenMode::lesson);
  EXPECT_EQ(permalink(document), "scene=cgfs/crates&lesson=cgfs_03_light&step=2");
  for (const ScreenMode mode : {ScreenMode::explore, ScreenMode::study, ScreenMode::presenter}) {
    document.mode = mode;
    EXPECT_EQ(parse_permalink(permalink(document)).mode, mode) << permalink(document);
  }
  EXPECT_THROW(parse_permalink("mode=theatre"), InputError);
}

TEST(PermalinkFile, KeepsTheLineAndTheTextOfPictures) {
  const test::ScratchFolder folder;
  Document document;
  document.scene_name = "cgfs/crates";
  document.events = {7, -1};
  document.pixel = {340, 130};
  save_permalink(folder.file("screen.permalink"), document);
  EXPECT_EQ(permalink_in_file(folder.file("screen.permalink")), permalink(document));
  SaveOptions with_text;
  with_text.texts = {{"permalink", permalink(document)}};
  save_image(folder.file("with.png"), Image<Rgb8>(2, 2), with_text);
  save_image(folder.file("without.png"), Image<Rgb8>(2, 2));
  EXPECT_EQ(permalink_in_file(folder.file("with.png")), permalink(document));
  EXPECT_EQ(permalink_in_file(folder.file("without.png")), std::nullopt);
  EXPECT_EQ(permalink_in_file("cgfs/crates"), std::nullopt);
  EXPECT_EQ(permalink_in_file(folder.file("some.scene")), std::nullopt);
  EXPECT_THROW(permalink_in_file(folder.file("missing.permalink")), InputError);
  EXPECT_THROW(permalink_in_file(folder.write("empty.permalink", "\n")), InputError);
}

TEST(CommandLine, QuotesForTheShell) {
  EXPECT_EQ(shell_quote("cgfs/shadows"), "cgfs/shadows");
  EXPECT_EQ(shell_quote("my scene.obj"), "'my scene.obj'");
  EXPECT_EQ(shell_quote("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_quote(""), "''");
}

// Options that the scene's file sets need no flag; one that was set back to its default does.
TEST(CommandLine, CountsFromTheScenesOwnSettings) {
  Scene scene = test::book_spheres();
  scene.settings = {{"reflection-depth", "1"}, {"self-hit", "epsilon"}};
  Document document = open_document("my spheres.scene", scene);
  document.a.settings.self_hit = SelfHit::offset;
  document.a.show = ShownChannel::depth;
  document.view.region = TileRect{10, 20, 40, 60};
  document.pixel = {3, 4};
  document.edits = {{"light.2.position", "(1, 2, 3)"}};
  EXPECT_EQ(render_command(document, Side::a),
            "pixelscope-cli render 'my spheres.scene' --size 600x600 --edit 'light.2.position=(1, 2, 3)' "
            "--set self-hit=offset --region 10,20,30,40 --show depth --out picture.png");
  EXPECT_EQ(inspect_command(document, Side::b),
            "pixelscope-cli inspect 'my spheres.scene' --size 600x600 --edit 'light.2.position=(1, 2, 3)' "
            "--set renderer=rasterizer --pixel 3,4");
  EXPECT_EQ(window_command(document), "pixelscope --permalink '" + permalink(document) + "'");
}

}  // namespace
}  // namespace ps::permalink_test
