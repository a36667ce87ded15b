#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/reference/integer.h"

/// The reference's own code, run on numbers that remember how they were made. What comes out is a
/// netlist of the reference, and the range that every value in it can have.
namespace ptm::testbench {

using reference::Value;

/// The least and the greatest value of a number.
struct Range {
  Value low = 0, high = 0;
  [[nodiscard]] bool constant() const { return low == high; }
  bool operator==(const Range&) const = default;
};

/// Bits of the two's complement that holds a range; of all values of so many bits.
[[nodiscard]] int signed_bits(Range range);
[[nodiscard]] Range signed_range(int bits);
[[nodiscard]] Range unsigned_range(int bits);

class Netlist;

/// An integer as the templates of model/reference take one: a constant, or a net of a netlist.
///
/// Ranges are those of interval arithmetic: no value lies outside of its range, but a range may be
/// wider than the values need, where operands depend on each other.
class Symbolic {
 public:
  Symbolic() = default;
  explicit Symbolic(Value constant) : range_{constant, constant} {}
  [[nodiscard]] Range range() const { return range_; }

 private:
  friend class Netlist;
  Symbolic(Netlist* owner, int net, int bits, Range range)
      : range_(range), owner_(owner), net_(net), bits_(bits) {}
  Range range_{};
  Netlist* owner_ = nullptr;  ///< none: a constant
  int net_ = -1;
  int bits_ = 0;  ///< of the net
};

/// A module in the making. Its symbols must not outlive it. A range beyond 62 bits throws
/// std::overflow_error, which no configuration within the stated ranges comes to.
class Netlist {
 public:
  Netlist() = default;
  Netlist(const Netlist&) = delete;
  Netlist& operator=(const Netlist&) = delete;

  struct Port {
    std::string name;
    Range range;
    int bits = 0;           ///< of an input; an output has signed_bits() of what the netlist knows
    bool is_signed = true;  ///< of an input; outputs are
    bool claimed = false;   ///< an output's range is claimed, not known
  };

  /// An input of so many bits. `range` says which of their values are meant; all, if left out.
  Symbolic input(const std::string& name, int bits, bool is_signed);
  Symbolic input(const std::string& name, int bits, bool is_signed, Range range);
  void output(const std::string& name, const Symbolic& value);
  /// An output that is claimed to stay within a range narrower than the one known of it.
  void output(const std::string& name, const Symbolic& value, Range claimed);

  [[nodiscard]] const std::vector<Port>& inputs() const { return inputs_; }
  [[nodiscard]] const std::vector<Port>& outputs() const { return outputs_; }
  /// The module in Verilog; every net is a signed number that its range fits.
  /// Its last output, `known`, is 1 while all products lie within their ranges: always, for inputs
  /// within theirs. A solver is told so, as it would have to find it out gate by gate.
  [[nodiscard]] std::string verilog(const std::string& module) const;

  static Symbolic add(const Symbolic& a, const Symbolic& b);
  static Symbolic subtract(const Symbolic& a, const Symbolic& b);
  static Symbolic multiply(const Symbolic& a, const Symbolic& b);
  static Symbolic shift_right(const Symbolic& x, const Symbolic& n);
  static Symbolic shift_left(const Symbolic& x, int n);
  static Symbolic half_of(const Symbolic& n);
  static Symbolic smaller(const Symbolic& a, const Symbolic& b);
  static Symbolic larger(const Symbolic& a, const Symbolic& b);
  static Symbolic differs(const Symbolic& a, const Symbolic& b);
  static Symbolic either(const Symbolic& a, const Symbolic& b);  ///< of flags
  /// `flag` is 0 or 1: `if_one` or `if_zero`.
  Symbolic select(const Symbolic& flag, const Symbolic& if_one, const Symbolic& if_zero);

 private:
  /// The net `expression` of as many bits or, if its range takes more, of those; or the constant,
  /// if the range leaves but one.
  static Symbolic make(Netlist* owner, Range range, const std::string& expression, int bits = 0);
  static Netlist* owner(const Symbolic& a, const Symbolic& b);
  [[nodiscard]] static std::string text(const Symbolic& symbol);

  std::vector<Port> inputs_, outputs_;
  std::string body_, known_ = "1'b1";
  int nets_ = 0;
};

// What model/reference/integer.h asks of an integer.
inline Symbolic operator+(const Symbolic& a, const Symbolic& b) { return Netlist::add(a, b); }
inline Symbolic operator+(const Symbolic& a, Value b) { return Netlist::add(a, Symbolic{b}); }
inline Symbolic operator-(const Symbolic& a, const Symbolic& b) { return Netlist::subtract(a, b); }
inline Symbolic operator*(const Symbolic& a, const Symbolic& b) { return Netlist::multiply(a, b); }
inline Symbolic shift_right(const Symbolic& x, const Symbolic& n) {
  return Netlist::shift_right(x, n);
}
inline Symbolic shift_right(const Symbolic& x, Value n) {
  return Netlist::shift_right(x, Symbolic{n});
}
inline Symbolic shift_left(const Symbolic& x, int n) { return Netlist::shift_left(x, n); }
inline Symbolic half_of(const Symbolic& n) { return Netlist::half_of(n); }
inline Symbolic smaller(const Symbolic& a, const Symbolic& b) { return Netlist::smaller(a, b); }
inline Symbolic larger(const Symbolic& a, const Symbolic& b) { return Netlist::larger(a, b); }
inline Symbolic differs(const Symbolic& a, const Symbolic& b) { return Netlist::differs(a, b); }
inline Symbolic either(const Symbolic& a, const Symbolic& b) { return Netlist::either(a, b); }

}  // namespace ptm::testbench
