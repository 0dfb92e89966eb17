#include "gui/panels/options/object_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "gui/input/key_hint.h"
#include "gui/panels/options/vector_field.h"
#include "gui/session/camera_moves.h"
#include "gui/session/gizmo.h"
#include "gui/session/scene_contents.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "render/story/names.h"
#include "scene/object_surface.h"
#include "scene/rotation.h"
#include "scene/scene_text.h"

namespace ps::gui {
namespace {

constexpr double farthest = 1000;  // world units from the origin that the fields reach
constexpr double largest_size = 1000, smallest_size = 0.001;

/// Edits of the picked object under one name in the history; a drag of a field is one step.
class ObjectEdits {
 public:
  ObjectEdits(Session& session, std::size_t object)
      : session_(session), object_(object), name_(object_name(session.scene(), static_cast<int>(object))) {}

  const std::string& name() const { return name_; }

  /// Sets one property after a field was edited.
  void set(const char* property, const std::string& words, const std::string& value, const Edit& edit) {
    if (edit.changed)
      session_.edit_property(fmt::format("{} of {}", words, name_),
                             {fmt::format("object.{}.{}", object_, property), value});
    if (edit.finished) session_.end_drag();
  }

 private:
  Session& session_;
  std::size_t object_;
  std::string name_;
};

void place_field(ObjectEdits& edits, const char* property, Vec3d value) {
  show_text("Position");
  const auto edit = vector_field("position", value, {.minimum = -farthest, .maximum = farthest},
                                 "World units along the world's x, y and z.");
  edits.set(property, "position", scene_vec(value), edit);
}

void size_field(ObjectEdits& edits, const char* property, const char* words, Vec3d value) {
  show_text(words);
  const auto edit = vector_field("size", value,
                                 {.minimum = smallest_size, .maximum = largest_size, .scale = OptionScale::logarithmic},
                                 "Along the object's own x, y and z.");
  edits.set(property, "size", scene_vec(value), edit);
}

void radius_field(ObjectEdits& edits, double radius) {
  show_text("Radius");
  const auto edit =
      number("radius", radius, {.minimum = smallest_size, .maximum = largest_size, .scale = OptionScale::logarithmic},
             {.tooltip = "World units."});
  edits.set("radius", "radius", scene_number(radius), edit);
}

/// Steps about each axis of the world: a rotation has no three angles of its own.
void turn_field(ObjectEdits& edits, const Mat3d& rotation) {
  constexpr double step = 5;  // degrees
  show_text("Turn by 5°");
  static constexpr std::array axes{Axis::x, Axis::y, Axis::z};
  static constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (const int sense : {-1, 1}) {
      same_line_if_room(button_width("+x"), i == 0 && sense < 0 ? -1 : px(2));
      const std::string words = fmt::format("{}{}", sense < 0 ? "−" : "+", names[i]);
      if (button(fmt::format("turn/{}{}", sense < 0 ? "minus-" : "plus-", names[i]), words, Emphasis::plain,
                 {.tooltip = "Turns the object about this axis of the world."}))
        edits.set("rotation", "rotation", scene_rotation(rotation_about(axes[i], sense * step) * rotation),
                  {.changed = true, .finished = true});
    }
}

void shape_fields(ObjectEdits& edits, const Object& object) {
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
    place_field(edits, "center", sphere->centre);
    radius_field(edits, sphere->radius);
  } else if (const auto* instance = std::get_if<Instance>(&object.shape)) {
    place_field(edits, "translation", instance->transform.translation);
    size_field(edits, "scale", "Scale", instance->transform.scale);
    turn_field(edits, instance->transform.rotation);
  } else if (const auto* solid = std::get_if<Solid>(&object.shape)) {
    if (const auto* ball = std::get_if<Ball>(&solid->form)) {
      place_field(edits, "center", ball->centre);
      radius_field(edits, ball->radius);
    } else if (const auto* brick = std::get_if<Brick>(&solid->form)) {
      place_field(edits, "center", brick->centre);
      size_field(edits, "size", "Size", brick->size);
      turn_field(edits, brick->rotation);
    } else if (const auto* plane = std::get_if<Plane>(&solid->form)) {
      place_field(edits, "point", plane->point);
    } else if (const auto* rectangle = std::get_if<Rectangle>(&solid->form)) {
      place_field(edits, "corner", rectangle->corner);
    } else if (const auto* cylinder = std::get_if<Cylinder>(&solid->form)) {
      radius_field(edits, cylinder->radius);
    }
  }
}

void material_field(ObjectEdits& edits, const char* property, const char* words, double value, const NumberRange& range,
                    std::string_view tooltip) {
  show_text(words);
  const auto edit = number(property, value, range, {.tooltip = tooltip});
  edits.set(property, words, scene_number(value), edit);
}

void texture_field(ObjectEdits& edits, const Scene& scene, const Material& material) {
  std::vector<std::string> names{"none"};
  for (std::size_t i = 0; i < scene.textures->size(); ++i) names.push_back(scene.textures->at(i).name);
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < names.size(); ++i) keys.push_back(i == 0 ? "none" : std::to_string(i - 1));
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < names.size(); ++i) choices.push_back({keys[i], names[i], ""});
  show_text("Texture");
  int index = material.texture + 1;
  const float width = ImGui::GetContentRegionAvail().x;
  if (drop_down("texture", choices, index, width,
                {.tooltip = "A picture of the scene on the surface. Drop a picture file on the object to add one."}))
    edits.set("texture", "texture", scene_name(texture_text(scene, index - 1)), {.changed = true, .finished = true});
}

