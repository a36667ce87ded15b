#pragma once
#include <tlm_utils/simple_initiator_socket.h>

#include <systemc>
#include <tlm>

#include "model/pipeline/stream.h"
#include "model/reference/fragment.h"
#include "model/reference/texel_format.h"
#include "model/reference/texture_words.h"

namespace ptm::pipeline {

/// The texture a unit draws from, as its descriptor holds it.
struct TextureDescriptor {
  reference::TextureLayout layout;
  reference::Six<reference::Value> bias{}, shift{};
};

/// Fetches the words of a texel, `tmus` a cycle, and hands its operands to the evaluator.
///
/// Point sampling from a memory without misses: the place that address, tags, commit and filter
/// take in the whole unit. The unit of work is a beat, one word a TMU (T1); a texel is
/// ceil(words / tmus) beats, its words the planes of its layout. Storage, each accepting when empty
/// or being emptied (T6):
///
///     address    the fragment, until its last beat has gone
///     request    a beat's addresses, at the memory
///     words      a beat's words; all but the last go on to the gather register unconditionally
///     operands   the texel's words, until the evaluator has taken every pass (RGB: three)
///
/// Latency   3 + ceil(words / tmus) cycles from the fragment's transfer to the evaluator's, when
///           nothing stalls. Rate: max(ceil(words / tmus), passes) cycles a fragment.
/// Bad input a memory response other than OK is reported as an SC_ERROR with the address.
class WordFetch final : public sc_core::sc_module, public StreamTarget<reference::Fragment> {
 public:
  sc_core::sc_export<StreamTarget<reference::Fragment>> in{"in"};
  sc_core::sc_port<StreamTarget<EvaluatorBeat>> out{"out"};
  sc_core::sc_vector<tlm_utils::simple_initiator_socket<WordFetch>> tmu;

  /// Requires 1 <= tmus <= 3.
  WordFetch(const sc_core::sc_module_name& name, int tmus, const TextureDescriptor& texture,
            const sc_core::sc_time& clock);

  Cycle accept(const reference::Fragment& fragment, Cycle offered) override;
  void reset();
  [[nodiscard]] std::uint64_t words_fetched() const { return words_fetched_; }

 private:
  [[nodiscard]] Cycle fetch(const reference::Fragment& fragment, Cycle from);
  [[nodiscard]] Cycle read_word(int tmu_index, int plane, std::uint64_t x, std::uint64_t y,
                                Cycle requested);
  [[nodiscard]] reference::Six<reference::Value> coefficients(unsigned pass) const;
  [[nodiscard]] Cycle dispatch(const reference::Fragment& fragment, Cycle from);

  TextureDescriptor texture_;
  sc_core::sc_time clock_;
  tlm::tlm_generic_payload payload_;
  /// Of the fragment at hand, one a plane.
  std::array<std::uint32_t, contract::kFormatWordsMax> words_{};
  /// When the previous item left each register.
  Cycle address_free_ = 0, request_free_ = 0, words_free_ = 0, operands_free_ = 0;
  std::uint64_t words_fetched_ = 0;
};

}  // namespace ptm::pipeline
