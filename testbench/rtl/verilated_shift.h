#pragma once
// Verilator 5.006 writes an arithmetic shift to the right as a logical one and a mask for the sign;
// C++20 defines the shift of a signed number, which is two instructions. Included before what
// Verilator wrote, it takes the place of VL_SHIFTRS_III.
#include <verilated.h>

namespace ptm::testbench {

/// lhs, lbits wide (1..32) and signed, shifted right by rhs (0..31); its lowest obits.
inline IData shift_right_signed(int obits, int lbits, IData lhs, IData rhs) {
  const int unused = 32 - lbits;
  return static_cast<IData>(static_cast<int32_t>(lhs << unused) >> unused >> rhs) &
         VL_MASK_I(obits);
}

}  // namespace ptm::testbench

#define VL_SHIFTRS_III(obits, lbits, rbits, lhs, rhs) \
  ::ptm::testbench::shift_right_signed(obits, lbits, lhs, rhs)
