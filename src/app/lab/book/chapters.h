// The chapters of the laboratory's book, one source file each, and the sentences and verdicts that they
// share.
#pragma once

#include <string>

#include "app/lab/book/book_content.h"

namespace temblor::app {

BookChapter make_hidden_surfaces_chapter();
BookChapter make_visible_faces_chapter();
BookChapter make_world_light_chapter();
BookChapter make_perspective_chapter();
BookChapter make_models_chapter();

// Ratios of times below this say nothing.
constexpr double kSameTime = 1.1;

// "A frame takes 1.1 to 1.4 times the engine's."
std::string describe_time(const Evidence& evidence);
// Names the share of wrong faces.
std::string describe_wrong(const Evidence& evidence);

// For a technique that should draw the same picture in more time.
Verdict judge_slower(const Evidence& evidence);

}  // namespace temblor::app
