#include "fuzz/libfuzzer.h"

PS_FUZZ("bundle")
