// The page of the laboratory's school: its lessons with their pictures.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"

namespace temblor::app {

// Makes the folder if it does not exist, and writes school.html and a picture for each lesson. Errors: a
// folder or file that cannot be written.
base::Status write_school(const std::filesystem::path& folder);

// The lessons as lines of text.
std::string describe_lessons();

// Makes a folder for pages, if there is none.
base::Status make_page_folder(const std::filesystem::path& folder);

}  // namespace temblor::app
