// The page of the wire in the laboratory's book.
#pragma once

#include <filesystem>

#include "app/lab/wire/wire_figures.h"
#include "base/result.h"

namespace temblor::app {

// Writes wire.html into a folder that exists. Errors: a file that cannot be written.
base::Status write_wire_page(const std::filesystem::path& folder, const WireResults& results);

}  // namespace temblor::app
