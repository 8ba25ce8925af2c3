// Sums that are not rounded until their value is asked for: where a line's far ends cancel, nothing of the visible part
// is lost. A product of two doubles is the sum of its rounded value and that value's error [T. J. Dekker 1971]; a sum
// is rounded as if its terms had been added exactly [Ogita, Rump and Oishi 2005, algorithm SumK with K = number of
// terms].
#pragma once

#include <vector>

namespace gouraud::oracle {

/// The sum of the terms, not yet added up. Exact unless a product under- or overflows double.
struct ExactSum {
  std::vector<double> terms;

  double value() const;
};

ExactSum operator-(const ExactSum& a);
ExactSum operator+(const ExactSum& a, const ExactSum& b);
ExactSum operator-(const ExactSum& a, const ExactSum& b);
ExactSum operator*(const ExactSum& a, const ExactSum& b);

}  // namespace gouraud::oracle
