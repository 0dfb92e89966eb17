#include "raytrace/clear/tracer-inl.h"

namespace ps {

template class Tracer<float, Silent>;
template class Tracer<float, CountingRecorder>;
template class Tracer<float, PixelRecorder>;
template class Tracer<double, Silent>;
template class Tracer<double, CountingRecorder>;
template class Tracer<double, PixelRecorder>;

}  // namespace ps
