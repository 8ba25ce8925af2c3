#include "api/commands/rectangles.h"

#include "api/commands/begin_end.h"

namespace gouraud::api {

void Rectf(Context& context, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  if (!context.can_draw("glRect")) return;
  // choice: split as Mesa splits it, a quad; a flat one has the colour of the polygon's first vertex [GL1.5 Table 2.12].
  const bool flat = context.state.lighting.shade_model == GL_FLAT;
  context.begin_primitive(flat ? pipeline::PrimitiveMode::polygon : pipeline::PrimitiveMode::quads);
  Vertex4f(context, x1, y1, 0.0f, 1.0f);
  Vertex4f(context, x2, y1, 0.0f, 1.0f);
  Vertex4f(context, x2, y2, 0.0f, 1.0f);
  Vertex4f(context, x1, y2, 0.0f, 1.0f);
  context.end_primitive();
}

}  // namespace gouraud::api
