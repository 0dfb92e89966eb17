// The background renderer without a window: which render runs, what is shown, and that bits do not change on the way.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <new>
#include <thread>

#include "frame/display_frame.h"
#include "gui/work/background_study.h"
#include "gui/work/inspect_worker.h"
#include "gui/work/render_worker.h"
#include "options/option.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::gui::render_worker_test {
namespace {

using namespace std::chrono_literals;

constexpr int size = 32;

PictureRequest request_with(double near) {
  PictureRequest request;
  request.view.width = size;
  request.view.height = size;
  request.settings.near = near;
  return request;
}

/// Waits for something that another thread brings about. Far longer than it can take, so that only a hang fails.
template <class Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 20000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(1ms);
  }
  return false;
}

/// A renderer whose pixels all have the red `near` / 255, and which stops before its last tile while the gate is
/// closed.
class GatedRenderer {
 public:
  explicit GatedRenderer(bool open) : open_(open) {}

  Frame operator()(const View& view, const Settings& settings, const RenderRequest& request, Progress& progress) {
    ++calls;
    Frame frame;
    frame.colour = Image<Vec3f>(view.width, view.height, Vec3f(static_cast<float>(settings.near / 255), 0, 0));
    frame.ids = Image<PixelId>(view.width, view.height);
    finish_tile(request, settings, frame, {0, 0, view.width, view.height / 2});
    ++waiting;
    while (!open_) {
      progress.check();
      std::this_thread::sleep_for(100us);
    }
    finish_tile(request, settings, frame, {0, view.height / 2, view.width, view.height});
    return frame;
  }
  RenderWorker::RenderCall call() {
    return [this](const Scene&, const View& view, const Settings& settings, const RenderRequest& request, Prepared&,
                  Progress& progress) { return (*this)(view, settings, request, progress); };
  }
  void open() { open_ = true; }

  std::atomic<int> calls{0}, waiting{0};

 private:
  std::atomic<bool> open_;
};

TEST(RenderWorker, ShowsTheWholePictureInTheEnd) {
  GatedRenderer renderer(true);
  std::atomic<int> wakes{0};
  RenderWorker worker(
      std::make_shared<Prepared>(), [&] { ++wakes; }, renderer.call());
  worker.request(request_with(200));
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
  Image<Rgb8> picture;
  worker.collect(picture);
  EXPECT_EQ(picture, Image<Rgb8>(size, size, Rgb8{200, 0, 0}));
  EXPECT_GT(wakes, 0);
  EXPECT_TRUE(worker.collect(picture).empty()) << "nothing changed since";
  EXPECT_EQ(worker.result()->frame.width(), size);
}

TEST(RenderWorker, NewestRequestWins) {
  GatedRenderer renderer(false);
  RenderWorker worker(
      std::make_shared<Prepared>(), [] {}, renderer.call());
  for (int near = 1; near <= 50; ++near) worker.request(request_with(near));
  ASSERT_TRUE(comes_true([&] { return renderer.waiting > 0; }));
  worker.request(request_with(77));
  renderer.open();
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
  EXPECT_EQ(worker.result()->request.settings.near, 77);
  EXPECT_EQ(worker.status().renders_done, 1u) << "no earlier request came to its end";
  Image<Rgb8> picture;
  worker.collect(picture);
  EXPECT_EQ(picture, Image<Rgb8>(size, size, Rgb8{77, 0, 0}));
}

TEST(RenderWorker, CancellingKeepsWhatHasArrived) {
  GatedRenderer renderer(false);
  RenderWorker worker(
      std::make_shared<Prepared>(), [] {}, renderer.call());
  worker.request(request_with(50));
  ASSERT_TRUE(comes_true([&] { return renderer.waiting > 0; }));
  worker.cancel();
  EXPECT_EQ(worker.status().state, RenderState::cancelled);
  EXPECT_EQ(worker.result(), nullptr);
  Image<Rgb8> picture;
  worker.collect(picture);
  ASSERT_EQ(picture.width(), size);
  EXPECT_EQ(picture.at(0, 0), (Rgb8{50, 0, 0}));
  EXPECT_NE(picture.at(0, size - 1), (Rgb8{50, 0, 0}));

  renderer.open();
  worker.request(request_with(50));
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; })) << "the same can be asked again";
}

