// The memory that drawing a model reads and writes for its vertices, from a list of transformed vertices, as
// the engine's stages do, and from a stack. Pixels, depths, and skins are left out: both touch the same ones.
//
//   list:   poses -> 16 bytes by vertex;   triangle: 3 numbers -> 3 vertices, and 3 texels if it faces front
//   stack:  push: poses, texel -> 24 bytes in the stack;   draw: 3 places -> 3 entries
#pragma once

#include "base/function_ref.h"
#include "lab/models/stack/stack_mesh.h"
#include "lab/technique.h"

namespace temblor::lab {

// Receives the address and the bytes of each access. Addresses are those of arrays that follow one another,
// so they are the same on every machine.
using UseMemory = base::FunctionRef<void(std::uint64_t address, std::size_t bytes)>;

// Front faces are those that the first pose shows along its x axis.
void trace_vertex_list(const render::AliasModel& model, UseMemory use);
void trace_stack(const render::AliasModel& model, const StackMesh& mesh, UseMemory use);

// For one instance, with empty caches.
Counts count_vertex_work(const render::AliasModel& model, const StackMesh& mesh);

}  // namespace temblor::lab
