// The OSMesa functions [osmesa.h]: they take a program's calls, check them, and leave the work to osmesa_context.
//
// No exception leaves them: a call that finds no memory fails like one that was refused.
#include <GL/gouraud.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string_view>

#include "api/osmesa/osmesa_context.h"
#include "api/registry/proc_address.h"

namespace {

using gouraud::api::ContextConfig;

thread_local osmesa_context* latest_context = nullptr;

// Null as well if this thread's current GL context has come from elsewhere since.
osmesa_context* current_osmesa_context() {
  osmesa_context* const context = latest_context;
  return context != nullptr && gouraud::api::current_context() == &context->gl ? context : nullptr;
}

void complain(const char* function, const char* what, int value) {
  std::fprintf(stderr, "gouraud: %s: %s 0x%x\n", function, what, static_cast<unsigned>(value));
}

OSMesaContext create(GLenum format, const ContextConfig& config, OSMesaContext share_with) {
  if (!gouraud::api::is_osmesa_format(format)) return nullptr;
  if (config.depth_bits < 0 || config.stencil_bits < 0 || config.accum_bits < 0) return nullptr;
  ContextConfig complete = config;
  complete.most_color_bits = gouraud::api::most_color_bits(format);
  try {
    return new osmesa_context(format, complete, share_with);
  } catch (const std::exception&) {
    return nullptr;
  }
}

// What an attribute list asks for; `known` is false if one of its attributes or values is not.
struct Request {
  GLenum format = OSMESA_RGBA;
  ContextConfig config{0, 0, 0};
  int profile = OSMESA_COMPAT_PROFILE;
  int major = 1, minor = 0;
  bool known = true;
};

Request parse(const int* attributes) {
  Request request;
  for (; attributes != nullptr && attributes[0] != 0; attributes += 2) {
    const int value = attributes[1];
    switch (attributes[0]) {
      case OSMESA_FORMAT:
        request.format = static_cast<GLenum>(value);
        break;
      case OSMESA_DEPTH_BITS:
        request.config.depth_bits = value;
        break;
      case OSMESA_STENCIL_BITS:
        request.config.stencil_bits = value;
        break;
      case OSMESA_ACCUM_BITS:
        request.config.accum_bits = value;
        break;
      case OSMESA_PROFILE:
        request.profile = value;
        break;
      case OSMESA_CONTEXT_MAJOR_VERSION:
        request.major = value;
        break;
      case OSMESA_CONTEXT_MINOR_VERSION:
        request.minor = value;
        break;
      default:
        complain("OSMesaCreateContextAttribs", "unknown attribute", attributes[0]);
        request.known = false;
        return request;
    }
  }
  return request;
}

struct NamedFunction {
  std::string_view name;
  OSMESAproc function;
};

#define OSMESA_FUNCTION(name)                    \
  NamedFunction {                                \
#name, reinterpret_cast < OSMESAproc>(&name) \
  }
const NamedFunction osmesa_functions[] = {
    OSMESA_FUNCTION(OSMesaColorClamp),           OSMESA_FUNCTION(OSMesaCreateContext),
    OSMESA_FUNCTION(OSMesaCreateContextAttribs), OSMESA_FUNCTION(OSMesaCreateContextExt),
    OSMESA_FUNCTION(OSMesaDestroyContext),       OSMESA_FUNCTION(OSMesaGetColorBuffer),
    OSMESA_FUNCTION(OSMesaGetCurrentContext),    OSMESA_FUNCTION(OSMesaGetDepthBuffer),
    OSMESA_FUNCTION(OSMesaGetIntegerv),          OSMESA_FUNCTION(OSMesaGetProcAddress),
    OSMESA_FUNCTION(OSMesaMakeCurrent),          OSMESA_FUNCTION(OSMesaPixelStore),
    OSMESA_FUNCTION(OSMesaPostprocess),          OSMESA_FUNCTION(gouraudMethodTable),
    OSMESA_FUNCTION(gouraudMethods),             OSMESA_FUNCTION(gouraudMethodsInUse),
};
#undef OSMESA_FUNCTION

// Writes what a query found to those of the program's places that are not null.
void give(const GLint (&values)[3], void* pointer, GLint* width, GLint* height, GLint* third, void** buffer) {
  if (width != nullptr) *width = values[0];
  if (height != nullptr) *height = values[1];
  if (third != nullptr) *third = values[2];
  if (buffer != nullptr) *buffer = pointer;
}

}  // namespace

OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext sharelist) {
  return create(format, {24, 8, 0}, sharelist);
}

OSMesaContext OSMesaCreateContextExt(GLenum format, GLint depthBits, GLint stencilBits, GLint accumBits,
                                     OSMesaContext sharelist) {
  return create(format, {depthBits, stencilBits, accumBits}, sharelist);
}

