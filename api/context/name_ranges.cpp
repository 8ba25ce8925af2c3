#include "api/context/name_ranges.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace gouraud::api {
namespace {

constexpr GLuint highest_name = std::numeric_limits<GLuint>::max();

}  // namespace

bool NameRanges::contains(GLuint name) const {
  const auto above = last_of_.upper_bound(name);
  return above != last_of_.begin() && std::prev(above)->second >= name;
}

GLuint NameRanges::find_unused(GLuint count) const {
  const GLuint highest = last_of_.empty() ? 0 : last_of_.rbegin()->second;
  if (highest_name - highest >= count) return highest + 1;
  GLuint below = 0;
  for (const auto& [first, last] : last_of_) {
    if (first - below - 1 >= count) return below + 1;
    below = last;
  }
  return 0;
}

void NameRanges::insert(GLuint first, GLuint last) {
  // Find the ranges that overlap or touch the new one.
  auto begin = last_of_.upper_bound(first);
  if (begin != last_of_.begin() && std::prev(begin)->second >= first - 1) --begin;
  auto end = begin;
  GLuint new_first = first, new_last = last;
  for (; end != last_of_.end() && (last == highest_name || end->first <= last + 1); ++end) {
    new_first = std::min(new_first, end->first);
    new_last = std::max(new_last, end->second);
  }
  // Replace them; what may throw comes first.
  if (begin != end) {
    auto kept = last_of_.extract(begin++);
    last_of_.erase(begin, end);
    kept.key() = new_first;
    kept.mapped() = new_last;
    last_of_.insert(std::move(kept));
  } else {
    last_of_.emplace(new_first, new_last);
  }
}

void NameRanges::erase(GLuint first, GLuint last) {
  auto range = last_of_.upper_bound(first);
  if (range != last_of_.begin() && std::prev(range)->second >= first) --range;
  while (range != last_of_.end() && range->first <= last) {
    const GLuint range_first = range->first, range_last = range->second;
    if (range_last > last) last_of_.emplace(last + 1, range_last);
    if (range_first < first) {
      range->second = first - 1;
      ++range;
    } else {
      range = last_of_.erase(range);
    }
  }
}

}  // namespace gouraud::api
