#pragma once
#include "study/stability/closed_sphere.h"

namespace ps::test {

using stability::closed_sphere;
using stability::ClosedSphere;

}  // namespace ps::test
