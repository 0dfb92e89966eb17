#include "textbook/book_math.h"

#include <stdexcept>
#include <string>

namespace ps {

void throw_no_entry(std::size_t size) {
  throw std::out_of_range("an entry was asked for that a list of " + std::to_string(size) + " values does not have");
}

}  // namespace ps
