// D1 to D7: every RTL module equals the reference's function for every input, by SAT.
#include <gtest/gtest.h>

#include <iostream>

#include "testbench/prove/evaluator_claims.h"
#include "testbench/prove/solver.h"
#include "testbench/rtl/rtl_variants.h"
#include "testbench/rtl/yosys.h"
#include "tests/formal/changed_rtl.h"

namespace ptm::testbench {
namespace {

using reference::EvalConfig;

struct Configuration {
  const char* name;
  EvalConfig config;
};

const Configuration kConfigurations[] = {{"paper8", reference::kPaper8},
                                         {"base", reference::kBase},
                                         {"wide", reference::kWide},
                                         {"small", kSmall},
                                         {"large", kLarge}};

constexpr const char* kSteps[] = {"unpack", "basis",     "products",       "align",
                                  "sum",    "luminance", "color_products", "color_scale"};

std::unique_ptr<Claim> claim_of(const EvalConfig& config, const std::string& step) {
  for (auto& claim : step_claims(config)) {
    if (claim->name == step) return std::move(claim);
  }
  throw std::logic_error("no claim on " + step);
}

class StepClaims : public testing::TestWithParam<std::tuple<Configuration, const char*>> {};

TEST_P(StepClaims, HoldForEveryInput) {
  const auto& [configuration, step] = GetParam();
  const auto claim = claim_of(configuration.config, step);
  const Answer answer = prove(*claim, rtl_sources("rtl/files.f"));
  EXPECT_EQ(answer.verdict, Verdict::holds);
  for (const auto& [name, value] : answer.counterexample) {
    std::cout << "  " << name << " = " << value << '\n';
  }
  std::cout << configuration.name << ' ' << step << ": " << answer.seconds << " s\n";
}

INSTANTIATE_TEST_SUITE_P(Presets, StepClaims,
                         testing::Combine(testing::ValuesIn(kConfigurations),
                                          testing::ValuesIn(kSteps)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param).name) + '_' +
                                  std::get<1>(test.param);
                         });

TEST(LerpClaim, HoldsForEveryInputOfEveryWidth) {
  // Coefficients of 4 to 12 bits and colours of 8, each with up to 4 fraction bits.
  for (const auto rounding : {reference::Rounding::nearest, reference::Rounding::truncate}) {
    for (int bits = 4; bits <= 16; ++bits) {
      const Answer answer = prove(*lerp_claim(rounding, bits), rtl_sources("rtl/files.f"));
      EXPECT_EQ(answer.verdict, Verdict::holds) << bits;
    }
  }
}

TEST(LerpClaim, FailsForAChangedModule) {
  const tests::ChangedRtl changed("rtl/arith/ptm_arith_lerp.sv", "{a_i, Half} + product",
                                  "{a_i, Half} + product + SumW'(a_i == 200 && b_i == 17)");
  const Answer answer = prove(*lerp_claim(reference::Rounding::nearest, 8), changed.files());
  EXPECT_EQ(answer.verdict, Verdict::fails);
}

/// One character or so of a step's module, which random vectors may or may not come across.
struct Mutant {
  const char *step, *file, *from, *to;
};

class StepClaimsOf : public testing::TestWithParam<Mutant> {};

TEST_P(StepClaimsOf, AChangedModuleFailsWithTheInputThatShowsIt) {
  const Mutant& mutant = GetParam();
  const tests::ChangedRtl changed(mutant.file, mutant.from, mutant.to);
  const auto claim = claim_of(reference::kBase, mutant.step);
  const Answer answer = prove(*claim, changed.files());
  EXPECT_EQ(answer.verdict, Verdict::fails);
  std::size_t inputs = 0;
  for (const Netlist::Port& input : claim->netlist.inputs()) {
    for (const auto& [name, value] : answer.counterexample) inputs += name == input.name;
  }
  EXPECT_EQ(inputs, claim->netlist.inputs().size());
}

INSTANTIATE_TEST_SUITE_P(
    Base, StepClaimsOf,
    testing::Values(
        Mutant{"unpack", "rtl/evaluator/ptm_evaluator_unpack.sv", "coef - bias;",
               "coef - bias - (&coef[StoredW-1:0] && &bias[CoefBits-1:0]);"},
        Mutant{"basis", "rtl/evaluator/ptm_evaluator_basis.sv", "assign uv = lu * lv;",
               "assign uv = lu * lv + (lu == -3 && lv == 7 ? SquareW'(256) : SquareW'(0));"},
        Mutant{"products", "rtl/evaluator/ptm_evaluator_products.sv", "p5_o = d5_i",
               "p5_o = d5_i == 5 ? 'x : d5_i"},
        Mutant{"align", "rtl/arith/ptm_arith_narrow.sv", "(InBits+1)'(1)",
               "(InBits+1)'(!(&x_i[8:0]))"},
        Mutant{"sum", "rtl/evaluator/ptm_evaluator_sum.sv", "SumW'(t5_i)",
               "SumW'($unsigned(t5_i))"},
        Mutant{"luminance", "rtl/evaluator/ptm_evaluator_luminance.sv", "negative || above",
               "(negative && acc_i != -9) || above"},
        Mutant{"color_products", "rtl/evaluator/ptm_evaluator_color_products.sv",
               "blue_o  = ProductW'(lum_i)",
               "blue_o  = ProductW'(lum_i & {LumW{rgb_i[7:0] != 8'd77}})"},
        Mutant{"color_scale", "rtl/arith/ptm_arith_divide_255.sv", "128", "127"}),
    [](const auto& test) { return std::string(test.param.step); });

}  // namespace
}  // namespace ptm::testbench
