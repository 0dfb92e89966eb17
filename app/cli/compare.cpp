#include <fmt/format.h>

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
  bool json = false, linear = false;
};

void print_json(const Comparison& c) { fmt::print("{}\n", comparison_json(c).dump(2)); }

void print_text(const Comparison& c, const CompareArguments& arguments) {
  if (c.identical) {
    fmt::print("identical\n");
    return;
  }
  const std::string_view unit = arguments.linear ? "unit floats" : "levels of 255";
  fmt::print("differing pixels       {}\n", c.differing);
  fmt::print("largest difference     {:.6g} {}\n", c.max, unit);
  fmt::print("mean absolute error    {:.6g} {}\n", c.mae, unit);
  fmt::print("root mean square error {:.6g} {}\n", c.rmse, unit);
  if (c.psnr) fmt::print("signal to noise        {:.4g} dB\n", *c.psnr);
  fmt::print("structural similarity  {:.4g}\n", c.ssim);
  fmt::print("FLIP                   {:.4g}\n", c.flip);
  if (c.not_finite > 0) fmt::print("pixels not finite      {}\n", c.not_finite);
}

Comparison compare_files(const CompareArguments& arguments) {
  if (arguments.linear) return compare_linear(load_image(arguments.a), load_image(arguments.b));
  return compare_images(load_levels(arguments.a), load_levels(arguments.b));
}

void save_difference(const CompareArguments& arguments) {
  Provenance made = provenance_of(Settings{});
  made.more = {{"difference-of", arguments.a}, {"and", arguments.b}};
  save_image(arguments.difference, difference_picture(load_levels(arguments.a), load_levels(arguments.b)),
             {image_texts(made)});
}

int run_compare(const CompareArguments& arguments) {
  if (!arguments.difference.empty()) {
    require_output_file(arguments.difference, OutputKind::levels);
    require_no_input(arguments.difference, {arguments.a, arguments.b});
  }
  const Comparison comparison = compare_files(arguments);
  if (!arguments.difference.empty()) save_difference(arguments);
  if (arguments.json)
    print_json(comparison);
  else
    print_text(comparison, arguments);
  return 0;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("compare", "measure the difference between two pictures");
  const auto arguments = std::make_shared<CompareArguments>();
  command->add_option("IMAGE", arguments->a, "a picture file")->required();
  command->add_option("OTHER", arguments->b, "a picture file of the same size")->required();
  command->add_flag("--json", arguments->json, "as JSON");
  command->add_flag("--linear", arguments->linear, "compare unit floats instead of display levels");
  command->add_option("--diff", arguments->difference, "write the difference picture to this .png or .ppm file");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_compare(*arguments); }; });
}

}  // namespace ps::cli
