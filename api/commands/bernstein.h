// Bernstein polynomials [GL1.5 §5.1 eq 5.1].
#pragma once

namespace gouraud::api {

/// Writes B_i(t), i = 0 .. order - 1, of degree order - 1 to `weights`, and their derivatives to `slopes` unless null.
/// By the recurrence over the degree, B_i^n = t B_(i-1)^(n-1) + (1 - t) B_i^(n-1): for t in [0, 1] nothing is
/// subtracted, so that each weight has a relative error of at most about 3 `order` units of double's last place.
void bernstein(int order, double t, double* weights, double* slopes);

}  // namespace gouraud::api
