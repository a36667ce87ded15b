// Written by scripts/contract from contract/parameters.toml; change it there.
        8'd128: probe_o = ProbeW'(CoefBits);
        8'd129: probe_o = ProbeW'(DeltaBits);
        8'd130: probe_o = ProbeW'(LightInt);
        8'd131: probe_o = ProbeW'(LightFrac);
        8'd132: probe_o = ProbeW'(BasisFrac);
        8'd133: probe_o = ProbeW'(Guard);
        8'd134: probe_o = ProbeW'(RoundNearest);
        8'd135: probe_o = ProbeW'(LumBits);
        8'd136: probe_o = ProbeW'(LumFrac);
        8'd137: probe_o = ProbeW'(ShiftMin);
        8'd138: probe_o = ProbeW'(ShiftGroups);
        8'd139: probe_o = ProbeW'(FilterFrac);
