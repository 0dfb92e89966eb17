#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "study/stored_form.h"

namespace ps {

/// All that makes the picture of a file: what is drawn, how, and how it was stored.
struct PictureRecipe {
  Scene scene;
  Settings settings;
  StoredForm form;
};

/// One thing that a picture may have too little of, too much of, or in another way than A.
struct MissingCandidate {
  std::string key;      ///< for scripts: "specular=off", "light.1=off", "stored=truncated"
  std::string words;    ///< behind the picture's name: "without highlights"
  std::string subject;  ///< what it changes; of one subject only one change at a time makes sense
  bool stored = false;  ///< it changes the finished picture alone, which is then not drawn again
  std::function<void(PictureRecipe&)> apply;
};

/// Every change that can be seen from the recipe: features off and on, values of options that show something else on
/// purpose, lights and objects left out, lights counted twice, the background, the sample's place, and how the levels
/// and rows were stored. The likeliest first: of two that make the same picture the first is named. No listing and no
/// planted bug is among them, so that no question of a lesson is answered.
std::vector<MissingCandidate> missing_candidates(const Scene& scene, const Settings& settings);

}  // namespace ps