// choice: every version from 1.0 to 1.5 gives the same context, of version 1.5. The core profile begins after 1.5.
OSMesaContext OSMesaCreateContextAttribs(const int* attribList, OSMesaContext sharelist) {
  const Request request = parse(attribList);
  const bool version_exists = request.major == 1 && request.minor >= 0 && request.minor <= 5;
  if (!request.known || request.profile != OSMESA_COMPAT_PROFILE || !version_exists) return nullptr;
  return create(request.format, request.config, sharelist);
}

void OSMesaDestroyContext(OSMesaContext ctx) {
  if (latest_context == ctx) latest_context = nullptr;
  delete ctx;
}

GLboolean OSMesaMakeCurrent(OSMesaContext ctx, void* buffer, GLenum type, GLsizei width, GLsizei height) {
  try {
    if (ctx == nullptr && buffer == nullptr) {
      gouraud::api::make_current(nullptr);
      latest_context = nullptr;
      return GL_TRUE;
    }
    if (ctx == nullptr || buffer == nullptr) return GL_FALSE;
    if (!gouraud::api::packed_layout(ctx->format(), type)) {
      complain("OSMesaMakeCurrent", "the context's format cannot have type", static_cast<int>(type));
      return GL_FALSE;
    }
    if (!ctx->bind_buffer(buffer, type, width, height)) return GL_FALSE;
    if (gouraud::api::current_context() != &ctx->gl) gouraud::api::make_current(&ctx->gl);
    latest_context = ctx;
    return GL_TRUE;
  } catch (const std::exception&) {
    return GL_FALSE;
  }
}

OSMesaContext OSMesaGetCurrentContext(void) {
  return current_osmesa_context();
}

void OSMesaPixelStore(GLint pname, GLint value) {
  osmesa_context* const context = current_osmesa_context();
  if (context == nullptr) return;
  switch (pname) {
    case OSMESA_ROW_LENGTH:
      if (value >= 0) context->row_length_px = value;
      break;
    case OSMESA_Y_UP:
      context->y_up = value != 0;
      break;
    default:
      complain("OSMesaPixelStore", "unknown parameter", pname);
  }
}

void OSMesaGetIntegerv(GLint pname, GLint* value) {
  const osmesa_context* const context = current_osmesa_context();
  if (value == nullptr) return;
  const auto of_context = [context](auto get) { return context != nullptr ? static_cast<GLint>(get(*context)) : 0; };
  switch (pname) {
    case OSMESA_WIDTH:
      *value = of_context([](auto& c) { return c.width_px(); });
      break;
    case OSMESA_HEIGHT:
      *value = of_context([](auto& c) { return c.height_px(); });
      break;
    case OSMESA_FORMAT:
      *value = of_context([](auto& c) { return c.format(); });
      break;
    case OSMESA_TYPE:
      *value = of_context([](auto& c) { return c.type(); });
      break;
    case OSMESA_ROW_LENGTH:
      *value = of_context([](auto& c) { return c.row_length_px; });
      break;
    case OSMESA_Y_UP:
      *value = of_context([](auto& c) { return c.y_up; });
      break;
    case OSMESA_MAX_WIDTH:
    case OSMESA_MAX_HEIGHT:
      *value = gouraud::api::max_target_size_px;
      break;
    default:
      complain("OSMesaGetIntegerv", "unknown parameter", pname);
  }
}

GLboolean OSMesaGetDepthBuffer(OSMesaContext ctx, GLint* width, GLint* height, GLint* bytesPerValue, void** buffer) {
  osmesa_context::DepthSnapshot* snapshot = nullptr;
  try {
    if (ctx != nullptr) snapshot = ctx->depth_snapshot();
  } catch (const std::exception&) {
  }
  if (snapshot == nullptr) {
    give({0, 0, 0}, nullptr, width, height, bytesPerValue, buffer);
    return GL_FALSE;
  }
  give({snapshot->width_px, snapshot->height_px, snapshot->bytes_per_value}, snapshot->values.data(), width, height,
       bytesPerValue, buffer);
  return GL_TRUE;
}

GLboolean OSMesaGetColorBuffer(OSMesaContext ctx, GLint* width, GLint* height, GLint* format, void** buffer) {
  if (ctx == nullptr || ctx->pixels() == nullptr) {
    give({0, 0, 0}, nullptr, width, height, format, buffer);
    return GL_FALSE;
  }
  give({ctx->width_px(), ctx->height_px(), static_cast<GLint>(ctx->format())}, ctx->pixels(), width, height, format,
       buffer);
  return GL_TRUE;
}

OSMESAproc OSMesaGetProcAddress(const char* funcName) {
  if (funcName == nullptr) return nullptr;
  const std::string_view name = funcName;
  const auto* const found = std::find_if(std::begin(osmesa_functions), std::end(osmesa_functions),
                                         [name](const NamedFunction& function) { return function.name == name; });
  return found != std::end(osmesa_functions) ? found->function : gouraud::api::proc_address(funcName);
}

void OSMesaColorClamp([[maybe_unused]] GLboolean enable) {}

void OSMesaPostprocess([[maybe_unused]] OSMesaContext osmesa, [[maybe_unused]] const char* filter,
                       [[maybe_unused]] unsigned enable_value) {}
