#include "api/commands/blending.h"

#include "api/commands/clamped.h"

namespace gouraud::api {
namespace {

bool is_destination_factor(GLenum factor) {
  switch (factor) {
    case GL_ZERO:
    case GL_ONE:
    case GL_SRC_COLOR:
    case GL_ONE_MINUS_SRC_COLOR:
    case GL_DST_COLOR:
    case GL_ONE_MINUS_DST_COLOR:
    case GL_SRC_ALPHA:
    case GL_ONE_MINUS_SRC_ALPHA:
    case GL_DST_ALPHA:
    case GL_ONE_MINUS_DST_ALPHA:
    case GL_CONSTANT_COLOR:
    case GL_ONE_MINUS_CONSTANT_COLOR:
    case GL_CONSTANT_ALPHA:
    case GL_ONE_MINUS_CONSTANT_ALPHA:
      return true;
    default:
      return false;
  }
}

bool is_source_factor(GLenum factor) {
  return factor == GL_SRC_ALPHA_SATURATE || is_destination_factor(factor);
}

void set_factors(Context& context, const char* command, GLenum source_rgb, GLenum destination_rgb, GLenum source_alpha,
                 GLenum destination_alpha) {
  if (!is_source_factor(source_rgb) || !is_source_factor(source_alpha)) {
    return context.record_error(GL_INVALID_ENUM, command, "a source factor is unknown");
  }
  if (!is_destination_factor(destination_rgb) || !is_destination_factor(destination_alpha)) {
    return context.record_error(GL_INVALID_ENUM, command, "a destination factor is unknown");
  }
  Blending& blend = context.state.color_buffer.blend;
  blend.source_rgb = source_rgb;
  blend.destination_rgb = destination_rgb;
  blend.source_alpha = source_alpha;
  blend.destination_alpha = destination_alpha;
  context.change(dirty_raster);
}

bool is_equation(GLenum mode) {
  return mode == GL_FUNC_ADD || mode == GL_FUNC_SUBTRACT || mode == GL_FUNC_REVERSE_SUBTRACT || mode == GL_MIN || mode == GL_MAX;
}

void set_equations(Context& context, GLenum rgb, GLenum alpha) {
  context.state.color_buffer.blend.equation_rgb = rgb;
  context.state.color_buffer.blend.equation_alpha = alpha;
  context.change(dirty_raster);
}

}  // namespace

void AlphaFunc(Context& context, GLenum func, GLfloat ref) {
  if (func - GL_NEVER > GL_ALWAYS - GL_NEVER) {
    return context.record_error(GL_INVALID_ENUM, "glAlphaFunc", "func is unknown");
  }
  context.state.color_buffer.alpha_func = func;
  context.state.color_buffer.alpha_reference = clamped(ref);
  context.change(dirty_raster);
}

void BlendFunc(Context& context, GLenum sfactor, GLenum dfactor) {
  set_factors(context, "glBlendFunc", sfactor, dfactor, sfactor, dfactor);
}

void BlendFuncSeparate(Context& context, GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha, GLenum dfactorAlpha) {
  set_factors(context, "glBlendFuncSeparate", sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha);
}

void BlendEquation(Context& context, GLenum mode) {
  if (!is_equation(mode) && mode != GL_LOGIC_OP) {
    return context.record_error(GL_INVALID_ENUM, "glBlendEquation", "mode is unknown");
  }
  set_equations(context, mode, mode);
}

void BlendEquationSeparateEXT(Context& context, GLenum modeRGB, GLenum modeAlpha) {
  if (!is_equation(modeRGB) || !is_equation(modeAlpha)) {
    return context.record_error(GL_INVALID_ENUM, "glBlendEquationSeparateEXT", "a mode is unknown");
  }
  set_equations(context, modeRGB, modeAlpha);
}

void BlendColor(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  context.state.color_buffer.blend.constant = clamped(glm::vec4(red, green, blue, alpha));
  context.change(dirty_raster);
}

void LogicOp(Context& context, GLenum opcode) {
  if (opcode - GL_CLEAR > GL_SET - GL_CLEAR) {
    return context.record_error(GL_INVALID_ENUM, "glLogicOp", "opcode is unknown");
  }
  context.state.color_buffer.logic_op = opcode;
  context.change(dirty_raster);
}

}  // namespace gouraud::api
