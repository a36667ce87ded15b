#include "model/pipeline/unit/effect_chain.h"

#include <algorithm>
#include <string>

#include "model/pipeline/effects/stages.h"

namespace ptm::pipeline {
namespace {

template <int kRegisters>
class StageModule final : public EffectStage {
 public:
  /// `next`: the stage behind this one, nullptr for the last.
  StageModule(const sc_core::sc_module_name& name, EffectStage* next, UnitSink& sink)
      : EffectStage(name), next_(next), sink_(sink) {}

  Cycle accept(Cycle offered) override {
    return registers_.accept(offered, [&](Cycle at_output) {
      return next_ == nullptr ? sink_.accept(at_output) : next_->accept(at_output);
    });
  }
  void reset() override { registers_ = {}; }

 private:
  EffectStage* next_;
  UnitSink& sink_;
  RegisterChain<static_cast<std::size_t>(kRegisters)> registers_;
};

using Make = std::unique_ptr<EffectStage> (*)(const char* name, EffectStage* next, UnitSink& sink);

template <class Stage>
std::unique_ptr<EffectStage> make(const char* name, EffectStage* next, UnitSink& sink) {
  return std::make_unique<StageModule<Stage::registers>>(name, next, sink);
}

struct Row {
  unsigned bit;
  const char* name;
  Make make;
};
#define PTM_ROW(id) Row{reference::effects::stage_bit(#id), #id "_stage", make<effects::id>},
constexpr auto kRows =
    std::to_array<Row>({PTM_PIPELINE_STAGES(PTM_ROW){0, "", nullptr}});  // the last: no stage
#undef PTM_ROW

}  // namespace

EffectStage::~EffectStage() = default;

EffectChain::EffectChain(unsigned stages, UnitSink& sink) {
  for (auto row = kRows.rbegin(); row != kRows.rend(); ++row) {
    if ((stages & row->bit) == 0) continue;
    EffectStage* next = stages_.empty() ? nullptr : stages_.back().get();
    stages_.push_back(row->make(row->name, next, sink));
  }
}

}  // namespace ptm::pipeline
