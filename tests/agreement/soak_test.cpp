// A long session of 2,000 switches: scenes, options and renderers change, and the history grows. Memory ends about
// where it was after the first 200.
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <iostream>

#include "base/check.h"
#include "base/sanitizers.h"
#include "document/history.h"
#include "options/option.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/share_content.h"
#include "support/environment.h"
#include "support/option_contexts.h"
#include "support/random_settings.h"

namespace ps::soak_test {
namespace {

constexpr int switches = 2000, warm_up = 200;
constexpr int switches_of_one_scene = 4;

double resident_megabytes() {
  std::ifstream statm("/proc/self/statm");
  double all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// What the window does: a document, its history, and what is kept between pictures.
class LongSession {
 public:
  explicit LongSession(unsigned seed) : random_(seed), history_(opened("cgfs/reflections")) {}

  /// Changes the scene or an option, and draws.
  void step(int number) {
    if (number % switches_of_one_scene == 0) {
      const auto& scenes = builtin_scenes();
      const std::string& name = scenes[static_cast<std::size_t>(number / switches_of_one_scene) % scenes.size()].name;
      history_.push(opened(name), "open " + name);
    } else {
      Document changed = history_.current();
      change(changed.a.settings);
      history_.push(std::move(changed), "option");
    }
    draw(history_.current());
  }
  int drawn() const { return drawn_; }

 private:
  /// As the window opens it: with what an earlier entry of the history already holds.
  Document opened(const std::string& name) {
    Scene scene = load_scene(name);
    for (const Scene& earlier : opened_)
      if (earlier.name == name) scene = share_content(std::move(scene), earlier);
    opened_.push_back(scene);
    if (opened_.size() > builtin_scenes().size()) opened_.erase(opened_.begin());
    return open_document(name, std::move(scene));
  }
  void change(Settings& settings) {
    const auto table = option_table();
    const Option& option = table[static_cast<std::size_t>(test::below(random_, static_cast<int>(table.size())))];
    option.set(settings, test::random_value(option, random_));
    const int renderer = test::below(random_, test::has_renderer("hardware") ? 3 : 2);
    parse_assignment(renderer == 0   ? "renderer=ray-tracer"
                     : renderer == 1 ? "renderer=rasterizer"
                                     : "renderer=hardware",
                     settings);
  }
  void draw(const Document& document) {
    Settings settings = document.a.settings;
    settings.shadow_map_size = std::min(settings.shadow_map_size, 32);
    settings.environment_size = std::min(settings.environment_size, 32);
    Progress progress;
    try {
      render(document.scene, {document.scene.camera, 24, 16}, settings, {}, prepared_, progress);
      ++drawn_;
    } catch (const InputError&) {  // such as a picture file that has no name yet
    }
  }

  std::mt19937 random_;
  std::vector<Scene> opened_;
  Prepared prepared_;
  History history_;
  int drawn_ = 0;
};

TEST(Soak, ALongSessionTakesNoMoreMemoryThanItsBeginning) {
  if (with_address_sanitizer || with_thread_sanitizer) GTEST_SKIP() << "a sanitizer keeps what was freed";
  const unsigned seed = test::test_seed(1);
  LongSession session(seed);
  double first = 0;
  for (int i = 0; i < switches; ++i) {
    session.step(i);
    if (i < warm_up) first = std::max(first, resident_megabytes());
  }
  const double last = resident_megabytes();
  std::cout << "PIXELSCOPE_TEST_SEED=" << seed << ": " << session.drawn() << " pictures, " << first << " MB after "
            << warm_up << " switches, " << last << " MB after " << switches << '\n';
  EXPECT_GT(session.drawn(), switches * 3 / 4);
  EXPECT_LE(last, 1.2 * first);
}

}  // namespace
}  // namespace ps::soak_test
