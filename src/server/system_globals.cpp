#include "server/system_globals.h"

#include "server/game/entity_fields.h"

namespace temblor::server {

// The CRC alone is not enough: a damaged or hostile file may carry the right one and still be too short.
base::Status check_system_definitions(const vm::Program& program) {
  const formats::Progs& progs = program.progs();
  if (progs.crc != formats::kQuakeProgsCrc)
    return base::error(base::ErrorCode::kUnsupported,
                       "compiled with other system definitions than Quake's: their number is {}, Quake's {}",
                       progs.crc, formats::kQuakeProgsCrc);
  if (progs.global_words.size() < kSystemGlobalWords || progs.entity_words < kSystemFieldWords)
    return base::error(base::ErrorCode::kUnsupported,
                       "{} words of globals and {} of an entity are fewer than Quake's {} and {}",
                       progs.global_words.size(), progs.entity_words, kSystemGlobalWords, kSystemFieldWords);
  return base::Ok{};
}

}  // namespace temblor::server
