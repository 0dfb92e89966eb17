#pragma once

namespace ps {

/// Whether write_file_atomically() has a temporary file now, which would be left behind if the program ended at once.
/// Signal handlers may call it.
bool has_temporary_files();

}  // namespace ps
