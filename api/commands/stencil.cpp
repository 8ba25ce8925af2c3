#include "api/commands/stencil.h"

namespace gouraud::api {
namespace {

bool is_func(GLenum func) {
  return func - GL_NEVER <= GL_ALWAYS - GL_NEVER;
}

bool is_op(GLenum op) {
  switch (op) {
    case GL_KEEP:
    case GL_ZERO:
    case GL_REPLACE:
    case GL_INCR:
    case GL_DECR:
    case GL_INVERT:
    case GL_INCR_WRAP:
    case GL_DECR_WRAP:
      return true;
    default:
      return false;
  }
}

// Changes the sides that the plain commands set.
template <class Change>
void change_active(Context& context, const Change& change) {
  StencilGroup& stencil = context.state.stencil;
  if (stencil.active_face == GL_FRONT) {
    change(stencil.front);
    change(stencil.separate_back);
  } else {
    change(stencil.two_side_back);
  }
  context.change(dirty_raster);
}

void set_ops(StencilSide& side, GLenum fail, GLenum depth_fail, GLenum depth_pass) {
  side.fail = fail;
  side.depth_fail = depth_fail;
  side.depth_pass = depth_pass;
}

void set_func(StencilSide& side, GLenum func, GLint reference, GLuint mask) {
  side.func = func;
  side.reference = reference;
  side.compare_mask = mask;
}

}  // namespace

void StencilFunc(Context& context, GLenum func, GLint ref, GLuint mask) {
  if (!is_func(func)) return context.record_error(GL_INVALID_ENUM, "glStencilFunc", "func is unknown");
  change_active(context, [=](StencilSide& side) { set_func(side, func, ref, mask); });
}

void StencilOp(Context& context, GLenum fail, GLenum zfail, GLenum zpass) {
  if (!is_op(fail) || !is_op(zfail) || !is_op(zpass)) {
    return context.record_error(GL_INVALID_ENUM, "glStencilOp", "an operation is unknown");
  }
  change_active(context, [=](StencilSide& side) { set_ops(side, fail, zfail, zpass); });
}

void StencilMask(Context& context, GLuint mask) {
  change_active(context, [=](StencilSide& side) { side.write_mask = mask; });
}

void ActiveStencilFaceEXT(Context& context, GLenum face) {
  if (face != GL_FRONT && face != GL_BACK) {
    return context.record_error(GL_INVALID_ENUM, "glActiveStencilFaceEXT", "face is neither FRONT nor BACK");
  }
  context.state.stencil.active_face = face;
}

void StencilFuncSeparateATI(Context& context, GLenum frontfunc, GLenum backfunc, GLint ref, GLuint mask) {
  if (!is_func(frontfunc) || !is_func(backfunc)) {
    return context.record_error(GL_INVALID_ENUM, "glStencilFuncSeparateATI", "a function is unknown");
  }
  set_func(context.state.stencil.front, frontfunc, ref, mask);
  set_func(context.state.stencil.separate_back, backfunc, ref, mask);
  context.change(dirty_raster);
}

void StencilOpSeparateATI(Context& context, GLenum face, GLenum sfail, GLenum dpfail, GLenum dppass) {
  constexpr auto command = "glStencilOpSeparateATI";
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK) {
    return context.record_error(GL_INVALID_ENUM, command, "face is unknown");
  }
  if (!is_op(sfail) || !is_op(dpfail) || !is_op(dppass)) {
    return context.record_error(GL_INVALID_ENUM, command, "an operation is unknown");
  }
  StencilGroup& stencil = context.state.stencil;
  if (face != GL_BACK) set_ops(stencil.front, sfail, dpfail, dppass);
  if (face != GL_FRONT) set_ops(stencil.separate_back, sfail, dpfail, dppass);
  context.change(dirty_raster);
}

}  // namespace gouraud::api
