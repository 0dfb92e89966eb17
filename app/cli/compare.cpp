#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "base/kept_inputs.h"
#include "cli/command.h"
#include "cli/output_file.h"
#include "image/difference.h"
#include "image/display.h"
#include "image/file.h"
#include "image/metrics.h"
#include "render/provenance.h"
#include "study/comparison_json.h"

namespace ps::cli {
namespace {

struct CompareArguments {
  std::string a, b, difference;
  bool json = false, linear = false, identical = false;
};

/// Two files, and all that differs between them.
struct ComparedFiles {
  StoredPicture a, b;
  Comparison values;  ///< of the samples, without SSIM and FLIP
  Comparison asked;   ///< what is printed: of the display levels, or of the samples
  AlphaDifference alpha;
};

ComparedFiles compare_files(const CompareArguments& arguments) {
  ComparedFiles files{load_picture(arguments.a), load_picture(arguments.b), {}, {}, {}};
  files.values = compare_channels(files.a.colour, files.b.colour);
  files.asked = arguments.linear ? compare_linear(files.a.colour, files.b.colour)
                                 : compare_images(display_image(files.a.colour), display_image(files.b.colour));
  files.alpha = compare_alpha(files.a.alpha, files.b.alpha);
  files.asked.identical = files.values.identical && files.alpha.differing == 0;
  return files;
}

std::vector<std::string> notes_of(const ComparedFiles& files, const CompareArguments& arguments) {
  std::vector<std::string> notes;
  for (const std::string& note : files.a.notes) notes.push_back(fmt::format("{}: {}", arguments.a, note));
  for (const std::string& note : files.b.notes) notes.push_back(fmt::format("{}: {}", arguments.b, note));
  return notes;
}

void print_json(const ComparedFiles& files, const CompareArguments& arguments) {
  nlohmann::ordered_json json = comparison_json(files.asked);
  json["values"] = {
      {"differing", files.values.differing}, {"max", files.values.max}, {"not-finite", files.values.not_finite}};
  json["alpha"] = {{"differing", files.alpha.differing}, {"max", files.alpha.max}};
  json["notes"] = notes_of(files, arguments);
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// Differences that display levels do not show.
void print_hidden(const ComparedFiles& files) {
  const auto pixels = [](std::int64_t n) { return fmt::format("{} pixel{}", n, n == 1 ? "" : "s"); };
  if (files.values.not_finite > 0) fmt::print("pixels not finite      {}\n", files.values.not_finite);
  if (files.alpha.differing > 0)
    fmt::print("alpha                  differs in {}, by at most {:.6g}\n", pixels(files.alpha.differing),
               files.alpha.max);
}

void print_same_levels(const ComparedFiles& files) {
  if (files.values.identical)
    fmt::print("identical in colour, not in alpha\n");
  else if (files.values.max > 0)
    fmt::print("identical in display levels; values differ by at most {:.6g} (--linear measures them)\n",
               files.values.max);
  else
    fmt::print("identical in display levels; values that are not finite differ (--linear counts them)\n");
  if (!files.values.identical) fmt::print("differing pixels       {}\n", files.values.differing);
  print_hidden(files);
}

void print_text(const ComparedFiles& files, const CompareArguments& arguments) {
  for (const std::string& note : notes_of(files, arguments)) fmt::print(stderr, "{}.\n", note);
  const Comparison& c = files.asked;
  if (c.identical) return fmt::print("identical\n");
  if (c.differing == 0) return print_same_levels(files);
  const std::string_view unit = arguments.linear ? "unit floats" : "levels of 255";
  fmt::print("differing pixels       {}\n", c.differing);
  fmt::print("largest difference     {:.6g} {}\n", c.max, unit);
  fmt::print("mean absolute error    {:.6g} {}\n", c.mae, unit);
  fmt::print("root mean square error {:.6g} {}\n", c.rmse, unit);
  if (c.psnr) fmt::print("signal to noise        {:.4g} dB\n", *c.psnr);
  fmt::print("structural similarity  {:.4g}\n", c.ssim);
  fmt::print("FLIP                   {:.4g}\n", c.flip);
  print_hidden(files);
}

void save_difference(const CompareArguments& arguments, const ComparedFiles& files) {
  Provenance made = provenance_of(Settings{});
  made.more = {{"difference-of", arguments.a}, {"and", arguments.b}};
  save_image(arguments.difference, difference_picture(display_image(files.a.colour), display_image(files.b.colour)),
             {image_texts(made)});
}

int run_compare(const CompareArguments& arguments) {
  if (!arguments.difference.empty()) {
    require_output_file(arguments.difference, OutputKind::levels);
    require_no_input(arguments.difference, {arguments.a, arguments.b});
  }
  const ComparedFiles files = compare_files(arguments);
  if (!arguments.difference.empty()) save_difference(arguments, files);
  if (arguments.json)
    print_json(files, arguments);
  else
    print_text(files, arguments);
  return arguments.identical && !files.asked.identical ? 1 : 0;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("compare", "measure the difference between two pictures");
  const auto arguments = std::make_shared<CompareArguments>();
  command
      ->add_option("IMAGE", arguments->a,
                   "a picture file. Its content decides how it is read; an EXIF orientation and the scale of a PFM "
                   "file are not applied")
      ->required();
  command->add_option("OTHER", arguments->b, "a picture file of the same size")->required();
  command->add_flag("--json", arguments->json, "as JSON");
  command->add_flag("--linear", arguments->linear, "compare unit floats instead of display levels");
  command->add_flag("--identical", arguments->identical, "exit 1 where any sample differs, of colour or alpha");
  command->add_option("--diff", arguments->difference, "write the difference picture to this .png or .ppm file");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_compare(*arguments); }; });
}

}  // namespace ps::cli
