#include "testbench/prove/evaluator_claims.h"

#include <algorithm>
#include <string>

#include "model/reference/evaluate.h"
#include "model/reference/lerp.h"

namespace ptm::testbench {
namespace {

using reference::EvalConfig;
using reference::EvalWidths;
using reference::for_six;
using reference::Six;
using reference::Three;
using Names = std::vector<std::string>;

/// Parameters of one module, out of those of the evaluator.
std::vector<std::pair<std::string, int>> some_parameters(const EvalConfig& config,
                                                         std::initializer_list<const char*> names) {
  std::vector<std::pair<std::string, int>> some;
  for (const auto& [name, value] : reference::rtl_parameters(config)) {
    if (std::find(names.begin(), names.end(), name) != names.end()) some.emplace_back(name, value);
  }
  return some;
}

std::string numbered(const char* name, unsigned i) { return name + std::to_string(i); }

/// {name(count-1), ..., name0}: as a packed port takes them, the first lowest.
Names packed(const char* name, unsigned count) {
  Names names;
  for (unsigned i = count; i-- > 0;) names.push_back(numbered(name, i));
  return names;
}

Range symmetric(int power) { return {-(Value{1} << power), Value{1} << power}; }

/// Adds the claims step by step; each step's inputs have the ranges of the outputs before it.
class EvaluatorClaims {
 public:
  explicit EvaluatorClaims(const EvalConfig& config)
      : config_(config), width_(reference::widths(config)) {}

  std::vector<std::unique_ptr<Claim>> make() {
    unpack();
    basis();
    products();
    align();
    sum();
    luminance();
    color_products();
    color_scale();
    return std::move(claims_);
  }

 private:
  Claim& add(const char* name) {
    claims_.push_back(std::make_unique<Claim>());
    Claim& claim = *claims_.back();
    claim.name = name;
    claim.module = std::string("ptm_evaluator_") + name;
    return claim;
  }

  /// What a step before has as its output `name`.
  Symbolic take(Claim& claim, const std::string& name, int bits, bool is_signed = true) {
    for (const auto& before : claims_) {
      for (const Netlist::Port& port : before->netlist.outputs()) {
        if (port.name == name)
          return claim.netlist.input(name + "_in", bits, is_signed, port.range);
      }
    }
    throw std::logic_error("no step makes " + name);
  }

  Six<Symbolic> take_six(Claim& claim, const char* name, const std::array<int, 6>& bits) {
    return for_six([&](unsigned i) { return take(claim, numbered(name, i), bits[i]); });
  }

  void give(Claim& claim, const std::string& name, const Symbolic& value, int bits,
            bool is_signed = true) {
    give(claim, name, value, bits, is_signed, value.range());
  }
  void give(Claim& claim, const std::string& name, const Symbolic& value, int bits, bool is_signed,
            Range claimed) {
    claim.netlist.output(name, value, claimed);
    claim.outputs.push_back({name + "_o", 0, bits, is_signed, name});
  }

  static void connect(Claim& claim, const std::string& name) {
    claim.inputs.push_back({name + "_i", {name + "_in"}});
  }
  static void connect_six(Claim& claim, const char* name) {
    for (unsigned i = 0; i < 6; ++i) connect(claim, numbered(name, i));
  }

  void unpack() {
    Claim& claim = add("unpack");
    claim.parameters = some_parameters(config_, {"CoefBits", "DeltaBits", "FilterFrac"});
    const auto coef = for_six(
        [&](unsigned i) { return claim.netlist.input(numbered("coef", i), width_.stored, false); });
    const auto bias = for_six([&](unsigned i) {
      return claim.netlist.input(numbered("bias", i), config_.coef_bits, false);
    });
    claim.inputs = {{"coef_i", packed("coef", 6)}, {"bias_i", packed("bias", 6)}};
    const auto d = reference::unpack(config_, coef, bias);
    for (unsigned i = 0; i < 6; ++i) give(claim, numbered("d", i), d[i], width_.delta);
  }

  void basis() {
    Claim& claim = add("basis");
    claim.parameters =
        some_parameters(config_, {"LightInt", "LightFrac", "BasisFrac", "RoundNearest"});
    const Symbolic lu = claim.netlist.input("lu", width_.light, true);
    const Symbolic lv = claim.netlist.input("lv", width_.light, true);
    claim.inputs = {{"lu_i", {"lu"}}, {"lv_i", {"lv"}}};
    const auto b = reference::basis(config_, lu, lv);
    give(claim, "uu", b.uu, width_.basis);
    give(claim, "vv", b.vv, width_.basis);
    give(claim, "uv", b.uv, width_.basis);
  }

  void products() {
    Claim& claim = add("products");
    claim.parameters = {
        {"DeltaW", width_.delta}, {"LightW", width_.light}, {"BasisW", width_.basis}};
    std::array<int, 6> bits{};
    bits.fill(width_.delta);
    const auto d = take_six(claim, "d", bits);
    const reference::Basis<Symbolic> b{take(claim, "uu", width_.basis),
                                       take(claim, "vv", width_.basis),
                                       take(claim, "uv", width_.basis)};
    const Symbolic lu = claim.netlist.input("lu_in", width_.light, true);
    const Symbolic lv = claim.netlist.input("lv_in", width_.light, true);
    connect_six(claim, "d");
    for (const char* name : {"uu", "vv", "uv", "lu", "lv"}) connect(claim, name);
    const auto p = reference::products(d, b, lu, lv);
    for (unsigned i = 0; i < 6; ++i) give(claim, numbered("p", i), p[i], width_.product[i]);
  }

