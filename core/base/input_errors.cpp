#include "base/input_errors.h"

#include <utility>

namespace ps {

InputErrors::InputErrors(std::vector<InputError> all) : InputError(all.front()), all_(std::move(all)) {}

}  // namespace ps
