#include "inspect/story_json.h"

#include <nlohmann/json.hpp>

#include "inspect/describe.h"
#include "inspect/face_data.h"
#include "math/conventions.h"
#include "options/choice_key.h"
#include "render/provenance_json.h"
#include "render/story/names.h"
#include "textbook/trace_listing.h"

namespace ps {
namespace {

using Json = nlohmann::ordered_json;

Json list(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }

struct ValueJson {
  const Scene& scene;

  Json operator()(bool v) const { return v; }
  Json operator()(std::int64_t v) const { return v; }
  Json operator()(double v) const { return v; }
  Json operator()(const std::string& v) const { return v; }
  Json operator()(const std::vector<double>& v) const { return v; }
  Json operator()(const std::vector<bool>& v) const { return v; }
  Json operator()(const PixelId& v) const {
    return {{"object", v.object}, {"triangle", v.triangle}, {"name", primitive_name(scene, v)}};
  }
  Json operator()(const std::vector<Texel>& v) const {
    Json texels = Json::array();
    for (const Texel& t : v)
      texels.push_back({{"x", t.x}, {"y", t.y}, {"level", t.level}, {"weight", t.weight}, {"colour", list(t.colour)}});
    return texels;
  }
};

struct WatchJson {
  Json operator()(bool v) const { return v; }
  Json operator()(std::int64_t v) const { return v; }
  Json operator()(double v) const { return v; }
  Json operator()(const Vec2d& v) const { return Json::array({v.x, v.y}); }
  Json operator()(const Vec3d& v) const { return list(v); }
  Json operator()(const std::string& v) const { return v; }
};

Json event_json(const Event& event, const Scene& scene) {
  Json json{{"kind", event_kind(event.data)}, {"parent", event.parent}, {"text", describe(event, scene)}};
  for (const EventField& field : event_fields(event.data, scene))
    json[std::string(field.key)] = std::visit(ValueJson{scene}, field.value);
  return json;
}

Json listing_json(const ListingTrace& trace) {
  Json json{{"folder", trace.listing.folder}, {"source", trace.listing.listing->source}, {"dropped", trace.dropped}};
  if (!trace.listing.bug.empty()) json["bug"] = trace.listing.bug;
  json["instances"] = Json::array();
  for (const WatchInstance& instance : trace.instances)
    json["instances"].push_back({{"line", instance.line},
                                 {"name", instance.name},
                                 {"value", watch_text(instance.value)},
                                 {"parent", instance.parent}});
  json["values"] = Json::array();
  for (const Watch& watch : trace.watches)
    json["values"].push_back({{"line", watch.line},
                              {"name", watch.name},
                              {"value", std::visit(WatchJson{}, watch.value)},
                              {"instance", watch.instance}});
  return json;
}

}  // namespace

std::string story_json(const PixelStory& story, const Scene& scene, const View& view, const Provenance& provenance) {
  const Vec2i book = book_pixel(story.pixel.x, story.pixel.y, view.width, view.height);
  Json json{{"pixel", {story.pixel.x, story.pixel.y}},
            {"book-pixel", {book.x, book.y}},
            {"size", {view.width, view.height}},
            {"renderer", choice_key<&Settings::renderer>(story.renderer)},
            {"verdict", story.verdict},
            {"colour", {{"linear", list(story.linear)}, {"display", story.display}}}};
  json["events"] = Json::array();
  for (const Event& event : story.events) json["events"].push_back(event_json(event, scene));
  json["ledger"] = Json::array();
  for (const LedgerLine& line : story.ledger)
    json["ledger"].push_back(
        {{"level", line.level}, {"term", line.term}, {"value", list(line.value)}, {"event", line.event}});
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    Json& value = json["counters"][std::string(counter_key(counter))];  // null: the renderer cannot give it
    if (const auto count = story.counters.get(counter)) value = *count;
  }
  json["triangles-elsewhere"] = story.triangles_elsewhere;
  if (!story.not_reported.empty()) json["not-reported"] = story.not_reported;
  if (story.listing) json["listing"] = listing_json(*story.listing);
  json["provenance"] = provenance_json(provenance);
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ps
