#include "cli/print_stages.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/kept_inputs.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "document/document_provenance.h"
#include "image/file.h"
#include "render/provenance_json.h"
#include "scene/load.h"
#include "study/stage_causes.h"

namespace ps::cli {
namespace {

nlohmann::ordered_json json_of(const StageShare& share) {
  return {{"pixels", share.pixels}, {"colours", share.colours}, {"ids", share.ids}, {"error", share.error}};
}

void print_json(const Document& document, const StageSplit& split, const Provenance& made) {
  nlohmann::ordered_json json{{"scene", document.scene_name}, {"pixels", split.causes.pixels().size()}};
  json["whole"] = json_of(split.whole);
  json["largest"] = split.largest;
  json["edge-distance"] = split.edge_distance;
  for (std::size_t i = 1; i < stage_cause_count; ++i)
    json["causes"][std::string(stage_cause_label(static_cast<StageCause>(i)))] = json_of(split.shares[i]);
  json["provenance"] = provenance_json(made);
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

}  // namespace

int print_stages(const Document& document, const Settings& b, const StageOutput& output) {
  if (!output.picture.empty()) {
    require_output_file(output.picture, OutputKind::levels);
    require_no_input(output.picture, files_of(document.scene));
  }
  const Settings& a = document.a.settings;
  if (const auto reason = why_no_stages(scene_traits(document.scene), a, b)) throw InputError(*reason);
  StudyControl control;
  forward_interrupts(control.progress());
  const StageSplit split = split_by_stage(stage_request(document.scene, view_of(document), a, b), control);
  const Provenance made = document_provenance(document, Side::a);
  if (!output.picture.empty()) save_image(output.picture, stage_picture(split), {image_texts(made)});
  if (output.json) {
    print_json(document, split, made);
    return 0;
  }
  fmt::print("{} of {} pixels differ: {} in colour, by {} levels at most, {} in what is seen\n", split.whole.pixels,
             split.causes.pixels().size(), split.whole.colours, split.largest, split.whole.ids);
  fmt::print("{:<16} {:>8} {:>8} {:>8} {:>8}\n", "cause", "pixels", "", "colours", "ids");
  for (std::size_t i = 1; i < stage_cause_count; ++i) {
    const auto cause = static_cast<StageCause>(i);
    const StageShare& share = split.share(cause);
    fmt::print("{:<16} {:>8} {:>7.1f}% {:>8} {:>8}\n", stage_cause_label(cause), share.pixels, 100 * split.part(cause),
               share.colours, share.ids);
  }
  if (split.edge_distance > 0)
    fmt::print("coverage differs at samples that lie up to {:.4f} pixels from an edge\n", split.edge_distance);
  return 0;
}

}  // namespace ps::cli
