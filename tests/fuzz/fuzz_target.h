#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What a fuzz target consists of. Each source file of this folder whose name ends in _fuzz.cpp is
/// one: it defines the entry that libFuzzer calls and the inputs to begin with. The fuzz preset
/// links it with libFuzzer (scripts/fuzz); the other presets link it with replay_test.cpp.

/// Reads the bytes as the target's kind of file. An InputError is a right answer. Anything else
/// that is thrown, any report of a sanitizer and any broken promise of the reader ends the process.
/// Returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace ptm::tests {

/// A file to begin with. The reader takes it, unless its name begins with "refused".
struct FuzzSeed {
  std::string name;
  std::string bytes;
};

/// The target's seeds, made by the program itself.
[[nodiscard]] std::vector<FuzzSeed> fuzz_seeds();

/// Whether the reader takes the bytes; throws what is not an InputError.
[[nodiscard]] bool fuzz_reads(const std::uint8_t* data, std::size_t size);

}  // namespace ptm::tests