TEST(RenderWorker, ARegionIsPassedOnAndRendersAnew) {
  std::mutex mutex;
  std::vector<std::pair<int, std::optional<TileRect>>> asked;  // width of the picture, and what is wanted of it
  RenderWorker worker(
      std::make_shared<Prepared>(), [] {},
      [&](const Scene&, const View& view, const Settings&, const RenderRequest& request, Prepared&, Progress&) {
        const std::lock_guard lock(mutex);
        asked.emplace_back(view.width, request.region);
        Frame frame;
        frame.colour = Image<Vec3f>(view.width, view.height);
        frame.ids = Image<PixelId>(view.width, view.height);
        return frame;
      });
  auto request = request_with(64);
  request.region = TileRect{3, 5, 20, 9};
  worker.request(request);
  ASSERT_TRUE(comes_true([&] { return worker.status().renders_done == 1; }));
  request.region.reset();
  worker.request(request);
  ASSERT_TRUE(comes_true([&] { return worker.status().renders_done == 2; }));
  const std::lock_guard lock(mutex);
  int whole = 0, part = 0;
  for (const auto& [width, region] : asked) {
    if (!region) ++whole;
    if (region && width == size) {
      EXPECT_EQ(*region, (TileRect{3, 5, 20, 9}));
      ++part;
    }
    if (region && width == size / 2) {
      EXPECT_EQ(*region, (TileRect{1, 2, 10, 5})) << "the coarse picture's pixels that hold it";
    }
  }
  EXPECT_EQ(part, 1);
  EXPECT_GE(whole, 1);
}

TEST(RenderWorker, DisplayOptionsDoNotRenderAgain) {
  GatedRenderer renderer(true);
  RenderWorker worker(
      std::make_shared<Prepared>(), [] {}, renderer.call());
  auto request = request_with(64);
  worker.request(request);
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
  const int calls = renderer.calls;
  const auto result = worker.result();

  request.settings.exposure = 2;
  worker.request(request);
  Image<Rgb8> picture;
  ASSERT_TRUE(comes_true([&] {
    worker.collect(picture);
    return picture.at(size / 2, size / 2) == Rgb8{128, 0, 0};
  }));
  EXPECT_EQ(renderer.calls, calls);
  EXPECT_EQ(worker.result(), result) << "the frame is still the same one";
  EXPECT_EQ(worker.status().renders_begun, 1u);

  request.settings.shading = Shading::flat;
  worker.request(request);
  ASSERT_TRUE(comes_true([&] { return worker.status().renders_done == 2; })) << "anything else does render";
  EXPECT_GT(renderer.calls, calls);
}

TEST(RenderWorker, TakesUpAChangeOfDisplayDuringARender) {
  GatedRenderer renderer(false);
  RenderWorker worker(
      std::make_shared<Prepared>(), [] {}, renderer.call());
  auto request = request_with(64);
  worker.request(request);
  ASSERT_TRUE(comes_true([&] { return renderer.waiting > 0; }));
  request.settings.exposure = 2;
  worker.request(request);
  renderer.open();
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
  Image<Rgb8> picture;
  worker.collect(picture);
  EXPECT_EQ(picture, Image<Rgb8>(size, size, Rgb8{128, 0, 0}));
  EXPECT_EQ(worker.status().renders_begun, 1u);
}

TEST(RenderWorker, ReportsAnErrorAndGoesOn) {
  GatedRenderer renderer(true);
  RenderWorker worker(
      std::make_shared<Prepared>(), [] {},
      [&](const Scene&, const View& view, const Settings& settings, const RenderRequest& request, Prepared&,
          Progress& progress) -> Frame {
        if (settings.near == 13) throw InputError("no such thing");
        return renderer(view, settings, request, progress);
      });
  worker.request(request_with(13));
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::failed; }));
  EXPECT_EQ(worker.status().message, "no such thing");
  worker.request(request_with(14));
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
  EXPECT_TRUE(worker.status().message.empty());
}

