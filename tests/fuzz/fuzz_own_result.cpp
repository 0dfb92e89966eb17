#include "fuzz/libfuzzer.h"

PS_FUZZ("own-result")
