#include "scene/form_properties.h"

#include "scene/scene_draft.h"
#include "scene/scene_text.h"

namespace ps {
namespace {

using Values = SceneValues;
using Term = SceneTerm;
using Properties = std::vector<FormProperty>;

Properties properties(const Ball& ball) {
  return {{"center", scene_vec(ball.centre),
           [](Form& f, const Values& v, const Term& t) { std::get<Ball>(f).centre = v.vec3(t); }},
          {"radius", scene_number(ball.radius),
           [](Form& f, const Values& v, const Term& t) { std::get<Ball>(f).radius = v.positive(t); }}};
}

Properties properties(const Plane& plane) {
  return {{"point", scene_vec(plane.point),
           [](Form& f, const Values& v, const Term& t) { std::get<Plane>(f).point = v.vec3(t); }},
          {"normal", scene_vec(plane.normal),
           [](Form& f, const Values& v, const Term& t) { std::get<Plane>(f).normal = v.direction(t); }}};
}

void set_side(Form& form, const Values& values, const Term& term, Vec3d Rectangle::*side) {
  Rectangle changed = std::get<Rectangle>(form);
  changed.*side = values.side(term);
  if (!has_right_angle(changed)) values.fail(term, "a side perpendicular to the other one");
  form = changed;
}

Properties properties(const Rectangle& rectangle) {
  return {{"corner", scene_vec(rectangle.corner),
           [](Form& f, const Values& v, const Term& t) { std::get<Rectangle>(f).corner = v.vec3(t); }},
          {"side_a", scene_vec(rectangle.side_a),
           [](Form& f, const Values& v, const Term& t) { set_side(f, v, t, &Rectangle::side_a); }},
          {"side_b", scene_vec(rectangle.side_b),
           [](Form& f, const Values& v, const Term& t) { set_side(f, v, t, &Rectangle::side_b); }}};
}

Properties properties(const Brick& brick) {
  return {{"center", scene_vec(brick.centre),
           [](Form& f, const Values& v, const Term& t) { std::get<Brick>(f).centre = v.vec3(t); }},
          {"size", scene_vec(brick.size),
           [](Form& f, const Values& v, const Term& t) { std::get<Brick>(f).size = read_brick_size(v, t); }},
          {"rotation", scene_rotation(brick.rotation),
           [](Form& f, const Values& v, const Term& t) { std::get<Brick>(f).rotation = v.frame(t); },
           brick.rotation == Mat3d(1.0)}};
}

void set_end(Form& form, const Values& values, const Term& term, Vec3d Cylinder::*end) {
  Cylinder changed = std::get<Cylinder>(form);
  changed.*end = values.vec3(term);
  if (changed.from == changed.to) values.fail(term, "a point other than the cylinder's other end");
  form = changed;
}

Properties properties(const Cylinder& cylinder) {
  return {
      {"from", scene_vec(cylinder.from),
       [](Form& f, const Values& v, const Term& t) { set_end(f, v, t, &Cylinder::from); }},
      {"to", scene_vec(cylinder.to), [](Form& f, const Values& v, const Term& t) { set_end(f, v, t, &Cylinder::to); }},
      {"radius", scene_number(cylinder.radius),
       [](Form& f, const Values& v, const Term& t) { std::get<Cylinder>(f).radius = v.positive(t); }}};
}

}  // namespace

std::vector<FormProperty> form_properties(const Form& form) {
  return std::visit([](const auto& one) { return properties(one); }, form);
}

}  // namespace ps
