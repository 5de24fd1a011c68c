// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ALIGNED_VECTOR_H
#define RODPACK_ALIGNED_VECTOR_H

#include <stdlib.h>

#include <cstddef>
#include <new>
#include <vector>

namespace rodpack {

/// Allocates at the start of cache lines; C++14's std::allocator ignores alignas.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <class U>
  CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(std::size_t count) {
    void* memory = nullptr;
    if (posix_memalign(&memory, 64, count * sizeof(T)) != 0) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { free(memory); }
  template <class U>
  bool operator==(const CacheLineAllocator<U>&) const {
    return true;
  }
  template <class U>
  bool operator!=(const CacheLineAllocator<U>&) const {
    return false;
  }
};

template <class T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace rodpack

#endif
