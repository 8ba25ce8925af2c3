#include "api/commands/queries.h"

#include <string>

#include "api/commands/enables.h"
#include "api/commands/state_table.h"
#include "pipeline/simd/dispatch.h"

#include "extension_names.h"

namespace gouraud::api {
namespace {

// A capability may be asked for with any Get as well as with IsEnabled [GL1.5 §6.1.1].
template <class T, class Convert>
void get(Context& context, GLenum pname, T* data, const char* command, Convert convert) {
  if (const StateRow* const row = find_state_row(pname)) {
    StateValue value;
    row->read(context, value);
    for (int i = 0; i < row->count; ++i) data[i] = convert(value.components[static_cast<std::size_t>(i)], row->kind);
    return;
  }
  const Capability capability = find_capability(context.state, pname);
  if (capability.flag == nullptr) return context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
  data[0] = convert(*capability.flag ? 1.0 : 0.0, ValueKind::boolean);
}

const std::string& renderer_name() {
  static const std::string name =
      "Gouraud software (" + std::string(pipeline::simd::target_name(pipeline::simd::chosen_target())) + ")";
  return name;
}

}  // namespace

GLenum GetError(Context& context) {
  return context.take_error();
}

const GLubyte* GetString(Context& context, GLenum name) {
  const char* text = nullptr;
  switch (name) {
    case GL_VENDOR:
      text = "Gouraud";
      break;
    case GL_RENDERER:
      text = renderer_name().c_str();
      break;
    case GL_VERSION:
      text = "1.5 Gouraud 0.1.0";
      break;
    case GL_EXTENSIONS:
      text = extension_names;
      break;
    default:
      context.record_error(GL_INVALID_ENUM, "glGetString", "name is unknown");
      break;
  }
  return reinterpret_cast<const GLubyte*>(text);
}

const GLubyte* GetStringi(Context& context, GLenum name, GLuint index) {
  if (name != GL_EXTENSIONS) {
    context.record_error(GL_INVALID_ENUM, "glGetStringi", "name is unknown");
    return nullptr;
  }
  if (index >= extension_count) {
    context.record_error(GL_INVALID_VALUE, "glGetStringi", "index is not below GL_NUM_EXTENSIONS");
    return nullptr;
  }
  return reinterpret_cast<const GLubyte*>(extension_list[index]);
}

void GetBooleanv(Context& context, GLenum pname, GLboolean* data) {
  get(context, pname, data, "glGetBooleanv",
      [](double value, ValueKind) { return static_cast<GLboolean>(value != 0.0 ? GL_TRUE : GL_FALSE); });
}

void GetIntegerv(Context& context, GLenum pname, GLint* data) {
  get(context, pname, data, "glGetIntegerv", to_integer);
}

void GetInteger64v(Context& context, GLenum pname, GLint64* data) {
  get(context, pname, data, "glGetInteger64v", [](double value, ValueKind kind) { return GLint64{to_integer(value, kind)}; });
}

void GetFloatv(Context& context, GLenum pname, GLfloat* data) {
  get(context, pname, data, "glGetFloatv", [](double value, ValueKind) { return static_cast<GLfloat>(value); });
}

void GetDoublev(Context& context, GLenum pname, GLdouble* data) {
  get(context, pname, data, "glGetDoublev", [](double value, ValueKind) { return value; });
}

}  // namespace gouraud::api