  /// That |t| stays within 2^(term - 2) is the derivation in eval_widths.h; interval arithmetic
  /// does not see that the half that rounding adds is shifted by as much as it is large.
  void align() {
    Claim& claim = add("align");
    claim.parameters =
        some_parameters(config_, {"DeltaBits", "LightInt", "LightFrac", "BasisFrac", "Guard",
                                  "RoundNearest", "ShiftMin", "ShiftGroups", "FilterFrac"});
    const auto p = take_six(claim, "p", width_.product);
    const auto shift = shifts(claim);
    connect_six(claim, "p");
    const auto t = reference::align(config_, p, shift);
    for (unsigned i = 0; i < 6; ++i) {
      give(claim, numbered("t", i), t[i], width_.term, true, symmetric(width_.term - 2));
    }
  }

  /// Six shifts; with three groups a group's first stands for all of it.
  Six<Symbolic> shifts(Claim& claim) const {
    constexpr std::array<unsigned, 6> kFirst{0, 0, 0, 3, 3, 5};
    Six<Symbolic> shift;
    Names names;
    for (unsigned i = 0; i < 6; ++i) {
      const unsigned first = config_.shift_groups == 3 ? kFirst[i] : i;
      names.insert(names.begin(), numbered("shift", first));
      shift[i] = first == i ? claim.netlist.input(numbered("shift", i), 5, true,
                                                  {config_.shift_min, reference::kShiftMax})
                            : shift[first];
    }
    claim.inputs.push_back({"shift_i", names});
    return shift;
  }

  void sum() {
    Claim& claim = add("sum");
    claim.parameters = {{"TermW", width_.term}, {"SumW", width_.sum}};
    std::array<int, 6> bits{};
    bits.fill(width_.term);
    const auto t = take_six(claim, "t", bits);
    connect_six(claim, "t");
    give(claim, "acc", reference::sum(t), width_.sum);
  }

  void luminance() {
    Claim& claim = add("luminance");
    claim.parameters = some_parameters(config_, {"Guard", "LumBits", "LumFrac", "RoundNearest"});
    claim.parameters.emplace_back("SumW", width_.sum);
    const Symbolic acc = take(claim, "acc", width_.sum);
    connect(claim, "acc");
    const auto lum = reference::luminance(config_, acc);
    give(claim, "lum", lum.lum, width_.lum, false);
    give(claim, "saturated", lum.saturated, 1, false);
  }

  void color_products() {
    Claim& claim = add("color_products");
    const int rgb_bits = 8 + config_.filter_frac;
    claim.parameters = {{"LumW", width_.lum}, {"RgbW", rgb_bits}};
    const Symbolic lum = take(claim, "lum", width_.lum, false);
    Three<Symbolic> rgb;
    for (unsigned c = 0; c < 3; ++c) {
      rgb[c] = claim.netlist.input(numbered("rgb", c), rgb_bits, false);
    }
    connect(claim, "lum");
    claim.inputs.push_back({"rgb_i", packed("rgb", 3)});
    const auto product = reference::color_products(lum, rgb);
    for (unsigned c = 0; c < 3; ++c) {
      give(claim, kColors[c], product[c], width_.color_product, false);
    }
  }

  void color_scale() {
    Claim& claim = add("color_scale");
    claim.parameters =
        some_parameters(config_, {"LumBits", "LumFrac", "FilterFrac", "RoundNearest"});
    const Three<Symbolic> product{take(claim, kColors[0], width_.color_product, false),
                                  take(claim, kColors[1], width_.color_product, false),
                                  take(claim, kColors[2], width_.color_product, false)};
    const Symbolic lum = take(claim, "lum", width_.lum, false);
    const Symbolic rgb_map = claim.netlist.input("rgb_map_in", 1, false);
    for (const char* name : {"red", "green", "blue", "lum", "rgb_map"}) connect(claim, name);
    const auto lrgb = reference::color_scale(config_, product);
    const auto rgb = reference::color_direct(config_, Three<Symbolic>{lum, lum, lum});
    for (unsigned c = 0; c < 3; ++c) {
      const std::string name = numbered("out", c);
      claim.netlist.output(name, claim.netlist.select(rgb_map, rgb.out[c], lrgb.out[c]));
      claim.outputs.push_back({"rgb_o", static_cast<int>(8 * c), 8, false, name});
    }
    give(claim, "saturated", claim.netlist.select(rgb_map, rgb.saturated, lrgb.saturated), 1,
         false);
  }

  static constexpr std::array<const char*, 3> kColors{"red", "green", "blue"};

  EvalConfig config_;
  EvalWidths width_;
  std::vector<std::unique_ptr<Claim>> claims_;
};

}  // namespace

std::vector<std::unique_ptr<Claim>> step_claims(const EvalConfig& config) {
  return EvaluatorClaims(config).make();
}

std::unique_ptr<Claim> lerp_claim(reference::Rounding rounding, int bits) {
  auto claim = std::make_unique<Claim>();
  claim->name = "lerp";
  claim->module = "ptm_arith_lerp";
  claim->parameters = {{"Width", bits},
                       {"RoundNearest", rounding == reference::Rounding::nearest ? 1 : 0}};
  const Symbolic a = claim->netlist.input("a", bits, false);
  const Symbolic b = claim->netlist.input("b", bits, false);
  const Symbolic f = claim->netlist.input("f", reference::kLerpFrac, false);
  claim->inputs = {{"a_i", {"a"}}, {"b_i", {"b"}}, {"f_i", {"f"}}};
  claim->netlist.output("y", reference::lerp(rounding, a, b, f), unsigned_range(bits));
  claim->outputs = {{"y_o", 0, bits, false, "y"}};
  return claim;
}

}  // namespace ptm::testbench
