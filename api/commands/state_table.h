// What glGet can ask for, as one table: a row a value [GL1.5 §6.2].
#pragma once

#include <array>
#include <span>

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// How a value converts to other types [GL1.5 §6.1.2]. `normalized` values map [-1, 1] to the range of integers.
enum class ValueKind { boolean, integer, real, normalized };

/// The most components that a value has, a matrix.
inline constexpr int max_components = 16;

/// A value being read: booleans are 0 or 1; integers and floats are exact in double.
struct StateValue {
  std::array<double, max_components> components{};
};

struct StateRow {
  GLenum pname;
  ValueKind kind;
  int count;  ///< components
  void (*read)(const Context& context, StateValue& value);
};

/// The row of `pname` or null.
const StateRow* find_state_row(GLenum pname);
/// All rows, sorted by pname.
std::span<const StateRow> state_rows();

/// The rows, one list a chapter; none has a pname of another.
std::span<const StateRow> vertex_state_rows();    // current values, matrices, viewport, lighting
std::span<const StateRow> fragment_state_rows();  // rasterization, tests, framebuffer control, pixel store, hints
std::span<const StateRow> vertex_array_rows();    // vertex arrays, buffer bindings, attribute stacks
std::span<const StateRow> texture_rows();           // bindings and limits of texturing
std::span<const StateRow> implementation_rows();  // limits and the target's properties
std::span<const StateRow> fog_rows();
std::span<const StateRow> display_list_rows();
std::span<const StateRow> raster_position_rows();
std::span<const StateRow> evaluator_rows();
std::span<const StateRow> pixel_rows();  // pixel transfer, maps, zoom
std::span<const StateRow> render_mode_rows();

/// `value` as an integer: rounded to nearest, or for normalized values by Table 4.6; the nearest integer if it is out
/// of range, 0 if NaN.
GLint to_integer(double value, ValueKind kind);

}  // namespace gouraud::api
