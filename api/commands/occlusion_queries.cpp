#include "api/commands/occlusion_queries.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace gouraud::api {
namespace {

// Whether names may be made and deleted.
bool may_change_names(Context& context, GLsizei n, const char* command) {
  if (context.state.current_query != 0) {
    context.record_error(GL_INVALID_OPERATION, command, "a query is active");
    return false;
  }
  if (n < 0) context.record_error(GL_INVALID_VALUE, command, "n is negative");
  return n >= 0;
}

bool is_target(Context& context, GLenum target, const char* command) {
  if (target == GL_SAMPLES_PASSED) return true;
  context.record_error(GL_INVALID_ENUM, command, "target is not SAMPLES_PASSED");
  return false;
}

template <class T>
void get_query_object(Context& context, GLuint id, GLenum pname, T* params, const char* command) {
  const SampleCount count = context.query_names.find(id);
  if (count == nullptr || id == context.state.current_query) {
    return context.record_error(GL_INVALID_OPERATION, command, "id is no query, or the active one");
  }
  switch (pname) {
    case GL_QUERY_RESULT: {
      context.finish_rendering();
      constexpr std::uint64_t most = std::numeric_limits<T>::max();
      *params = static_cast<T>(std::min(count->total(), most));
      break;
    }
    case GL_QUERY_RESULT_AVAILABLE:
      *params = GL_TRUE;
      break;
    default:
      context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
  }
}

}  // namespace

void GenQueries(Context& context, GLsizei n, GLuint* ids) {
  if (may_change_names(context, n, "glGenQueries")) context.query_names.generate(n, ids);
}

void DeleteQueries(Context& context, GLsizei n, const GLuint* ids) {
  if (!may_change_names(context, n, "glDeleteQueries")) return;
  for (GLsizei i = 0; i < n; ++i) context.query_names.remove(ids[i]);
}

GLboolean IsQuery(Context& context, GLuint id) {
  return context.query_names.find(id) != nullptr ? GL_TRUE : GL_FALSE;
}

// What is drawn between the two goes into the bins with the counter, which lives as long as they need it.
void BeginQuery(Context& context, GLenum target, GLuint id) {
  constexpr auto command = "glBeginQuery";
  if (!is_target(context, target, command)) return;
  if (id == 0) return context.record_error(GL_INVALID_OPERATION, command, "id is 0");
  if (context.state.current_query != 0) return context.record_error(GL_INVALID_OPERATION, command, "a query is active");
  context.flush_vertices();
  context.renderer().count_samples(context.query_names.begin(id));
  context.state.current_query = id;
  context.change(dirty_raster);
}

void EndQuery(Context& context, GLenum target) {
  constexpr auto command = "glEndQuery";
  if (!is_target(context, target, command)) return;
  if (context.state.current_query == 0) return context.record_error(GL_INVALID_OPERATION, command, "no query is active");
  context.flush_vertices();
  context.renderer().count_samples(nullptr);
  context.state.current_query = 0;
  context.change(dirty_raster);
}

void GetQueryiv(Context& context, GLenum target, GLenum pname, GLint* params) {
  constexpr auto command = "glGetQueryiv";
  if (!is_target(context, target, command)) return;
  switch (pname) {
    case GL_CURRENT_QUERY:
      *params = static_cast<GLint>(context.state.current_query);
      break;
    case GL_QUERY_COUNTER_BITS:
      *params = query_counter_bits;
      break;
    default:
      context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
  }
}

void GetQueryObjectiv(Context& context, GLuint id, GLenum pname, GLint* params) {
  get_query_object(context, id, pname, params, "glGetQueryObjectiv");
}

void GetQueryObjectuiv(Context& context, GLuint id, GLenum pname, GLuint* params) {
  get_query_object(context, id, pname, params, "glGetQueryObjectuiv");
}

}  // namespace gouraud::api
