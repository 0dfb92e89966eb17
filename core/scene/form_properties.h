#pragma once
#include <string>
#include <vector>

#include "scene/scene_value.h"
#include "scene/solid.h"

namespace ps {

/// One number or vector of a form that can be changed.
struct FormProperty {
  const char* name;   ///< as in scene files: "radius"
  std::string value;  ///< as a scene file has it
  /// Throws InputError for a value that a scene file could not have. The form must be of the kind that was asked.
  void (*set)(Form&, const SceneValues&, const SceneTerm&);
  bool usual = false;  ///< the value that a scene file need not name
};

std::vector<FormProperty> form_properties(const Form& form);

}  // namespace ps
