// Who is worth having: a contestant that another beats in both time and error is not.
#pragma once

#include <string>
#include <vector>

namespace gouraud::chart {

struct Point {
  std::string name;
  double time = 0;   ///< relative; positive
  double error = 0;  ///< not negative
};

/// What differences mean something. Times of a shared machine vary by some percent. An error of this much, in the mean,
/// is what rounding a float the other way at a tie makes.
struct Resolution {
  double time_share = 0.05, error = 1e-4;
};

/// `better` is faster and more accurate than `point`, both by more than the resolution.
bool beats(const Point& better, const Point& point, const Resolution& resolution = {});

/// Faster by more than the resolution and at most as wrong: nothing is lost by it here.
bool is_faster_and_as_accurate(const Point& better, const Point& point, const Resolution& resolution = {});

/// True for each point that no other beats or equals in error while it is faster: the strict front, sorted nowhere.
std::vector<bool> front(const std::vector<Point>& points);

/// Names of those who beat `point`.
std::vector<std::string> beaten_by(const Point& point, const std::vector<Point>& points, const Resolution& resolution = {});

}  // namespace gouraud::chart
