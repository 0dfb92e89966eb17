// The page that shows which options the hardware renderer honours is what the program's tables say.
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/atomic_file.h"
#include "base/read_file.h"
#include "base/resources.h"
#include "hardware/option_page.h"

namespace ps {
namespace {

/// With PIXELSCOPE_HARDWARE_OPTIONS=FILE writes the page, for assets/gallery/make.
TEST(HardwareOptionPage, IsWhatTheTablesSay) {
  const std::string page = hardware::option_page();
  if (const char* file = std::getenv("PIXELSCOPE_HARDWARE_OPTIONS")) return write_file_atomically(file, page);
  EXPECT_EQ(read_whole_file(asset_dir() / "gallery/hardware-options.md"), page)
      << "assets/gallery/make --hardware-options writes it again";
  for (const char* row : {"| `shadows` | `stencil-depth-fail` | yes |", "| `depth-value` | `z` | by gl_FragDepth |",
                          "| `stencil-bits` | 9 to 16 | no |", "| `deferred-shading` | `on` | yes |"})
    EXPECT_NE(page.find(row), std::string::npos) << row;
}

}  // namespace
}  // namespace ps
