#include "cli/print_vertex.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "document/number_list.h"
#include "inspect/vertex_uses.h"
#include "record/value_text.h"

namespace ps::cli {
namespace {

using Json = nlohmann::ordered_json;

VertexId picked_vertex(const Document& document, const PixelStory& story, const std::string& text) {
  if (text != "nearest") {
    const auto numbers = parse_number_list(text, 2, "--vertex");
    return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
  }
  const Vec2d place{story.pixel.x + 0.5, story.pixel.y + 0.5};
  const auto nearest =
      nearest_vertex(document.scene, view_of(document), document.a.settings, place, shown_triangle(story));
  if (!nearest) throw InputError("--vertex: this scene has no models and so no vertices");
  return *nearest;
}

VertexEdits edits_of(const VertexArguments& arguments) {
  VertexEdits edits;
  if (arguments.order == "move-then-turn")
    edits.order = ModelOrder::move_then_turn;
  else if (!arguments.order.empty() && arguments.order != "turn-then-move")
    throw InputError(
        fmt::format("--vertex-order: found '{}', expected turn-then-move or move-then-turn", arguments.order));
  if (arguments.near > 0) edits.near = arguments.near;
  return edits;
}

void print_matrix(const Mat4d& m) {
  for (int row = 0; row < 4; ++row)
    fmt::print("             {:>10} {:>10} {:>10} {:>10}\n", number_text(m[0][row]), number_text(m[1][row]),
               number_text(m[2][row]), number_text(m[3][row]));
}

Json list(const Vec2d& v) { return Json::array({v.x, v.y}); }
Json list(const Vec3d& v) { return Json::array({v.x, v.y, v.z}); }
Json list(const Vec4d& v) { return Json::array({v.x, v.y, v.z, v.w}); }
Json rows(const Mat4d& m) {
  Json json = Json::array();
  for (int row = 0; row < 4; ++row) json.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
  return json;
}

Json use_json(const CornerUse& use) {
  const FaceCorner& corner = use.face.corners[static_cast<std::size_t>(use.corner)];
  Json json{{"triangle", use.triangle}, {"corner", use.corner}, {"faces-away", corner.faces_away}};
  if (corner.normal) json["normal"] = list(*corner.normal);
  if (corner.uv) json["uv"] = list(*corner.uv);
  const FaceData& face = use.face;
  for (const auto& [key, name] : {std::pair{"file-object", &face.object},
                                  {"file-group", &face.group},
                                  {"material", &face.material},
                                  {"model-file", &face.file}})
    if (!name->empty()) json[key] = *name;
  if (face.line > 0) json["face-line"] = face.line;
  return json;
}

void print_json(const VertexChain& chain, const VertexUses& uses) {
  Json json{
      {"object", chain.id.object},          {"name", chain.object_name},        {"vertex", chain.id.vertex},
      {"model", list(chain.model)},         {"to-world", rows(chain.to_world)}, {"world", list(chain.world)},
      {"to-camera", rows(chain.to_camera)}, {"camera", list(chain.camera)},     {"to-clip", rows(chain.to_clip)},
      {"clip", list(chain.clip)},           {"inside", chain.inside},           {"viewport", list(chain.viewport)},
      {"centred", list(chain.centred)},     {"canvas", list(chain.canvas)}};
  for (const PlaneDistance& plane : chain.planes) json["planes"][std::string(plane.plane)] = plane.distance;
  json["triangles-at-vertex"] = uses.count;
  json["triangles"] = Json::array();
  for (const CornerUse& use : uses.first) json["triangles"].push_back(use_json(use));
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

void print_vertex(const Document& document, const PixelStory& story, const VertexArguments& arguments, bool json) {
  const VertexChain chain = vertex_chain(document.scene, view_of(document), document.a.settings,
                                         picked_vertex(document, story, arguments.vertex), edits_of(arguments));
  const VertexUses uses = vertex_uses(document.scene, chain.id);
  if (json) return print_json(chain, uses);
  fmt::print("vertex {} of {} (object {})\n\n", chain.id.vertex, chain.object_name, chain.id.object);
  fmt::print("model        {}\n", vector_text(chain.model));
  print_matrix(chain.to_world);
  fmt::print("world        {}\n", vector_text(chain.world));
  print_matrix(chain.to_camera);
  fmt::print("camera       {}\n", vector_text(chain.camera));
  for (const PlaneDistance& plane : chain.planes)
    fmt::print("             {:>10} from the {}{}\n", number_text(plane.distance), plane.plane,
               plane.distance < 0 ? ": outside" : "");
  print_matrix(chain.to_clip);
  fmt::print("clip         ({}, {}, {}, {})\n", number_text(chain.clip.x), number_text(chain.clip.y),
             number_text(chain.clip.z), number_text(chain.clip.w));
  fmt::print("viewport     {}\n", vector_text(chain.viewport));
  fmt::print("from centre  {}\n", vector_text(chain.centred));
  fmt::print("canvas       {}\n", vector_text(chain.canvas));
  for (const CornerUse& use : uses.first) fmt::print("{}\n", use_text(use));
  if (uses.count > uses.first.size()) fmt::print("and {} more triangles\n", uses.count - uses.first.size());
}

}  // namespace ps::cli