TEST(RenderWorker, BitsAreThoseOfADirectRender) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    PictureRequest request;
    request.scene = load_scene("cgfs/reflections");
    request.view = {request.scene.camera, 90, 70};
    request.settings.renderer = renderer;
    RenderWorker worker(std::make_shared<Prepared>(), [] {});
    worker.request(request);
    ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
    const Frame direct = render(request.scene, request.view, request.settings);
    EXPECT_EQ(worker.result()->frame.colour, direct.colour);
    EXPECT_EQ(worker.result()->frame.counters, direct.counters);
    Image<Rgb8> picture;
    worker.collect(picture);
    EXPECT_EQ(picture, display_frame(direct, request.settings));
  }
}

// A finished render that is to be displayed anew is work, although its state is done: who waits for the worker to have
// nothing to do sees the new display.
TEST(RenderWorker, IsBusyUntilANewDisplayIsThere) {
  PictureRequest request;
  request.scene = load_scene("cgfs/reflections");
  request.view = {request.scene.camera, 900, 700};
  RenderWorker worker(std::make_shared<Prepared>(), [] {});
  worker.request(request);
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  Image<Rgb8> levels;
  worker.collect(levels);
  for (const double exposure : {2.0, 0.5, 3.0}) {
    request.settings.exposure = exposure;
    worker.request(request);
    ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
    EXPECT_TRUE(worker.has_news());
    worker.collect(levels);
    EXPECT_EQ(levels, display_frame(worker.result()->frame, request.settings)) << exposure;
    EXPECT_EQ(worker.status().renders_done, 1U);
  }
}

// The levels come from the renderer, tile by tile: of small pictures and of those that are written past the cache, with
// any display, in float and double, whole and in part.
TEST(RenderWorker, LevelsAreThoseOfTheFinishedFrame) {
  const std::vector<std::vector<std::string>> all{{},
                                                  {"exposure=2", "gamma=2.2"},
                                                  {"colour-depth=16"},
                                                  {"precision=double"},
                                                  {"samples-per-pixel=4", "adaptive-sampling=on"},
                                                  {"simd=off", "exposure=0.5"}};
  for (const char* renderer : {"renderer=ray-tracer", "renderer=rasterizer", "renderer=textbook"})
    for (const std::vector<std::string>& assignments : all)
      for (const bool large : {false, true}) {
        if (large && assignments.size() > 0) continue;
        SCOPED_TRACE(renderer + std::string(assignments.empty() ? "" : ", " + assignments.front()));
        PictureRequest request;
        request.scene = load_scene("cgfs/reflections");
        request.view = {request.scene.camera, large ? 900 : 90, large ? 700 : 70};
        parse_assignment(renderer, request.settings);
        for (const std::string& assignment : assignments) parse_assignment(assignment, request.settings);
        RenderWorker worker(std::make_shared<Prepared>(), [] {});
        worker.request(request);
        ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
        Image<Rgb8> picture;
        worker.collect(picture);
        EXPECT_EQ(picture, display_frame(worker.result()->frame, request.settings));
        request.region = TileRect{10, 20, 60, 50};
        worker.request(request);
        ASSERT_TRUE(comes_true([&] { return worker.status().renders_done == 2; }));
        worker.collect(picture);
        EXPECT_EQ(picture, display_frame(worker.result()->frame, request.settings));
      }
}

TEST(InspectWorker, ReportsTheNewestPixelOnly) {
  std::atomic<bool> open{false};
  std::atomic<int> calls{0};
  InspectWorker worker(
      std::make_shared<Prepared>(), [] {},
      [&](const Scene&, const View&, const Settings&, Vec2i pixel, Prepared&, Progress&) {
        ++calls;
        while (!open) std::this_thread::sleep_for(100us);
        PixelStory story;
        story.pixel = pixel;
        return story;
      });
  for (int x = 0; x < 20; ++x) worker.request({request_with(1), {x, 3}});
  EXPECT_TRUE(worker.busy());
  EXPECT_EQ(worker.story(), nullptr);
  open = true;
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_EQ(worker.story()->pixel, Vec2i(19, 3));
  EXPECT_LE(calls, 2) << "the first story is under way while all others but the last are replaced";

  const int before = calls;
  worker.request({request_with(1), {19, 3}});
  EXPECT_FALSE(worker.busy()) << "the same pixel again is nothing new";
  EXPECT_EQ(calls, before);
}

