#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "study/model/model_needs.h"

namespace ps {

/// The one sentence that a person acts on, with the greatest saving first: "Three of twelve lights and the 4096 x 4096
/// texture 'bricks' can go: 71 % less work, 96 % fewer bytes, RMSE 0.4 of 255." Or that no part can go, and why.
std::string model_sentence(const ModelNeeds& needs);

/// "from one view" or "from 8 views": what the reduced scene holds for.
std::string views_words(std::size_t views);

/// The savings with the greatest first, by the larger of their shares of work and bytes.
std::vector<const ModelSaving*> greatest_first(const ModelNeeds& needs);

}  // namespace ps
