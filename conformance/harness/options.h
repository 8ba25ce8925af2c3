// The words behind a program's name: options, some of which have a value.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gouraud::conformance {

/// while (words.next()) { if (words.option() == "--out") out = words.value(); else words.refuse(usage); }
class OptionWords {
 public:
  explicit OptionWords(std::span<char*> words) : words_(words) {}

  bool next() { return at_++ < words_.size(); }
  std::string_view option() const { return words_[at_ - 1]; }
  /// The word behind it. Throws std::runtime_error if there is none.
  std::string value() {
    if (at_ == words_.size()) throw std::runtime_error(std::string(option()) + " needs a value");
    return words_[at_++];
  }
  [[noreturn]] void refuse(std::string_view usage) const {
    throw std::runtime_error(std::string(option()) + " is no option\n" + std::string(usage));
  }

 private:
  std::span<char*> words_;
  std::size_t at_ = 0;
};

}  // namespace gouraud::conformance
