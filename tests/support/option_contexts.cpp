#include "support/option_contexts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "base/resources.h"
#include "frame/display_frame.h"
#include "options/listing.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::test {
namespace {

/// A file's path, or the name of a built-in scene.
std::string path_of(std::string_view scene) {
  if (!scene.ends_with(".scene")) return std::string(scene);
  if (scene.find('/') == std::string_view::npos) return PIXELSCOPE_TEST_DIR "/support/" + std::string(scene);
  return (chapter_dir() / scene).string();
}

/// The scene's own renderer or, if it does not use the option, the first that does; none where that cannot draw here.
std::optional<Renderer> renderer_using(const Option& option, Settings settings, const SceneTraits& traits) {
  const auto uses = [&] {
    const auto reason = inactive_reason(option, settings, traits);
    return !reason || reason->kind() != IdleReason::Kind::renderer;
  };
  if (uses()) return settings.renderer;
  for (std::size_t i = 0; i < renderer_kinds().size(); ++i) {
    settings.renderer = static_cast<Renderer>(i);
    if (uses() && has_renderer(renderer_kinds()[i].key)) return settings.renderer;
  }
  return {};
}

std::optional<OptionContext> context_of(const Option& option, const SeenScene& seen) {
  OptionContext context{path_of(seen.scene), {}};
  const Scene scene = load_scene(context.scene);
  const Settings own = settings_for(scene);
  std::istringstream assignments{std::string(seen.settings)};
  Settings settings = own;
  for (std::string assignment; std::getline(assignments, assignment, ';');) {
    parse_assignment(assignment, settings);
    context.assignments.push_back(assignment);
  }
  const auto renderer = seen.way ? renderer_for(*seen.way) : renderer_using(option, settings, scene_traits(scene));
  if (!renderer) return {};
  if (*renderer != own.renderer)
    context.assignments.insert(context.assignments.begin(), fmt::format("renderer={}", renderer_kind(*renderer).key));
  return context;
}

struct AllContexts {
  std::vector<OptionContext> list;
  std::map<std::string_view, std::vector<std::size_t>> of_option;  ///< indices into `list`, by key
};

const AllContexts& all_contexts() {
  static const AllContexts all = [] {
    AllContexts found;
    for (const Option& option : option_table())
      for (const SeenScene& seen : option.shown_by.scenes.list) {
        auto context = context_of(option, seen);
        if (!context) continue;
        const auto same = std::find(found.list.begin(), found.list.end(), *context);
        found.of_option[option.key].push_back(static_cast<std::size_t>(same - found.list.begin()));
        if (same == found.list.end()) found.list.push_back(std::move(*context));
      }
    return found;
  }();
  return all;
}

Outcome outcome(const Scene& scene, int width, int height, const Settings& settings, Prepared& prepared) {
  Progress progress;
  const Frame frame = render(scene, {scene.camera, width, height}, settings, {}, prepared, progress);
  return {display_frame(frame, settings), frame.counters};
}

std::vector<double> other_values(const Option& option, const Settings& settings) {
  const double now = option.get(settings);
  std::vector<double> values = values_of(option);
  if (option.kind == OptionKind::integer || option.kind == OptionKind::real)
    values.insert(values.begin(), std::clamp(now * 2 + 1, option.minimum, option.maximum));
  std::erase(values, now);
  return values;
}

}  // namespace

std::vector<OptionNumber> values_of(const Option& option) {
  std::vector<OptionNumber> values;
  switch (option.kind) {
  case OptionKind::boolean:
    return {0, 1};
  case OptionKind::choice:
    for (std::size_t i = 0; i < option.choices.size(); ++i) values.push_back(static_cast<OptionNumber>(i));
    return values;
  case OptionKind::integer:
  case OptionKind::real:
    break;
  }
  return {option.minimum, option.maximum};
}