void surface_fields(ObjectEdits& edits, const Scene& scene, std::size_t object) {
  const bool single = has_one_material(scene, object), textured = takes_texture(scene, object);
  if (!single && !textured) {
    show_paragraph("Its parts have materials of their own.");
    return;
  }
  const Material& material = object_material(scene, object);
  Vec3d colour = material.colour;
  show_text("Colour: red, green, blue");
  const auto edit = vector_field("color", colour, {.minimum = 0, .maximum = 1}, "Share of the light that it reflects.");
  edits.set("color", "color", scene_colour(colour), edit);
  if (textured) texture_field(edits, scene, material);
  if (!single) return;
  material_field(edits, "specular", "Specular exponent", material.specular.value_or(-1),
                 {.minimum = -1, .maximum = 1000, .integer = true},
                 "−1: matte. The larger, the smaller the highlight.");
  material_field(edits, "reflective", "Reflected light", material.reflective, {}, "Share of reflected light, 0 to 1.");
  material_field(edits, "transparency", "Transparency", material.transparency, {},
                 "Share of light that passes through, 0 to 1.");
  material_field(edits, "refraction_index", "Refraction index", material.refraction_index, {.minimum = 1, .maximum = 3},
                 "Of what is inside: 1 vacuum, 1.33 water, 1.5 glass.");
  if (material.height_map >= 0)
    material_field(edits, "relief_depth", "Relief depth", material.relief_depth, {},
                   "Depth of the height map's relief, in widths of its picture.");
}

/// Puts objects into the scene and takes the picked one out.
void contents_buttons(Session& session, PickedObject& picked) {
  const char* none = picked.index(session) ? "" : "No object is picked.";
  struct Deed {
    const char *name, *label, *action;
    std::string_view disabled;
    std::function<void()> run;
  };
  const std::array deeds{
      Deed{"add-sphere", "Add sphere", "object-add-sphere", "", [&] { add_object(session, picked, "sphere"); }},
      Deed{"add-box", "Add box", "object-add-box", "", [&] { add_object(session, picked, "box"); }},
      Deed{"duplicate", "Duplicate", "object-duplicate", none, [&] { duplicate_object(session, picked); }},
      Deed{"delete", "Delete", "object-delete", none, [&] { remove_object(session, picked); }}};
  for (const Deed& deed : deeds) {
    if (deed.name != deeds.front().name) same_line_if_room(button_width(deed.label), px(4));
    if (button(deed.name, deed.label, Emphasis::plain,
               {.tooltip = with_key("Undo takes it back.", deed.action), .disabled = deed.disabled}))
      deed.run();
  }
}

}  // namespace

void object_panel(Session& session, ObjectPanelState& state, PickedObject& picked, bool& gizmo) {
  auto index = picked.index(session);
  const std::string name = index ? object_name(session.scene(), static_cast<int>(*index)) : "none picked";
  const bool opened = section("object", "Object", state.open, name);
  if (state.come > 0) {
    --state.come;
    ImGui::SetScrollHereY(0);
  }
  if (!opened) return;
  const NameScope scope("object");
  if (button("before", "‹", Emphasis::plain, {.tooltip = "The object before it in the scene."}))
    picked.step(session, -1);
  ImGui::SameLine(0, px(2));
  if (button("next", "›", Emphasis::plain, {.tooltip = "The next object of the scene."})) picked.step(session, 1);
  ImGui::SameLine();
  if (button_on_off(
          "gizmo", "Gizmo", gizmo,
          {.tooltip = with_key("Arrows, rings and squares in the pictures and in SPACE that move, turn and scale it.",
                               "gizmo")}))
    gizmo = !gizmo;
  contents_buttons(session, picked);
  index = picked.index(session);
  if (!index) {
    show_paragraph("Click an object in a picture to change it.");
    return;
  }
  ObjectEdits edits(session, *index);
  value_text("name", edits.name());
  shape_fields(edits, session.scene().geometry->objects[*index]);
  surface_fields(edits, session.scene(), *index);
}

}  // namespace ps::gui
