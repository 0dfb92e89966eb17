#include <unistd.h>

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/tar.h"
#include "document/permalink.h"
#include "engine/lesson.h"
#include "fuzz/read_or_refuse.h"
#include "image/file.h"
#include "student/check_listing.h"
#include "study/chart_log.h"
#include "textbook/listing_view.h"

namespace ps::fuzz {
namespace {

/// A chart's folder with four small pictures, for logs that name them. Gone with the program.
class ChartFolder {
 public:
  ChartFolder() : path_(std::filesystem::temp_directory_path() / fmt::format("pixelscope-chart-log-{}", getpid())) {
    std::filesystem::create_directories(path_);
    for (int i = 0; i < 4; ++i) save_image(path_ / fmt::format("picture-{}.png", i), Image<Rgb8>(3, 2));
  }
  ~ChartFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ChartFolder(const ChartFolder&) = delete;
  ChartFolder& operator=(const ChartFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

/// What is read is written as a permalink of the same text.
Outcome read_permalink(std::string_view bytes) {
  return read_or_refuse([&] {
    const std::string text = permalink(parse_permalink(bytes));
    std::string again;
    try {
      again = permalink(parse_permalink(text));
    } catch (const InputError& error) {
      throw std::logic_error(std::string("what was written cannot be read: ") + error.what() + "\n" + text);
    }
    PS_ASSERT(again == text, "a permalink that was written reads back as itself");
  });
}

/// The files that are read are written as an archive, and their names stay inside it. The sums of the headers are
/// mended first, or few changes would get past them.
Outcome read_bundle(std::string_view bytes) {
  return read_or_refuse([&] {
    constexpr std::size_t block = 512, sum_at = 148;
    std::string mended(bytes);
    for (std::size_t at = 0; at + block <= mended.size(); at += block) {
      if (mended.compare(at + 257, 5, "ustar") != 0) continue;
      mended.replace(at + sum_at, 8, 8, ' ');
      unsigned sum = 0;
      for (std::size_t i = 0; i < block; ++i) sum += static_cast<unsigned char>(mended[at + i]);
      mended.replace(at + sum_at, 7, fmt::format("{:06o}", sum) + '\0');
    }
    const std::vector<TarEntry> files = read_tar(mended, "fuzz.tar");
    for (const TarEntry& file : files)
      PS_ASSERT(!file.name.starts_with('/') && file.name.find("../") != 0, "a file lies in the archive");
    const std::vector<TarEntry> again = read_tar(tar_bytes(files), "written.tar");
    PS_ASSERT(again.size() == files.size(), "an archive that was written has the same files");
    for (std::size_t i = 0; i < files.size(); ++i)
      PS_ASSERT(again[i].name == files[i].name && again[i].bytes == files[i].bytes, "each file reads back as itself");
  });
}

/// Times are durations.
Outcome read_log_of_chart(std::string_view bytes) {
  static const ChartFolder folder;
  write_file_atomically(folder.path() / "runs.jsonl", std::string(bytes), Durability::quick);
  return read_or_refuse([&] {
    const Chart chart = read_chart_log(folder.path());
    for (const ChartPoint& point : chart.points)
      for (const double time : point.samples_ms) PS_ASSERT(std::isfinite(time) && time >= 0, "a time is a duration");
  });
}

Outcome read_lesson(std::string_view bytes) {
  return read_or_refuse([&] {
    const Lesson lesson = parse_lesson(bytes, "fuzz", "fuzz/lesson.md");
    PS_ASSERT(!lesson.title.empty() && !lesson.steps.empty(), "a lesson has a title and steps");
    for (const LessonStep& step : lesson.steps)
      for (const Claim& claim : step.claims) PS_ASSERT(std::isfinite(claim.bound.number), "a bound is a number");
  });
}

/// What is read can be shown beside the lines of a listing.
Outcome read_own_result(std::string_view bytes) {
  static const ListingText text =
      parse_listing("namespace {\nint x = 1;\nPS_WATCH(\"x\", x);\nint y;\n}  // namespace\n");
  return read_or_refuse([&] {
    const OwnResult result = parse_result(bytes, 3, 2, {.picture = true, .traced = Vec2i{1, 0}});
    PS_ASSERT(result.picture.width() == 3 && result.picture.height() == 2 && result.trace, "what was asked for");
    const ListingTrace trace = listing_trace(*result.trace, listings()[0], {1, 0});
    PS_ASSERT(ListingView(trace, text).rows().size() == text.lines.size(), "each line is shown once");
    static_cast<void>(wrong_pixels(result.picture, result.picture));
  });
}

}  // namespace ps::fuzz
