#include "conformance/oracle/exact_sum.h"

#include <cmath>

namespace gouraud::oracle {

double ExactSum::value() const {
  std::vector<double> rest = terms;
  for (std::size_t pass = 1; pass < rest.size(); ++pass) {
    for (std::size_t i = 1; i < rest.size(); ++i) {
      // sum + error = rest[i - 1] + rest[i], exactly.
      const double sum = rest[i - 1] + rest[i], part = sum - rest[i - 1];
      rest[i - 1] = (rest[i - 1] - (sum - part)) + (rest[i] - part);
      rest[i] = sum;
    }
  }
  double sum = 0;
  for (const double term : rest) sum += term;
  return sum;
}

ExactSum operator-(const ExactSum& a) {
  ExactSum out = a;
  for (double& term : out.terms) term = -term;
  return out;
}

ExactSum operator+(const ExactSum& a, const ExactSum& b) {
  ExactSum out = a;
  out.terms.insert(out.terms.end(), b.terms.begin(), b.terms.end());
  return out;
}

ExactSum operator-(const ExactSum& a, const ExactSum& b) {
  return a + -b;
}

ExactSum operator*(const ExactSum& a, const ExactSum& b) {
  ExactSum out;
  for (const double x : a.terms) {
    for (const double y : b.terms) {
      const double product = x * y;
      out.terms.push_back(product);
      if (const double error = std::fma(x, y, -product); error != 0) out.terms.push_back(error);
    }
  }
  return out;
}

}  // namespace gouraud::oracle
