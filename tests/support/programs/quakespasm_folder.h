// A base folder for QuakeSpasm (Debian's package quakespasm).
#pragma once

#include <filesystem>
#include <optional>

#include "support/programs/temporary_folder.h"

namespace temblor::test {

// Makes BASE/id1 below `folder`, with links to the files of `data`/id1 and this program. QuakeSpasm accepts
// loose files only if gfx/pop.lmp, a small picture, proves that the game is the registered version. It
// compares the picture with a copy in its own executable, so this function takes the copy from there. Returns
// nothing if QuakeSpasm is not installed or has no such picture.
std::optional<std::filesystem::path> make_quakespasm_folder(const TemporaryFolder& folder,
                                                            const std::filesystem::path& data,
                                                            const std::filesystem::path& progs);

}  // namespace temblor::test
