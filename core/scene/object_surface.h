#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "scene/scene.h"

namespace ps {

/// The surface of one object of a scene, which it may share with others until it is changed.

/// Whether the object has one material alone that can be changed, and texture coordinates: spheres, solids, and models
/// whose triangles all have them. CSG objects have a material for each part.
bool takes_texture(const Scene& scene, std::size_t object);

/// Whether the object has one material alone, with or without texture coordinates.
bool has_one_material(const Scene& scene, std::size_t object);

/// The material of an object that takes a texture or has one material; of a model that has several, the first.
const Material& object_material(const Scene& scene, std::size_t object);

/// Changes the material of this object alone: where others have it, too, a copy takes its place. Without effect, also
/// on revisions, where no value changes. Only for objects as above.
void edit_object_material(Scene& scene, std::size_t object, const std::function<void(Material&)>& change);

/// "none", the name of a texture that was made by the program, or the path of its file.
std::string texture_text(const Scene& scene, int texture);
/// The index of the texture with that text; a file that the scene does not have yet is read and added. -1 for "none".
/// Throws InputError for a file that cannot be read.
int find_or_add_texture(Scene& scene, const std::string& text);

}  // namespace ps
