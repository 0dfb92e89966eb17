// The page that shows how the renderers agree, and the bounds that it states.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>

#include "agreement/hardware/agreement_page.h"
#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "base/read_file.h"
#include "base/resources.h"
#include "hardware/gl_thread.h"

namespace ps {
namespace {

using test::MeasuredMatrix;

/// The page's lines with all their numbers taken out.
struct Lines {
  std::vector<std::string> words;
  std::vector<std::vector<double>> numbers;
};

Lines lines_of(const std::string& page) {
  static const std::regex number("[0-9]+([.][0-9]+)?");
  Lines lines;
  std::istringstream stream(page);
  for (std::string line; std::getline(stream, line);) {
    if (line.find(" sub-pixel bits; ") != std::string::npos) continue;  // the driver's name
    lines.numbers.emplace_back();
    for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i)
      lines.numbers.back().push_back(std::stod(i->str()));
    lines.words.push_back(std::regex_replace(line, number, "#"));
  }
  return lines;
}

/// Figures of another processor, whose driver may round otherwise: near those of the page.
void expect_near(const Lines& page, const Lines& now) {
  ASSERT_EQ(page.words, now.words) << "assets/gallery/make --agreement writes it again";
  for (std::size_t i = 0; i < page.numbers.size(); ++i)
    for (std::size_t k = 0; k < page.numbers[i].size(); ++k)
      EXPECT_NEAR(page.numbers[i][k], now.numbers[i][k], 20 + 0.1 * page.numbers[i][k]) << page.words[i];
}

void expect_bounds(const MeasuredMatrix::Row& row) {
  const std::string name = row.row.name() + " " + row.snapping;
  const StageSplit& split = row.split;
  if (row.row.holds_bound(row.snapping)) {
    EXPECT_LE(split.whole.ids, row.row.bound()) << name;
    EXPECT_LE(split.whole.colours, row.row.bound()) << name;
    EXPECT_LE(split.edge_distance, std::exp2(-hardware::availability().driver->subpixel_bits)) << name;
  }
  long pixels = 0, ids = 0, colours = 0;
  double error = 0;
  for (const StageShare& share : split.shares) {
    pixels += share.pixels;
    ids += share.ids;
    colours += share.colours;
    error += share.error;
  }
  EXPECT_EQ(pixels, split.whole.pixels) << name;
  EXPECT_EQ(ids, split.whole.ids) << name;
  EXPECT_EQ(colours, split.whole.colours) << name;
  EXPECT_DOUBLE_EQ(error, split.whole.error) << name;
}

/// The page in assets/gallery that was measured with this driver, or nothing: each graphics card rounds in its own way.
std::optional<std::string> kept_page() {
  const std::string page = read_whole_file(asset_dir() / "gallery" / test::agreement_page_name());
  const std::string driver = test::drawn_by_llvmpipe() ? "llvmpipe" : hardware::availability().driver->renderer;
  if (page.find("The driver is\n" + driver) == std::string::npos) return {};
  return page;
}

/// With PIXELSCOPE_AGREEMENT=FOLDER writes the page there, for assets/gallery/make.
TEST(HardwareAgreementPage, IsWhatIsMeasuredAndWithinItsBounds) {
  PS_NEEDS_HARDWARE(hardware);
  const MeasuredMatrix matrix = test::measure_matrix(hardware);
  const std::string page = test::agreement_page(matrix);
  if (const char* folder = std::getenv("PIXELSCOPE_AGREEMENT")) {
    fmt::print("wrote {}\n", test::agreement_page_name());
    return write_file_atomically(std::filesystem::path(folder) / test::agreement_page_name(), page);
  }
  for (const MeasuredMatrix::Row& row : matrix.rows) expect_bounds(row);
  EXPECT_LE(matrix.whole().part(StageCause::unexplained), 0.05);
  for (const MeasuredMatrix::Ray& ray : matrix.rays) EXPECT_FALSE(ray.row.why.empty());
  if (const auto kept = kept_page()) expect_near(lines_of(*kept), lines_of(page));
}

}  // namespace
}  // namespace ps
