// Every width of the datapath, derived from the parameters of the evaluator. Formats only.
//
// Twin: model/reference/eval_widths.h, which derives each one in its comment; the two are compared
// for every variant by tests/rtl/constants_test.cpp. All values are signed two's complement unless
// "unsigned" is said. Functions assign to their own name: Yosys 0.23 does not know `return`.
package ptm_pkg;

  localparam int ShiftMax = 15;     // highest shift; the lowest is the parameter ShiftMin
  localparam int ShiftBits = 5;     // holds -8..15
  localparam int RgbBits = 8;       // integer bits of a colour, unsigned
  localparam int LerpFracBits = 8;  // filter weights are Q0.8

  function automatic int larger(input int a, input int b);
    larger = a > b ? a : b;
  endfunction

  // A coefficient's field in a word of 32 bits, and how many of them a word holds.
  function automatic int field_bits(input int CoefBits);
    field_bits = larger(8, CoefBits);
  endfunction

  function automatic int coefficients_a_word(input int CoefBits);
    coefficients_a_word = CoefBits > 10 ? 2 : 3;
  endfunction

  // Unsigned: a coefficient with its filter fraction.
  function automatic int stored_bits(input int CoefBits, input int FilterFrac);
    stored_bits = CoefBits + FilterFrac;
  endfunction

  // D1
  function automatic int delta_bits(input int DeltaBits, input int FilterFrac);
    delta_bits = DeltaBits + FilterFrac;
  endfunction

  function automatic int light_bits(input int LightInt, input int LightFrac);
    light_bits = LightInt + LightFrac;
  endfunction

  // D2: one bit less than the square of the most negative light needs; D2 saturates.
  function automatic int basis_bits(input int LightInt, input int BasisFrac);
    basis_bits = 2 * LightInt - 1 + BasisFrac;
  endfunction

  // D3, product i of 0..5; p5 = d5. n bits times m bits fit n + m bits.
  function automatic int product_bits(input int i, input int DeltaBits, input int LightInt,
                                      input int LightFrac, input int BasisFrac,
                                      input int FilterFrac);
    product_bits = delta_bits(DeltaBits, FilterFrac) +
        (i < 3 ? basis_bits(LightInt, BasisFrac) : i < 5 ? light_bits(LightInt, LightFrac) : 0);
  endfunction

  // Fraction bits of product i.
  function automatic int frac_bits(input int i, input int LightFrac, input int BasisFrac,
                                   input int FilterFrac);
    frac_bits = FilterFrac + (i < 3 ? BasisFrac : i < 5 ? LightFrac : 0);
  endfunction

  // D4, term i: fraction bits dropped at the lowest shift, negative if bits are appended.
  function automatic int fewest_dropped(input int i, input int LightFrac, input int BasisFrac,
                                        input int Guard, input int ShiftMin, input int FilterFrac);
    fewest_dropped = frac_bits(i, LightFrac, BasisFrac, FilterFrac) + ShiftMin - Guard;
  endfunction

  // D4, term i: the constant left shift that makes every right shift non-negative.
  function automatic int pre_shift(input int i, input int LightFrac, input int BasisFrac,
                                   input int Guard, input int ShiftMin, input int FilterFrac);
    pre_shift = larger(0, -fewest_dropped(i, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac));
  endfunction

  // D4, term i: largest right shift, at shift = ShiftMax.
  function automatic int amount_max(input int i, input int LightFrac, input int BasisFrac,
                                    input int Guard, input int ShiftMin, input int FilterFrac);
    amount_max = frac_bits(i, LightFrac, BasisFrac, FilterFrac) + ShiftMax - Guard +
        pre_shift(i, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  endfunction

  // D4: |t[i]| <= 2^exponent.
  function automatic int term_exponent_of(input int i, input int DeltaBits, input int LightInt,
                                          input int LightFrac, input int BasisFrac,
                                          input int Guard, input int ShiftMin,
                                          input int FilterFrac);
    term_exponent_of =
        (i < 5 ? product_bits(i, DeltaBits, LightInt, LightFrac, BasisFrac, FilterFrac) - 2
               : delta_bits(DeltaBits, FilterFrac) - 1) -
        fewest_dropped(i, LightFrac, BasisFrac, Guard, ShiftMin, FilterFrac);
  endfunction

  // D4: [-2^exponent, 2^exponent] takes exponent + 2 bits. Terms 0, 1, 2 are alike, so are 3, 4.
  function automatic int term_bits(input int DeltaBits, input int LightInt, input int LightFrac,
                                   input int BasisFrac, input int Guard, input int ShiftMin,
                                   input int FilterFrac);
    term_bits = 2 + larger(
        larger(0, term_exponent_of(0, DeltaBits, LightInt, LightFrac, BasisFrac, Guard, ShiftMin,
                                   FilterFrac)),
        larger(term_exponent_of(3, DeltaBits, LightInt, LightFrac, BasisFrac, Guard, ShiftMin,
                                FilterFrac),
               term_exponent_of(5, DeltaBits, LightInt, LightFrac, BasisFrac, Guard, ShiftMin,
                                FilterFrac)));
  endfunction

  // D5: six terms, |acc| <= 6 * 2^exponent < 2^(exponent + 3).
  function automatic int sum_bits(input int DeltaBits, input int LightInt, input int LightFrac,
                                  input int BasisFrac, input int Guard, input int ShiftMin,
                                  input int FilterFrac);
    sum_bits = 2 + term_bits(DeltaBits, LightInt, LightFrac, BasisFrac, Guard, ShiftMin,
                             FilterFrac);
  endfunction

  // D6, unsigned
  function automatic int lum_bits(input int LumBits, input int LumFrac);
    lum_bits = LumBits + LumFrac;
  endfunction

  // D7, unsigned: a colour with its filter fraction, and lum times it before narrowing
  function automatic int rgb_bits(input int FilterFrac);
    rgb_bits = RgbBits + FilterFrac;
  endfunction

  function automatic int color_product_bits(input int LumBits, input int LumFrac,
                                            input int FilterFrac);
    color_product_bits = lum_bits(LumBits, LumFrac) + rgb_bits(FilterFrac);
  endfunction

endpackage
