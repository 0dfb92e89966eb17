#pragma once
#include <string>
#include <vector>

#include "engine/lesson.h"
#include "engine/question.h"
#include "textbook/listing_view.h"

/// Questions of AskKind::bug: A runs a listing in which one line is wrong, B the listing as it should be.

namespace ps {

/// Which bug A runs, and its line, found by comparing the two files. Throws InputError where A runs no listing with a
/// bug, and where its file differs from the listing in more or less than one line.
MeasuredAnswer find_bug(const LessonQuestion& question);

/// One point for the line that is wrong.
Judgement judge_line(const LessonQuestion& question, int line, const MeasuredAnswer& right);

/// Why the question is not a good one, as check_question() has it: the pictures do not differ as a whole or at the
/// picked pixel, B differs in other options too, the line is not shown.
std::string check_bug(const LessonQuestion& question, Progress& progress, std::string& found);

/// The bugs of the lesson's listing that no step asks about.
std::vector<std::string> bugs_without_step(const Lesson& lesson);

/// The function of A's listing that holds the wrong line, from the comment above it to its end.
std::vector<ListingLine> function_with_bug(const MeasuredAnswer& bug);

}  // namespace ps
