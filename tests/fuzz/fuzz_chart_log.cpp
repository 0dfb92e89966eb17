#include "fuzz/libfuzzer.h"

PS_FUZZ("chart-log")
