#pragma once

#include "engine/lesson.h"

namespace ps::test {

/// Expects of a lesson that it is one: five steps or more, each with text and a hint, three claims or more, settings
/// that can be shown, links that lead somewhere, and 3 to 30 minutes of a student's time.
void expect_complete(const Lesson& lesson);

}  // namespace ps::test
