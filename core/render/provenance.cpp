#include "render/provenance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/check.h"
#include "base/csv.h"
#include "base/parallel.h"
#include "image/svg.h"
#include "options/option.h"
#include "options/simd_choice.h"

namespace ps {
Provenance provenance_of(const Settings& settings, const std::optional<Machinery>& drawn_by) {
  Provenance result = provenance_of(this_machine(), fmt::format("{}", fmt::join(changed_options(settings), ";")));
  result.simd = drawn_by == Machinery::clear ? "none" : chosen_simd(settings.simd);
  result.threads = resolve_threads({settings.threads, WorkerPriority::normal});
  if (drawn_by) result.more.emplace_back("machinery", machinery_key(*drawn_by));
  return result;
}

Provenance provenance_of(const Machine& machine, std::string settings) {
  return {"pixelscope " + machine.version, machine.processor, machine.simd, machine.threads, std::move(settings), {}};
}

std::vector<std::pair<std::string, std::string>> provenance_facts(const Provenance& p) {
  std::vector<std::pair<std::string, std::string>> facts{{"program", p.program},
                                                         {"processor", p.processor},
                                                         {"simd", p.simd},
                                                         {"threads", std::to_string(p.threads)},
                                                         {"settings", p.settings}};
  facts.insert(facts.end(), p.more.begin(), p.more.end());
  return facts;
}

std::vector<ImageText> image_texts(const Provenance& provenance) {
  std::vector<ImageText> texts;
  for (auto& [key, value] : provenance_facts(provenance))
    texts.push_back({key == "program" ? "Software" : std::move(key), std::move(value)});
  return texts;
}

std::string svg_with_provenance(std::string svg, const Provenance& provenance) {
  const std::size_t end = svg.rfind("</svg>");
  PS_ASSERT(end != std::string::npos, "a whole SVG file");
  std::string metadata = "<metadata>\n";
  for (const auto& [key, value] : provenance_facts(provenance))
    metadata += fmt::format("{}: {}\n", key, xml_escaped(value));
  return svg.insert(end, metadata + "</metadata>\n");
}

std::string provenance_markdown(const Provenance& provenance) {
  std::string text;
  for (const auto& [key, value] : provenance_facts(provenance))
    if (!value.empty()) text += fmt::format("- {}: `{}`\n", key, value);
  return text;
}

std::string csv_with_provenance(std::string_view csv, const Provenance& p, std::string_view settings_key) {
  return csv_with_columns(
      csv, {"program", "processor", "simd", "threads", std::string(settings_key)}, [&](std::size_t) {
        return std::vector<std::string>{p.program, p.processor, p.simd, std::to_string(p.threads), p.settings};
      });
}

}  // namespace ps
