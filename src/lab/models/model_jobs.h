// The loop over a frame's models that several threads share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/arena.h"
#include "base/function_ref.h"
#include "render/view/frame_context.h"

namespace temblor::lab {

// Calls body(i, arena) for each of `count` models, on several threads. A job has several models and one of
// the arenas, which is reset when the job begins.
inline void for_each_model(const render::FrameContext& context, std::size_t count,
                           std::vector<base::Arena>& io_arenas,
                           base::FunctionRef<void(std::size_t model, base::Arena& io_arena)> body) {
  constexpr std::size_t kJobsPerThread = 4;
  const std::size_t jobs = std::min(count, static_cast<std::size_t>(context.jobs.threads()) * kJobsPerThread);
  render::FrameArenas::grow(io_arenas, jobs);
  context.jobs.parallel_for(jobs, [&](std::size_t job) {
    io_arenas[job].reset();
    const std::size_t end = count * (job + 1) / jobs;
    for (std::size_t i = count * job / jobs; i < end; ++i) body(i, io_arenas[job]);
  });
}

}  // namespace temblor::lab
