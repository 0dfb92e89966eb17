#include "engine/measured_pictures.h"

#include <gtest/gtest.h>

#include "engine/metric.h"
#include "options/option.h"
#include "scene/load.h"

namespace ps::measured_pictures_test {
namespace {

Document small_document() {
  Document document = open_document("cgfs/shadows", load_scene("cgfs/shadows"));
  document.view.width = document.view.height = 40;
  return document;
}

TEST(MeasuredPictures, RendersEqualPicturesOnce) {
  Progress progress;
  MeasuredPictures pictures;
  Document document = small_document();
  const Metric count = parse_metric("differing-pixels"), mean = parse_metric("mean-difference");
  EXPECT_EQ(measure(count, document, progress, &pictures), measure(count, document, progress));
  EXPECT_EQ(pictures.rendered(), 2);
  EXPECT_EQ(measure(mean, document, progress, &pictures), measure(mean, document, progress));
  EXPECT_EQ(pictures.rendered(), 2);
  parse_assignment("shadows=none", document.a.settings);
  EXPECT_EQ(measure(count, document, progress, &pictures), measure(count, document, progress));
  EXPECT_EQ(pictures.rendered(), 3);  // B is as before
}

// Each of these changes the picture, and none may be taken for another.
TEST(MeasuredPictures, AreNewWithEachChange) {
  Progress progress;
  MeasuredPictures pictures;
  const Metric red = parse_metric("red-a");
  const auto expect_new = [&](const Document& document, const std::string& what) {
    const int before = pictures.rendered();
    EXPECT_EQ(measure(red, document, progress, &pictures), measure(red, document, progress)) << what;
    EXPECT_EQ(pictures.rendered(), before + 1) << what;
  };
  Document document = small_document();
  document.pixel = {20, 20};
  expect_new(document, "the first");
  Document other = document;
  other.view.width = 50;
  expect_new(other, "size");
  other = document;
  other.view.camera = view_of(document).camera;
  other.view.camera->position.x += 1;
  expect_new(other, "camera");
  other = document;
  other.view.region = TileRect{10, 10, 30, 30};
  expect_new(other, "region");
  other = document;
  edit_scene(other, {"object.0.color", "(0, 0, 255)"});
  expect_new(other, "edit");
  other = document;
  parse_assignment("exposure=2", other.a.settings);
  expect_new(other, "option");
  other = open_document("cgfs/reflections", load_scene("cgfs/reflections"));
  other.view = document.view;
  other.pixel = document.pixel;
  expect_new(other, "scene");
}

}  // namespace
}  // namespace ps::measured_pictures_test
