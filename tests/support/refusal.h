#pragma once
#include <string>

#include "base/check.h"

namespace ps::test {

/// The words of the InputError that `act` ends with; empty where it ends without one.
template <class Act>
std::string refusal_of(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ps::test
