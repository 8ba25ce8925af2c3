#include "api/commands/matrices.h"

#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

// Applies `function` to the stack of the current matrix mode; its capacity is part of its type.
template <class Function>
auto with_current_stack(State& state, Function function) {
  switch (state.transform.matrix_mode) {
    case GL_PROJECTION:
      return function(state.matrices.projection);
    case GL_TEXTURE:
      return function(state.matrices.texture[static_cast<std::size_t>(state.texture.active_unit)]);
    default:
      return function(state.matrices.modelview);
  }
}

glm::mat4& current_matrix(State& state) {
  return *with_current_stack(state, [](auto& stack) { return &stack.top(); });
}

void matrix_changed(Context& context) {
  context.change(context.state.transform.matrix_mode == GL_TEXTURE ? dirty_texture_coordinates : dirty_transform);
}

void load(Context& context, const glm::mat4& matrix) {
  current_matrix(context.state) = matrix;
  matrix_changed(context);
}

void multiply(Context& context, const glm::mat4& matrix) {
  glm::mat4& current = current_matrix(context.state);
  current = product(current, matrix);
  matrix_changed(context);
}

glm::mat4 matrix_from(const GLfloat* m) {
  glm::mat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[i];
  return matrix;
}

float to_float(GLdouble value) {
  return static_cast<float>(value);
}

}  // namespace

void MatrixMode(Context& context, GLenum mode) {
  if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE) {
    return context.record_error(GL_INVALID_ENUM, "glMatrixMode", "mode is no matrix mode");
  }
  context.state.transform.matrix_mode = mode;
}

void ActiveTexture(Context& context, GLenum texture) {
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit >= static_cast<GLenum>(max_texture_units)) {
    return context.record_error(GL_INVALID_ENUM, "glActiveTexture", "no such texture unit");
  }
  context.state.texture.active_unit = static_cast<int>(unit);
}

void LoadIdentity(Context& context) {
  load(context, glm::mat4(1.0f));
}

void LoadMatrixf(Context& context, const GLfloat* m) {
  load(context, matrix_from(m));
}

void MultMatrixf(Context& context, const GLfloat* m) {
  multiply(context, matrix_from(m));
}

void Rotatef(Context& context, GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
  multiply(context, rotation(angle, glm::vec3(x, y, z)));
}

void Translatef(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  glm::mat4& m = current_matrix(context.state);
  m[3] = product(m, glm::vec4(x, y, z, 1.0f));
  matrix_changed(context);
}

void Scalef(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  glm::mat4& m = current_matrix(context.state);
  m[0] *= x;
  m[1] *= y;
  m[2] *= z;
  matrix_changed(context);
}

void Frustum(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
             GLdouble zFar) {
  if (zNear <= 0.0 || zFar <= 0.0 || left == right || bottom == top || zNear == zFar) {
    return context.record_error(GL_INVALID_VALUE, "glFrustum", "empty, or not in front of the eye");
  }
  multiply(context,
           frustum(to_float(left), to_float(right), to_float(bottom), to_float(top), to_float(zNear), to_float(zFar)));
}

void Ortho(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
           GLdouble zFar) {
  if (left == right || bottom == top || zNear == zFar) {
    return context.record_error(GL_INVALID_VALUE, "glOrtho", "empty");
  }
  multiply(context, orthographic(to_float(left), to_float(right), to_float(bottom), to_float(top), to_float(zNear),
                                 to_float(zFar)));
}

void PushMatrix(Context& context) {
  const bool pushed = with_current_stack(context.state, [](auto& stack) {
    if (stack.depth == static_cast<int>(stack.matrices.size())) return false;
    ++stack.depth;
    stack.top() = stack.matrices[static_cast<std::size_t>(stack.depth - 2)];
    return true;
  });
  if (!pushed) context.record_error(GL_STACK_OVERFLOW, "glPushMatrix", "the stack is full");
}

void PopMatrix(Context& context) {
  const bool popped = with_current_stack(context.state, [](auto& stack) {
    if (stack.depth == 1) return false;
    --stack.depth;
    return true;
  });
  if (!popped) return context.record_error(GL_STACK_UNDERFLOW, "glPopMatrix", "the stack has one matrix left");
  matrix_changed(context);
}

}  // namespace gouraud::api
