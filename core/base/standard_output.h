#pragma once
#include <string>

namespace ps {

/// Puts something in the place of standard input, output and error where the program was started without them; else the
/// next file that it opens would be taken for them. Printing then fails; messages on standard error, which somebody did
/// not want, vanish. To be called first of all.
void open_standard_streams();

/// Throws InputError unless everything printed so far has reached the system: a full disk or a reader that has gone
/// shows itself only when the buffer is emptied. To be called once, after the last output.
void require_printed();

/// The message of that error; `error` is an errno, or 0 where the reason is unknown.
std::string unprinted_text(int error);

}  // namespace ps
