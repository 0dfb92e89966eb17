// The main program around a student's own listing: reads a scene from standard input, has the listing draw it, and
// writes picture and values to descriptor 3. Exit status 3: the listing threw an exception, 4: no memory was left.
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "math/conventions.h"
#include "student/result_bytes.h"
#include "student/runtime/read_scene.h"
#include "textbook/listing.h"

namespace ps {
namespace {

constexpr int results = 3;

std::string read_all_of_input() {
  std::string all, part(1 << 20, '\0');
  for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), stdin)) > 0;) all.append(part, 0, size);
  return all;
}

Image<Vec3d> whole_picture(const BookScene& scene) {
  BookCanvas canvas(scene.width, scene.height, {0, 0, scene.width, scene.height}, scene.background);
  draw_listing(scene, canvas);
  Image<Vec3d> picture(scene.width, scene.height, Unfilled{});
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) picture.at(x, y) = canvas.at(x, y);
  return picture;
}

OwnTrace trace_of(const BookScene& scene, Vec2i pixel) {
  BookCanvas canvas(scene.width, scene.height, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, scene.background);
  WatchCollector collector(book_pixel(pixel.x, pixel.y, scene.width, scene.height));
  draw_listing(scene, canvas);
  return {canvas.at(pixel.x, pixel.y), collector.watches(), collector.instances(), collector.dropped(), nullptr};
}

void write_all(const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t size = write(results, bytes.data() + at, bytes.size() - at);
    if (size <= 0) return;
    at += static_cast<std::size_t>(size);
  }
}

void draw_and_write() {
  const auto read = read_scene(read_all_of_input());
  OwnResult result;
  if (read->task.picture) result.picture = whole_picture(*read->book);
  if (read->task.traced) result.trace = trace_of(*read->book, *read->task.traced);
  write_all(result_bytes(result));
}

}  // namespace
}  // namespace ps

// Named by the linker's command, so that this file is linked also with a listing that has a main of its own: the linker
// then says that there are two, instead of leaving this one out.
extern "C" const int pixelscope_listing_main = 1;

int main() {
  constexpr int threw = 3, no_memory = 4;
  try {
    ps::draw_and_write();
    return 0;
  } catch (const std::bad_alloc&) {
    return no_memory;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return threw;
  }
}
