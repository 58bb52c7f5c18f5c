#pragma once

#include <unistd.h>

namespace stridegraph::tools {

/// An open file, closed at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }
  /// Closes it now; false when what was written could not be kept.
  bool close() {
    const int open = number_;
    number_ = -1;
    return open < 0 || ::close(open) == 0;
  }

 private:
  int number_;
};

}  // namespace stridegraph::tools
