#pragma once
#include <vector>

#include "base/check.h"

namespace ps {

/// Several faults of one input: an InputError about the first of them, which knows the others.
class InputErrors : public InputError {
 public:
  /// `all` is not empty; in the order in which they are to be read.
  explicit InputErrors(std::vector<InputError> all);
  const std::vector<InputError>& all() const noexcept { return all_; }

 private:
  std::vector<InputError> all_;
};

}  // namespace ps
