#include "testbench/prove/symbolic.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace ptm::testbench {
namespace {

__extension__ using Wide = __int128;

constexpr Wide kLimit = Wide{1} << 62;

Range checked(Wide low, Wide high) {
  if (low < -kLimit || high > kLimit) throw std::overflow_error("a value beyond 62 bits");
  return {static_cast<Value>(low), static_cast<Value>(high)};
}

Range of_corners(std::initializer_list<Wide> corners) {
  return checked(std::min(corners), std::max(corners));
}

std::string wire(int bits, const std::string& name) {
  return "wire signed [" + std::to_string(bits - 1) + ":0] " + name;
}

/// A literal of as many bits as it takes, in two's complement: a sign before a literal is an
/// operator, and would be applied at the width around it.
std::string literal(Value value) {
  const int bits = signed_bits({value, value});
  std::string digits;
  for (int bit = bits - 1; bit >= 0; --bit) digits += (value >> bit & 1) != 0 ? '1' : '0';
  return std::to_string(bits) + "'sb" + digits;
}

}  // namespace

int signed_bits(Range range) {
  const auto magnitude = [](Value v) { return static_cast<std::uint64_t>(v < 0 ? ~v : v); };
  return 1 +
         static_cast<int>(std::bit_width(std::max(magnitude(range.low), magnitude(range.high))));
}

Range signed_range(int bits) { return {-(Value{1} << (bits - 1)), (Value{1} << (bits - 1)) - 1}; }
Range unsigned_range(int bits) { return {0, (Value{1} << bits) - 1}; }

Netlist* Netlist::owner(const Symbolic& a, const Symbolic& b) {
  return a.owner_ != nullptr ? a.owner_ : b.owner_;
}

std::string Netlist::text(const Symbolic& symbol) {
  return symbol.range_.constant() ? literal(symbol.range_.low) : "n" + std::to_string(symbol.net_);
}

Symbolic Netlist::make(Netlist* owner, Range range, const std::string& expression, int bits) {
  if (range.constant()) return Symbolic{range.low};
  const int net = owner->nets_++;
  bits = std::max(bits, signed_bits(range));
  owner->body_ += "  " + wire(bits, "n" + std::to_string(net)) + " = " + expression + ";\n";
  return {owner, net, bits, range};
}

Symbolic Netlist::input(const std::string& name, int bits, bool is_signed) {
  return input(name, bits, is_signed, is_signed ? signed_range(bits) : unsigned_range(bits));
}

Symbolic Netlist::input(const std::string& name, int bits, bool is_signed, Range range) {
  inputs_.push_back({name, range, bits, is_signed});
  return make(this, range, is_signed ? name : "$signed({1'b0, " + name + "})",
              is_signed ? bits : bits + 1);
}

void Netlist::output(const std::string& name, const Symbolic& value) {
  output(name, value, value.range());
}

void Netlist::output(const std::string& name, const Symbolic& value, Range claimed) {
  outputs_.push_back(
      {name, claimed, signed_bits(value.range()), true, !(claimed == value.range())});
  body_ += "  assign " + name + " = " + text(value) + ";\n";
}

std::string Netlist::verilog(const std::string& module) const {
  std::string ports;
  for (const Port& port : inputs_) {
    ports += std::string("  input wire ") + (port.is_signed ? "signed [" : "[") +
             std::to_string(port.bits - 1) + ":0] " + port.name + ",\n";
  }
  for (const Port& port : outputs_) ports += "  output " + wire(port.bits, port.name) + ",\n";
  return "module " + module + " (\n" + ports + "  output wire known\n);\n" + body_ +
         "  assign known = " + known_ + ";\nendmodule\n";
}

Symbolic Netlist::add(const Symbolic& a, const Symbolic& b) {
  return make(owner(a, b),
              checked(Wide{a.range_.low} + b.range_.low, Wide{a.range_.high} + b.range_.high),
              text(a) + " + " + text(b));
}

