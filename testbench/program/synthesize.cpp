// ptmsim synthesize: photographs where nobody has any.
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "golden/files/figure_text.h"
#include "golden/files/light_positions.h"
#include "golden/files/picture_file.h"
#include "golden/files/whole_file.h"
#include "golden/scene/relief.h"
#include "testbench/program/commands.h"
#include "testbench/program/option_checks.h"
#include "testbench/program/progress.h"
#include "testbench/report/staged_files.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLights = 999;

struct SynthesizeOptions {
  std::string out;
  int size = 384;
  int lights = 50;
  std::uint64_t seed = 1;
};

std::string photograph_name(std::size_t number) {
  std::ostringstream name;
  name << "photo_" << std::setw(3) << std::setfill('0') << number << ".png";
  return name.str();
}

/// Photographs of an earlier, larger capture: numbers from `first` that the list names.
std::vector<std::string> stale_photographs(const fs::path& list, std::size_t first) {
  std::vector<std::string> stale;
  std::string text;
  try {
    text = golden::read_text_file(list, "a list of light positions");
  } catch (const golden::InputError&) {
    return stale;  // no earlier capture
  }
  for (std::size_t number = first; number <= kMostLights; ++number) {
    const std::string name = photograph_name(number);
    if (text.find("\n" + name + " ") != std::string::npos) stale.push_back(name);
  }
  return stale;
}

void synthesize(const SynthesizeOptions& options) {
  const fs::path folder = options.out;
  StagedFiles files(folder);
  const golden::Relief relief({.size = options.size, .seed = options.seed});
  std::vector<golden::LitPicture> pictures;
  const auto directions = golden::spread_lights(options.lights);
  Progress progress("photographs", directions.size());
  for (const auto& direction : directions) {
    const std::string name = photograph_name(pictures.size() + 1);
    pictures.push_back({.picture = folder / name, .direction = direction});
    files.write(name, golden::encode_picture(name, relief.photograph(direction)));
    progress.step();
  }
  const fs::path list = folder / "capture.lp";
  for (const std::string& name : stale_photographs(list, pictures.size() + 1)) files.remove(name);
  // The list comes last: where it stands, all that it names stands too.
  files.write("capture.lp", golden::format_light_positions(list, pictures));
  files.commit();
  std::cout << golden::count_of(pictures.size(), "photograph") << " of " << options.size << " x "
            << options.size << " pixels: " << list.string() << '\n';
}

}  // namespace

void add_synthesize_command(CLI::App& app) {
  const auto options = std::make_shared<SynthesizeOptions>();
  CLI::App* command = app.add_subcommand(
      "synthesize", "Makes up a capture: photographs of a painted relief, and capture.lp");
  command->add_option("--out", options->out, "folder for the photographs")->required();
  command->add_option("--size", options->size, "pixels along each side")
      ->check(CLI::Range(16, 4096))
      ->capture_default_str();
  command->add_option("--lights", options->lights, "photographs, one a light")
      ->check(CLI::Range(std::size_t{1}, kMostLights))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "another stone, another number")
      ->check(whole_number())
      ->capture_default_str();
  command->callback([options] { synthesize(*options); });
}

}  // namespace ptm::testbench
