#include "api/commands/begin_end.h"

#include "api/snapshot/enums.h"

namespace gouraud::api {

void Begin(Context& context, GLenum mode) {
  if (mode > GL_POLYGON) return context.record_error(GL_INVALID_ENUM, "glBegin", "mode is no primitive mode");
  if (!context.can_draw("glBegin")) return;
  context.begin_primitive(primitive_mode(mode));
}

void End(Context& context) {
  if (!context.inside_begin_end()) return context.record_error(GL_INVALID_OPERATION, "glEnd", "without glBegin");
  context.end_primitive();
}

}  // namespace gouraud::api
