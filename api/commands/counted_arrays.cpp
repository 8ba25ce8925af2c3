#include "api/commands/counted_arrays.h"

#include "api/commands/vertex_arrays.h"

namespace gouraud::api {
namespace {

bool accepts(Context& context, GLsizei count, const char* command) {
  if (count < 0) context.record_error(GL_INVALID_VALUE, command, "count is negative");
  return count >= 0;
}

}  // namespace

void VertexPointerEXT(Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
  if (accepts(context, count, "glVertexPointerEXT")) VertexPointer(context, size, type, stride, pointer, count);
}

void NormalPointerEXT(Context& context, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
  if (accepts(context, count, "glNormalPointerEXT")) NormalPointer(context, type, stride, pointer, count);
}

void ColorPointerEXT(Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
  if (accepts(context, count, "glColorPointerEXT")) ColorPointer(context, size, type, stride, pointer, count);
}

void IndexPointerEXT(Context& context, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
  if (accepts(context, count, "glIndexPointerEXT")) IndexPointer(context, type, stride, pointer, count);
}

void TexCoordPointerEXT(Context& context, GLint size, GLenum type, GLsizei stride, GLsizei count, const void* pointer) {
  if (accepts(context, count, "glTexCoordPointerEXT")) TexCoordPointer(context, size, type, stride, pointer, count);
}

void EdgeFlagPointerEXT(Context& context, GLsizei stride, GLsizei count, const GLboolean* pointer) {
  if (accepts(context, count, "glEdgeFlagPointerEXT")) EdgeFlagPointer(context, stride, pointer, count);
}

}  // namespace gouraud::api