Symbolic Netlist::subtract(const Symbolic& a, const Symbolic& b) {
  return make(owner(a, b),
              checked(Wide{a.range_.low} - b.range_.high, Wide{a.range_.high} - b.range_.low),
              text(a) + " - " + text(b));
}

Symbolic Netlist::multiply(const Symbolic& a, const Symbolic& b) {
  const Wide al = a.range_.low, ah = a.range_.high, bl = b.range_.low, bh = b.range_.high;
  // As wide as its operands together, as the RTL's is: two multipliers of one width are found to be
  // one, where the last bit alone would make a solver compare them gate by gate.
  const Symbolic product = make(owner(a, b), of_corners({al * bl, al * bh, ah * bl, ah * bh}),
                                text(a) + " * " + text(b), a.bits_ + b.bits_);
  if (product.owner_ != nullptr) {
    const std::string net = text(product);
    product.owner_->known_ += "\n    && " + net + " >= " + literal(product.range_.low) + " && " +
                              net + " <= " + literal(product.range_.high);
  }
  return product;
}

Symbolic Netlist::shift_right(const Symbolic& x, const Symbolic& n) {
  const Value least = n.range_.low, most = n.range_.high;
  if (least < 0 || most > 62) throw std::overflow_error("a shift by less than 0 or more than 62");
  const Wide low = x.range_.low, high = x.range_.high;
  return make(owner(x, n), of_corners({low >> least, low >> most, high >> least, high >> most}),
              text(x) + " >>> " + text(n));
}

Symbolic Netlist::shift_left(const Symbolic& x, int n) {
  if (n == 0) return x;
  const Wide unit = Wide{1} << n;
  return make(x.owner_, checked(x.range_.low * unit, x.range_.high * unit),
              text(x) + " <<< " + std::to_string(n));
}

Symbolic Netlist::half_of(const Symbolic& n) {
  if (n.range_.low < 0) throw std::overflow_error("half of a negative power of two");
  const Range unit = checked(Wide{1} << n.range_.low, Wide{1} << n.range_.high);
  return shift_right(make(n.owner_, unit, literal(1) + " <<< " + text(n)), Symbolic{1});
}

Symbolic Netlist::smaller(const Symbolic& a, const Symbolic& b) {
  const std::string left = text(a), right = text(b);
  return make(owner(a, b),
              {std::min(a.range_.low, b.range_.low), std::min(a.range_.high, b.range_.high)},
              left + " < " + right + " ? " + left + " : " + right);
}

Symbolic Netlist::larger(const Symbolic& a, const Symbolic& b) {
  const std::string left = text(a), right = text(b);
  return make(owner(a, b),
              {std::max(a.range_.low, b.range_.low), std::max(a.range_.high, b.range_.high)},
              left + " < " + right + " ? " + right + " : " + left);
}

Symbolic Netlist::differs(const Symbolic& a, const Symbolic& b) {
  if (a.range_.constant() && b.range_.constant()) {
    return Symbolic{a.range_.low == b.range_.low ? 0 : 1};
  }
  return make(owner(a, b), {0, 1}, text(a) + " != " + text(b) + " ? 2'sb01 : 2'sb00");
}

Symbolic Netlist::either(const Symbolic& a, const Symbolic& b) {
  return make(owner(a, b),
              {std::max(a.range_.low, b.range_.low), std::max(a.range_.high, b.range_.high)},
              text(a) + " | " + text(b));
}

Symbolic Netlist::select(const Symbolic& flag, const Symbolic& if_one, const Symbolic& if_zero) {
  return make(this,
              {std::min(if_one.range().low, if_zero.range().low),
               std::max(if_one.range().high, if_zero.range().high)},
              text(flag) + " != 1'sb0 ? " + text(if_one) + " : " + text(if_zero));
}

}  // namespace ptm::testbench
