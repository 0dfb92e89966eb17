#pragma once
#include <filesystem>

#include "frame/view.h"
#include "study/model/model_needs.h"

namespace ps {

/// Writes the reduced scene as a .scene file with its settings and this view, and beside it, named after it, an OBJ
/// file for each model and a PNG file for each texture that became smaller. What did not change stays a reference to
/// its own file. Throws InputError.
void save_reduced(const ModelNeeds& needs, const View& view, const std::filesystem::path& path);

/// Before and after side by side with their difference, a row for rays and one for fragments of each view. Throws
/// Cancelled.
Image<Rgb8> before_and_after(const ModelRequest& request, const ModelNeeds& needs, StudyControl& control);

/// A mesh as a Wavefront OBJ file whose material slots load_obj() finds in the same order.
std::string obj_text(const Mesh& mesh);

}  // namespace ps
