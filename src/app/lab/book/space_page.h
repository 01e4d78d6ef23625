// The page of the space battle in the laboratory's book.
#pragma once

#include <filesystem>

#include "app/commands/options.h"
#include "base/result.h"

namespace temblor::app {

// Writes space.html and its pictures into a folder that exists. The cost is measured at `size`, in about 5
// seconds. Errors: a file that cannot be written.
base::Status write_space_page(const std::filesystem::path& folder, const FrameSize& size);

}  // namespace temblor::app
