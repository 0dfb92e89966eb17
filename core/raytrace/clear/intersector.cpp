#include "raytrace/clear/intersector-inl.h"

namespace ps {

template class Intersector<float, Silent>;
template class Intersector<float, CountingRecorder>;
template class Intersector<float, PixelRecorder>;
template class Intersector<double, Silent>;
template class Intersector<double, CountingRecorder>;
template class Intersector<double, PixelRecorder>;

}  // namespace ps
