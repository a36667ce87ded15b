// Written by scripts/contract from contract/parameters.toml; change it there.
    .CoefBits(CoefBits), .DeltaBits(DeltaBits), .LightInt(LightInt), .LightFrac(LightFrac),
    .BasisFrac(BasisFrac), .Guard(Guard), .RoundNearest(RoundNearest), .LumBits(LumBits),
    .LumFrac(LumFrac), .ShiftMin(ShiftMin), .ShiftGroups(ShiftGroups), .FilterFrac(FilterFrac)
