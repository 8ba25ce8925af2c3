// Gouraud's own functions [GL/gouraud.h]: which methods the current context draws with.
#include <GL/gouraud.h>

#include <exception>
#include <new>
#include <optional>
#include <string>

#include "api/context/context.h"
#include "pipeline/draw/methods.h"

GLboolean gouraudMethods(const char* methods) {
  gouraud::api::Context* const context = gouraud::api::current_context();
  if (context == nullptr) return GL_FALSE;
  if (context->inside_begin_end()) {
    context->record_error(GL_INVALID_OPERATION, "gouraudMethods", "between glBegin and glEnd");
    return GL_FALSE;
  }
  try {
    std::string error;
    const std::optional<gouraud::pipeline::Methods> parsed =
        gouraud::pipeline::parse_methods(methods != nullptr ? methods : "", error);
    if (parsed) context->set_methods(*parsed);
    else context->record_error(GL_INVALID_VALUE, "gouraudMethods", error.c_str());
    return parsed ? GL_TRUE : GL_FALSE;
  } catch (const std::exception&) {
    context->record_error(GL_OUT_OF_MEMORY, "gouraudMethods", "no memory");
    return GL_FALSE;
  }
}

const char* gouraudMethodsInUse(void) {
  thread_local std::string text;
  try {
    const gouraud::api::Context* const context = gouraud::api::current_context();
    text = context != nullptr ? describe(context->methods()) : "";
    return text.c_str();
  } catch (const std::bad_alloc&) {
    return "";
  }
}

const char* gouraudMethodTable(void) {
  try {
    static const std::string table = [] {
      std::string text;
      for (const gouraud::pipeline::MethodRow& row : gouraud::pipeline::method_rows()) {
        text.append(row.step).append("\t").append(row.name).append("\t").append(row.line).append("\t").append(row.source).append("\n");
      }
      return text;
    }();
    return table.c_str();
  } catch (const std::bad_alloc&) {
    return "";
  }
}
