// The whole tree of the space view is built off the window's thread.
#include "gui/work/space_tree_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::gui::space_tree_worker_test {
namespace {

using namespace std::chrono_literals;

/// A gate between two threads that gives up after a long time, so that a failing test ends.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, 60s, [&] { return open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
};

// The worker calls `wake` from the thread that has built the tree. Here that call does not return before request() has:
// had request() built it, it would wait for itself.
TEST(SpaceTreeWorker, BuildsTheTreeOnAThreadOfItsOwn) {
  Prepared prepared;
  SpaceTreeRequest request;
  request.scene = load_scene("octree/headline");
  request.settings = settings_for(request.scene);
  parse_assignment("renderer=ray-tracer", request.settings);
  parse_assignment("accelerator=octree", request.settings);
  request.prepared = &prepared;
  ASSERT_EQ(prepared.bytes(), 0u) << "no picture has left a tree";

  Gate asked, built;
  bool waited_for_request = false;
  std::thread::id builder;
  SpaceTreeWorker worker([&] {
    waited_for_request = asked.wait();
    builder = std::this_thread::get_id();
    built.open();
  });
  worker.request(request);
  asked.open();
  ASSERT_TRUE(built.wait());
  EXPECT_TRUE(waited_for_request) << "request() returned before the tree was there";
  EXPECT_NE(builder, std::this_thread::get_id());
  EXPECT_GT(prepared.bytes(), 0u) << "it is left for the next one";
  const auto found = worker.result();
  ASSERT_TRUE(found);
  Prepared own;
  SpaceModel expected;
  const SpaceTree tree = add_tree(request.scene, request.settings, nullptr, own, expected);
  EXPECT_EQ(found->tree.nodes, tree.nodes);
  EXPECT_GT(tree.nodes, 100u);
  EXPECT_EQ(found->nodes.items.size(), expected.items.size());
}

}  // namespace
}  // namespace ps::gui::space_tree_worker_test
