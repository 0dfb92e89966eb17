#pragma once

namespace ps {

/// Gives pages of the heap back to the system that nothing lies in. The C library does so by itself only at the heap's
/// end. Takes some milliseconds; for when much was freed between what stays.
void return_free_memory();

}  // namespace ps
