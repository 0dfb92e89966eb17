#pragma once
#include <string>
#include <string_view>

namespace ps::test {

/// What keeps a page of HTML or MathML from being well-formed XML, with its byte; empty where nothing does. Enough of
/// XML for what we write: a declaration of the kind of document, balanced tags, quoted attributes, known entities, no
/// bare signs; and the number of children of the elements of MathML that need a fixed one.
std::string markup_fault(std::string_view text);

}  // namespace ps::test
