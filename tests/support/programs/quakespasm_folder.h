// A base folder that QuakeSpasm (Debian's package quakespasm) plays from.
#pragma once

#include <filesystem>
#include <optional>

#include "support/programs/temporary_folder.h"

namespace temblor::test {

// Makes BASE/id1 below `folder` with links to the files of `data`/id1 and this program. QuakeSpasm takes
// loose files only where gfx/pop.lmp, a small picture, proves that the game is the registered one; what it
// compares that with lies in its own program, and is taken from there. Nothing where it is not installed, or
// has no such picture.
std::optional<std::filesystem::path> make_quakespasm_folder(const TemporaryFolder& folder,
                                                            const std::filesystem::path& data,
                                                            const std::filesystem::path& progs);

}  // namespace temblor::test
