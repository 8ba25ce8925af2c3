// Which names of one kind of object are in use, as disjoint ranges: a program may ask for two billion names at once.
#pragma once

#include <map>

#include <GL/gl.h>

namespace gouraud::api {

class NameRanges {
 public:
  bool contains(GLuint name) const;
  /// The first of `count` (> 0) unused names above 0, side by side: right above the highest in use, else the lowest
  /// such gap; 0 if there is none.
  GLuint find_unused(GLuint count) const;
  /// Takes the names first..last. Throws std::bad_alloc, and nothing is changed. 0 < first <= last.
  void insert(GLuint first, GLuint last);
  /// Gives back those of first..last that are in use. Throws std::bad_alloc: only some may have been given back.
  void erase(GLuint first, GLuint last);

 private:
  std::map<GLuint, GLuint> last_of_;  // first name of a range -> its last
};

}  // namespace gouraud::api
