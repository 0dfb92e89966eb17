#pragma once
#include "options/simd_choice.h"
