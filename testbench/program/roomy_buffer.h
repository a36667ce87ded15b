#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>

namespace ptm::testbench {

/// Numbers that are written before they are read: resize() neither keeps nor clears them. Large
/// ones lie in pages of 2 MiB where the system grants such, so that touching them for the first
/// time costs one fault where it would cost 512.
template <class Number>
class RoomyBuffer {
 public:
  void resize(std::size_t size) {
    if (size > capacity_) {
      numbers_.reset();
      capacity_ = 0;
      numbers_.reset(allocate(size));
      capacity_ = size;
    }
    size_ = size;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<Number> all() { return {numbers_.get(), size_}; }
  [[nodiscard]] std::span<Number> part(std::size_t first, std::size_t count) {
    return all().subspan(first, count);
  }

 private:
  struct Free {
    void operator()(Number* numbers) const { std::free(numbers); }
  };

  static Number* allocate(std::size_t size) {
    constexpr std::size_t kPage = std::size_t{1} << 21;
    const std::size_t bytes = (size * sizeof(Number) + kPage - 1) / kPage * kPage;
    void* room = std::aligned_alloc(kPage, bytes);
    if (room == nullptr) throw std::bad_alloc();
    madvise(room, bytes, MADV_HUGEPAGE);  // advice only: without it all works, slower
    return static_cast<Number*>(room);
  }

  std::unique_ptr<Number[], Free> numbers_;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace ptm::testbench
