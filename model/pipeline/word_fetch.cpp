#include "model/pipeline/word_fetch.h"

#include <algorithm>
#include <string>

namespace ptm::pipeline {

using reference::Fragment;

WordFetch::WordFetch(const sc_core::sc_module_name& name, int tmus,
                     const TextureDescriptor& texture, const sc_core::sc_time& clock)
    : sc_module(name),
      tmu("tmu", static_cast<std::size_t>(tmus)),
      texture_(texture),
      clock_(clock) {
  in.bind(*this);
  payload_.set_command(tlm::TLM_READ_COMMAND);
  payload_.set_data_length(4);
  payload_.set_streaming_width(4);
  payload_.set_byte_enable_ptr(nullptr);
}

void WordFetch::reset() {
  address_free_ = request_free_ = words_free_ = operands_free_ = 0;
  words_fetched_ = 0;
}

/// Reads one word; returns the cycle from which it is usable.
Cycle WordFetch::read_word(int tmu_index, int plane, std::uint64_t x, std::uint64_t y,
                           Cycle requested) {
  const std::uint64_t address = texture_.layout.word(plane, x, y) * 4;
  payload_.set_address(address);
  payload_.set_data_ptr(reinterpret_cast<unsigned char*>(&words_[static_cast<std::size_t>(plane)]));
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  sc_core::sc_time delay = sc_core::sc_time::from_value(requested * clock_.value());
  tmu[static_cast<std::size_t>(tmu_index)]->b_transport(payload_, delay);
  if (!payload_.is_response_ok()) {
    SC_REPORT_ERROR(name(), ("memory answers " + payload_.get_response_string() + " at byte " +
                             std::to_string(address))
                                .c_str());
  }
  ++words_fetched_;
  return delay.value() / clock_.value();
}

/// All beats of a fragment that has entered the address register; returns the cycle in which its
/// words enter the operand register.
Cycle WordFetch::fetch(const Fragment& fragment, Cycle from) {
  const auto x =
      static_cast<std::uint64_t>(reference::nearest_index(fragment.u, texture_.layout.width));
  const auto y =
      static_cast<std::uint64_t>(reference::nearest_index(fragment.v, texture_.layout.height));
  const int tmus = static_cast<int>(tmu.size());
  Cycle earliest = from;
  for (int plane = 0; plane < texture_.layout.planes; plane += tmus) {
    const Cycle requested = std::max(earliest, request_free_);
    const int end = std::min(plane + tmus, texture_.layout.planes);
    Cycle answered = requested + 1;
    for (int p = plane; p < end; ++p) {
      answered = std::max(answered, read_word(p - plane, p, x, y, requested));
    }
    const Cycle arrived = std::max(answered, words_free_);
    request_free_ = arrived;
    const bool last = end == texture_.layout.planes;
    words_free_ = last ? std::max(arrived + 1, operands_free_) : arrived + 1;
    earliest = requested + 1;
    if (last) address_free_ = requested;
  }
  return words_free_;
}

/// Of the gathered texel's polynomial number `pass`.
reference::Six<reference::Value> WordFetch::coefficients(unsigned pass) const {
  const auto a_word = static_cast<unsigned>(texture_.layout.a_word);
  reference::Six<reference::Value> coef{};
  for (unsigned i = 0; i < coef.size(); ++i) {
    const unsigned n = 6 * pass + i;
    coef[i] = reference::word_field(words_[n / a_word], static_cast<int>(n % a_word),
                                    texture_.layout.field_bits);
  }
  return coef;
}

/// Hands the gathered texel to the evaluator, pass by pass; returns the cycle of the last one.
Cycle WordFetch::dispatch(const Fragment& fragment, Cycle from) {
  EvaluatorBeat beat;
  beat.bias = texture_.bias;
  beat.shift = texture_.shift;
  beat.lu = fragment.lu;
  beat.lv = fragment.lv;
  beat.id = {fragment.x, fragment.y};
  beat.rgb_map = texture_.layout.rgb;
  if (!beat.rgb_map) {
    const std::uint32_t color = words_[static_cast<std::size_t>(texture_.layout.planes - 1)];
    for (int c = 0; c < 3; ++c) {
      beat.rgb[static_cast<std::size_t>(c)] = reference::word_field(color, c, 8);
    }
  }
  Cycle taken = from;
  for (unsigned pass = 0; pass < (beat.rgb_map ? 3U : 1U); ++pass) {
    beat.coef = coefficients(pass);
    beat.channel = pass;
    taken = out->accept(beat, pass == 0 ? from : taken + 1);
  }
  return taken;
}

Cycle WordFetch::accept(const Fragment& fragment, Cycle offered) {
  const Cycle taken = std::max(offered, address_free_);
  const Cycle gathered = fetch(fragment, taken + 1);
  operands_free_ = dispatch(fragment, gathered + 1);
  return taken;
}

}  // namespace ptm::pipeline
