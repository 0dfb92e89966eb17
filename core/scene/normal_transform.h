#pragma once

namespace ps {

/// Which matrix takes normals from the model to the world: the inverse transpose of the model's, or that itself.
enum class NormalTransform { inverse_transpose, model };

}  // namespace ps
