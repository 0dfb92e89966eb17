#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "base/check.h"

namespace ps {

/// As many faults of one input are reported at once.
inline constexpr std::size_t most_input_errors = 5;

/// Several faults of one input: an InputError about the first of them, which knows the others.
class InputErrors : public InputError {
 public:
  /// `all` is not empty; in the order in which they are to be read.
  explicit InputErrors(std::vector<InputError> all);
  const std::vector<InputError>& all() const noexcept { return all_; }

 private:
  std::vector<InputError> all_;
};

/// Reads on behind a fault, until there are enough of them.
class FaultGatherer {
 public:
  /// Calls `read` and keeps the fault that it ends with. Throws InputErrors with the last one that is reported.
  template <class Read>
  void gather(Read&& read) {
    try {
      read();
    } catch (const InputError& fault) {
      faults_.push_back(fault);
      if (faults_.size() == most_input_errors) throw_all();
    }
  }
  /// Throws InputErrors if there is a fault.
  void throw_all() {
    if (!faults_.empty()) throw InputErrors(std::move(faults_));
  }

 private:
  std::vector<InputError> faults_;
};

}  // namespace ps
