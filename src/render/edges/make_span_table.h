// The part of the scan that does not depend on how the visible spans are found: threads, deferred faces,
// tiles of large surfaces, and grouping by draw. The laboratory finds spans by other methods.
#pragma once

#include <span>

#include "base/function_ref.h"
#include "render/edges/scan_band.h"
#include "render/edges/span_table.h"

namespace temblor::render {

// Returns the spans of opaque surfaces in `rows`, in any order, with the first draw of their surface. They
// live in `arena`. Called for each band, by several threads at once.
using FindSpans = base::FunctionRef<std::span<const DrawSpan>(RowRange rows, base::Arena& arena)>;

// Makes the band of each range of rows from the spans that `find_spans` returns. Within a draw, spans keep
// their order.
SpanTable make_span_table(const FrameContext& context, const ViewFrame& view, const EdgeTable& table,
                          FindSpans find_spans);

}  // namespace temblor::render