// What runs out of memory says so, in words that name what to do, and not as the language names the exception. It ends
// neither the program nor the worker.
void expect_words_about_memory(const std::string& message) {
  EXPECT_NE(message.find("not enough memory"), std::string::npos) << message;
  EXPECT_NE(message.find("try"), std::string::npos) << message;
  EXPECT_EQ(message.find("bad_alloc"), std::string::npos) << message;
}

TEST(RenderWorker, WithoutMemoryItFailsInWords) {
  std::atomic<int> wakes{0};
  RenderWorker worker(
      std::make_shared<Prepared>(), [&] { ++wakes; },
      [](const Scene&, const View& view, const Settings& settings, const RenderRequest& request, Prepared&,
         Progress& progress) {
        if (settings.near > 1) throw std::bad_alloc();
        return GatedRenderer(true)(view, settings, request, progress);
      });
  worker.request(request_with(2));
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::failed && wakes > 0; }));
  expect_words_about_memory(worker.status().message);
  EXPECT_TRUE(worker.has_news());
  EXPECT_EQ(worker.result(), nullptr);
  worker.request(request_with(1));
  ASSERT_TRUE(comes_true([&] { return worker.status().state == RenderState::done; }));
  EXPECT_EQ(worker.status().message, "");
}

TEST(InspectWorker, WithoutMemoryItFailsInWords) {
  std::atomic<int> wakes{0};
  InspectWorker worker(
      std::make_shared<Prepared>(), [&] { ++wakes; },
      [](const Scene&, const View&, const Settings& settings, Vec2i, Prepared&, Progress&) {
        if (settings.near > 1) throw std::bad_alloc();
        return PixelStory{};
      });
  worker.request({request_with(2), {0, 0}});
  ASSERT_TRUE(comes_true([&] { return !worker.busy() && wakes > 0; }));
  expect_words_about_memory(worker.message());
  EXPECT_TRUE(worker.has_news());
  EXPECT_EQ(worker.story(), nullptr);
  worker.request({request_with(1), {0, 0}});
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_EQ(worker.message(), "");
  EXPECT_NE(worker.story(), nullptr);
}

TEST(BackgroundStudy, WithoutMemoryItFailsInWords) {
  std::atomic<int> wakes{0};
  BackgroundStudy<int> study([&] { ++wakes; });
  study.start([](StudyControl&, const BackgroundStudy<int>::Publish&) { throw std::bad_alloc(); });
  ASSERT_TRUE(comes_true([&] { return study.state() == StudyState::failed && wakes > 0; }));
  expect_words_about_memory(study.message());
  EXPECT_FALSE(study.running());
  study.start(
      [](StudyControl&, const BackgroundStudy<int>::Publish& publish) { publish(std::make_shared<const int>(7), {}); });
  ASSERT_TRUE(comes_true([&] { return study.state() == StudyState::done; }));
  EXPECT_EQ(study.message(), "");
  EXPECT_EQ(*study.found(), 7);
}

// Numbers of objects and lights mean something in the story's own scene only.
TEST(InspectWorker, AStoryIsGivenForItsOwnSceneAlone) {
  InspectWorker worker(
      std::make_shared<Prepared>(), [] {},
      [](const Scene&, const View&, const Settings&, Vec2i, Prepared&, Progress&) { return PixelStory{}; });
  PictureRequest request = request_with(1);
  request.scene.name = "one";
  worker.request({request, {0, 0}});
  ASSERT_TRUE(comes_true([&] { return !worker.busy(); }));
  EXPECT_NE(worker.story_of("one"), nullptr);
  EXPECT_EQ(worker.story_of("another"), nullptr);
  EXPECT_NE(worker.story(), nullptr);
}

}  // namespace
}  // namespace ps::gui::render_worker_test
