// `temblor lab book`: measures all techniques and writes the laboratory's book.
#pragma once

#include <filesystem>

#include "app/lab/book/book_figures.h"

namespace temblor::app {

// The techniques of all chapters; the first is the engine.
std::vector<lab::Choice> list_book_techniques();

// Makes the folder if it does not exist, and writes index.html, a page for each chapter, the school,
// the space battle, the wire, and a picture for each technique, over those that are there. There must be at
// least one level, one scene of models, and freezes at the wire's plotted ping. Errors: a folder or file that
// cannot be written.
base::Status write_book(const std::filesystem::path& folder, std::span<const LabScenes> levels,
                        std::span<const LabScenes> model_scenes, const WireResults& wire,
                        const BookOptions& options);

// Numbers and distances of models.
std::vector<CrowdOptions> list_book_crowds();

}  // namespace temblor::app