bool has_renderer(std::string_view key) {
  for (const RendererKind& kind : renderer_kinds())
    if (kind.key == key) return !kind.inactive || !kind.inactive(Settings{}, SceneTraits{});
  return false;
}

// An option that nobody reads although all renderers are here is a mistake, and no excuse.
bool lacks_its_renderer(const Option& option) {
  if (has_renderer("hardware") || option.acts_for != ActsFor::readers) return false;
  const auto all = listings();
  return std::none_of(all.begin(), all.end(), [&](const NamedListing& one) { return listing_reads(one, option.key); });
}

const std::vector<OptionContext>& option_contexts() { return all_contexts().list; }

struct OptionResponses::Loaded {
  Scene scene;
  Settings settings;
  Prepared prepared;
  std::optional<Outcome> before;
};

OptionResponses::OptionResponses(int width, int height) : width_(width), height_(height) {
  for (const OptionContext& context : option_contexts()) {
    auto loaded = std::make_unique<Loaded>();
    loaded->scene = load_scene(context.scene);
    loaded->settings = settings_for(loaded->scene);
    for (const std::string& assignment : context.assignments) parse_assignment(assignment, loaded->settings);
    loaded_.push_back(std::move(loaded));
  }
}

OptionResponses::~OptionResponses() = default;

const Settings& OptionResponses::settings(std::size_t context) const { return loaded_[context]->settings; }

const Outcome& OptionResponses::unchanged(std::size_t context) {
  Loaded& my = *loaded_[context];
  if (!my.before) my.before = outcome(my.scene, width_, height_, my.settings, my.prepared);
  return *my.before;
}

std::optional<OptionResponse> OptionResponses::find_in(std::size_t context, const Option& option, bool pictures_only) {
  Loaded& my = *loaded_[context];
  if (inactive_reason(option, my.settings, scene_traits(my.scene))) return {};
  const Outcome& before = unchanged(context);
  for (const double value : other_values(option, my.settings)) {
    Settings changed = my.settings;
    option.set(changed, value);
    Outcome after = outcome(my.scene, width_, height_, changed, my.prepared);
    if (pictures_only ? after.picture != before.picture : after != before)
      return OptionResponse{context, option_text(option, changed), before, std::move(after)};
  }
  return {};
}

std::vector<std::size_t> contexts_of(const Option& option) {
  const auto found = all_contexts().of_option.find(option.key);
  return found == all_contexts().of_option.end() ? std::vector<std::size_t>{} : found->second;
}

std::optional<OptionResponse> OptionResponses::find(const Option& option) {
  for (const bool pictures_only : {true, false})
    for (const std::size_t context : contexts_of(option))
      if (auto response = find_in(context, option, pictures_only)) return response;
  return {};
}

std::vector<AlikeValues> OptionResponses::alike(const Option& option, const std::vector<OptionNumber>& values,
                                                const std::vector<std::size_t>& contexts) {
  const std::size_t count = values.size();
  std::vector<std::vector<bool>> apart(count, std::vector<bool>(count, false));
  for (const std::size_t context : contexts) {
    const std::unique_ptr<Loaded>& loaded = loaded_[context];
    const SceneTraits traits = scene_traits(loaded->scene);
    if (inactive_reason(option, loaded->settings, traits)) continue;
    std::vector<std::optional<Outcome>> outcomes(count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_settled = std::count(apart[i].begin(), apart[i].end(), false) == 1;  // but for the value itself
      Settings changed = loaded->settings;
      option.set(changed, values[i]);
      if (is_settled || inactive_value_reason(option, changed, traits)) continue;
      outcomes[i] = outcome(loaded->scene, width_, height_, changed, loaded->prepared);
    }
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        if (outcomes[i] && outcomes[j] && *outcomes[i] != *outcomes[j]) apart[i][j] = true;
  }
  std::vector<AlikeValues> pairs;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (!apart[i][j]) pairs.push_back({values[i], values[j]});
  return pairs;
}

}  // namespace ps::test
