// The page of graphics cards in the laboratory's book.
#pragma once

#include <filesystem>

#include "app/lab/card/card_figures.h"

namespace temblor::app {

// Writes card.html and its pictures into a folder that exists, of the first level. Without OpenGL, the page
// says why it has no figures. Errors: a file that cannot be written.
base::Status write_card_page(const std::filesystem::path& folder, const LabScenes& scenes,
                             const CardGrid& grid, const render::Settings& settings);

}  // namespace temblor::app
