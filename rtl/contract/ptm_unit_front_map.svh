// Written by scripts/contract from contract/parameters.toml; change it there.
    .CoefBits(CoefBits), .Tmus(Tmus), .CacheKib(CacheKib), .Ways(Ways), .FragmentFifo(FragmentFifo),
    .MissFifo(MissFifo), .ExtraSets(ExtraSets), .Stages(Stages), .Counters(Counters),
    .DuplicateLines(DuplicateLines)
