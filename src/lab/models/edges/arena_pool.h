// Arenas that threads borrow for a band.
#pragma once

#include <mutex>
#include <vector>

#include "base/arena.h"

namespace temblor::lab {

class ArenaPool {
 public:
  base::Arena take() {
    const std::lock_guard lock(mutex_);
    if (arenas_.empty()) return {};
    base::Arena arena = std::move(arenas_.back());
    arenas_.pop_back();
    return arena;
  }
  void give_back(base::Arena arena) {
    arena.reset();
    const std::lock_guard lock(mutex_);
    arenas_.push_back(std::move(arena));
  }

 private:
  std::mutex mutex_;
  std::vector<base::Arena> arenas_;
};

}  // namespace temblor::lab
