#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/machine.h"
#include "frame/machinery.h"
#include "image/file.h"
#include "options/settings.h"

namespace ps {

/// The origin that each file states which the program writes. Every export has it, in the way of its format: text
/// chunks (PNG), comments (PPM), <metadata> (SVG), an object (JSON), a section (Markdown), rows or further columns
/// (CSV, whose first line stays the heading). A PFM file has no place for it.
struct Provenance {
  std::string program;    ///< "pixelscope 0.1.0"
  std::string processor;  ///< as the system names it
  std::string simd;       ///< instruction set of the SIMD code: "AVX2"; "none" where scalar code did the work
  int threads = 1;        ///< that worked
  std::string settings;   ///< what differs from the option table's defaults: "renderer=rasterizer;gamma=2.2"
  std::vector<std::pair<std::string, std::string>> more;  ///< what only this export has, such as its scene
};

/// Provenance of work with these settings on this machine. `drawn_by` is what drew the picture, where that is known.
Provenance provenance_of(const Settings& settings, const std::optional<Machinery>& drawn_by = {});
/// Provenance of work by all of a machine, such as a study over many settings.
Provenance provenance_of(const Machine& machine, std::string settings);

/// All of it as keys and values, in a fixed order.
std::vector<std::pair<std::string, std::string>> provenance_facts(const Provenance& provenance);

/// For SaveOptions::texts. The program's key is "Software", which PNG has set aside for that.
std::vector<ImageText> image_texts(const Provenance& provenance);
/// The drawing with a <metadata> element in front of its end. `svg` is a whole file.
std::string svg_with_provenance(std::string svg, const Provenance& provenance);
/// The facts as a list of Markdown, without a heading.
std::string provenance_markdown(const Provenance& provenance);

/// The table with further columns at its end: program, processor, simd, threads, and `settings_key`, which names what
/// the settings are of. Every line of `csv` is a row, the first one the heading.
std::string csv_with_provenance(std::string_view csv, const Provenance& provenance,
                                std::string_view settings_key = "settings");

}  // namespace ps
