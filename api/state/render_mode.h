// Selection and feedback [GL1.5 §5.2, §5.3]: part of no attribute group.
#pragma once

#include <array>

#include <GL/gl.h>

#include "api/state/limits.h"

namespace gouraud::api {

/// Values written one after the other into memory of the application, as many as fit.
template <class T>
struct ReportBuffer {
  T* memory = nullptr;
  GLsizei size = 0;        ///< values
  bool specified = false;  ///< the application has given one, be it empty
  GLsizei count = 0;       ///< written since the mode was entered
  bool overflown = false;  ///< a value did not fit

  void put(T value) {
    if (count < size && memory != nullptr) {
      memory[count++] = value;
    } else {
      overflown = true;
    }
  }
  void restart() {
    count = 0;
    overflown = false;
  }
  bool operator==(const ReportBuffer&) const = default;
};

struct SelectionState {
  ReportBuffer<GLuint> buffer;
  GLint records = 0;
  std::array<GLuint, max_name_stack_depth> names{};
  int depth = 0;
  /// A primitive has hit the clip volume since the last record; where, in window depth.
  bool hit = false;
  float nearest = 1.0f, farthest = 0.0f;
  bool operator==(const SelectionState&) const = default;
};

struct FeedbackState {
  ReportBuffer<GLfloat> buffer;
  GLenum type = GL_2D;
  bool operator==(const FeedbackState&) const = default;
};

struct RenderModeState {
  GLenum mode = GL_RENDER;
  SelectionState selection;
  FeedbackState feedback;
  bool operator==(const RenderModeState&) const = default;
};

}  // namespace gouraud::api
