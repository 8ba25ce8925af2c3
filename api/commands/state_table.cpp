#include "api/commands/state_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gouraud::api {
namespace {

std::vector<StateRow> sorted_rows() {
  std::vector<StateRow> rows;
  for (const auto part : {vertex_state_rows(), vertex_array_rows(), fragment_state_rows(), implementation_rows(),
                          display_list_rows(), fog_rows(), raster_position_rows(), evaluator_rows(), pixel_rows(), texture_rows(),
                          render_mode_rows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  std::sort(rows.begin(), rows.end(), [](const StateRow& a, const StateRow& b) { return a.pname < b.pname; });
  return rows;
}

}  // namespace

std::span<const StateRow> state_rows() {
  static const std::vector<StateRow> rows = sorted_rows();
  return rows;
}

const StateRow* find_state_row(GLenum pname) {
  const std::span<const StateRow> rows = state_rows();
  const auto found = std::lower_bound(rows.begin(), rows.end(), pname,
                                      [](const StateRow& row, GLenum name) { return row.pname < name; });
  return found != rows.end() && found->pname == pname ? &*found : nullptr;
}

GLint to_integer(double value, ValueKind kind) {
  if (std::isnan(value)) return 0;
  if (kind == ValueKind::normalized) value = (4294967295.0 * value - 1.0) / 2.0;  // [GL1.5 Table 4.6]
  if (value >= 2147483647.0) return 2147483647;
  if (value <= -2147483648.0) return -2147483647 - 1;
  return static_cast<GLint>(std::floor(value + 0.5));  // whatever rounding mode the program has set
}

}  // namespace gouraud::api
