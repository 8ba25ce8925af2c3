#include "api/commands/bernstein.h"

namespace gouraud::api {
namespace {

// From degree `degree - 1` to `degree`, in place.
void raise(int degree, double t, double* weights) {
  const double s = 1.0 - t;
  weights[degree] = t * weights[degree - 1];
  for (int i = degree - 1; i > 0; --i) weights[i] = t * weights[i - 1] + s * weights[i];
  weights[0] *= s;
}

}  // namespace

void bernstein(int order, double t, double* weights, double* slopes) {
  const int degree = order - 1;
  weights[0] = 1.0;
  for (int d = 1; d < degree; ++d) raise(d, t, weights);
  if (slopes != nullptr) {  // the derivative of B_i^n is n (B_(i-1)^(n-1) - B_i^(n-1))
    slopes[0] = slopes[degree] = 0.0;
    for (int i = 0; i < degree; ++i) {
      slopes[i] -= degree * weights[i];
      slopes[i + 1] = degree * weights[i];
    }
  }
  if (degree > 0) raise(degree, t, weights);
}

}  // namespace gouraud::api
