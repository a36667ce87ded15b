#pragma once
#include <map>
#include <vector>

#include "model/reference/integer.h"

namespace ptm::tests {

struct Operations {
  int multiplies = 0, adds = 0, subtracts = 0, shifts = 0, comparisons = 0;
};

/// Books every operation under the innermost step in whose scope it happens.
class OperationLog {
 public:
  static OperationLog& instance() {
    static OperationLog log;
    return log;
  }
  void clear() { booked_.clear(); }
  void enter(reference::Step step) { open_.push_back(step); }
  void leave() { open_.pop_back(); }
  Operations& current() { return booked_[open_.back()]; }
  [[nodiscard]] Operations of(reference::Step step) const {
    const auto found = booked_.find(step);
    return found == booked_.end() ? Operations{} : found->second;
  }

 private:
  std::map<reference::Step, Operations> booked_;
  std::vector<reference::Step> open_;
};

/// An integer that counts what the datapath does with it.
struct Counting {
  reference::Value value = 0;
  Counting() = default;
  explicit Counting(reference::Value v) : value(v) {}
};

inline Operations& booked() { return OperationLog::instance().current(); }

inline Counting operator*(Counting a, Counting b) {
  ++booked().multiplies;
  return Counting{a.value * b.value};
}
inline Counting operator+(Counting a, Counting b) {
  ++booked().adds;
  return Counting{a.value + b.value};
}
inline Counting operator-(Counting a, Counting b) {
  ++booked().subtracts;
  return Counting{a.value - b.value};
}
/// Adding a constant (the half of a rounding by a constant amount) is an adder too.
inline Counting operator+(Counting a, reference::Value b) { return a + Counting{b}; }
inline Counting shift_right(Counting x, Counting n) {
  ++booked().shifts;
  return Counting{x.value >> n.value};
}
/// By a constant: wires.
inline Counting shift_right(Counting x, reference::Value n) { return Counting{x.value >> n}; }
inline Counting shift_left(Counting x, int n) {
  return Counting{reference::shift_left(x.value, n)};
}
inline Counting half_of(Counting n) { return Counting{reference::half_of(n.value)}; }
inline Counting smaller(Counting a, Counting b) {
  ++booked().comparisons;
  return a.value < b.value ? a : b;
}
inline Counting larger(Counting a, Counting b) {
  ++booked().comparisons;
  return a.value < b.value ? b : a;
}
inline Counting differs(Counting a, Counting b) { return Counting{a.value != b.value ? 1 : 0}; }
inline Counting either(Counting a, Counting b) { return Counting{a.value | b.value}; }

template <class Table>
Counting look_up(const Table& table, Counting index) {
  return Counting{reference::look_up(table, index.value)};
}

}  // namespace ptm::tests

template <>
struct ptm::reference::StepScope<ptm::tests::Counting> {
  explicit StepScope(Step step) { tests::OperationLog::instance().enter(step); }
  ~StepScope() { tests::OperationLog::instance().leave(); }
  StepScope(const StepScope&) = delete;
  StepScope& operator=(const StepScope&) = delete;
};
