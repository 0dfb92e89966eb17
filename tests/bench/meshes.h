#pragma once
#include <memory>
#include <string>

#include "frame/view.h"
#include "scene/scene.h"

namespace ps::bench {

/// The meshes that benches are named after: "teapot" (6,320 triangles), "200k" (a torus knot of 200,000) and "1M" (a
/// displaced sphere of 1,002,252).
std::shared_ptr<const Mesh> bench_mesh(const std::string& name);

/// A displaced sphere of about `triangles` triangles, for curves.
std::shared_ptr<const Mesh> sphere_of(int triangles);

/// A scene with this mesh alone: one matte or shiny material, an ambient light and a point light.
Scene mesh_scene(std::shared_ptr<const Mesh> mesh);

/// A camera that looks at the mesh from the right and above, with the mesh filling the picture to its edges.
View framed_view(const Mesh& mesh, int width, int height);

}  // namespace ps::bench
