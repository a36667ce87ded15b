// ptmsim synthesize: photographs where nobody has any.
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "golden/files/light_positions.h"
#include "golden/files/picture_file.h"
#include "golden/scene/relief.h"
#include "testbench/program/commands.h"
#include "testbench/program/progress.h"

namespace ptm::testbench {
namespace {

namespace fs = std::filesystem;

struct SynthesizeOptions {
  std::string out;
  int size = 384;
  int lights = 50;
  std::uint64_t seed = 1;
};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    throw golden::InputError(folder.string(), "folder", error ? error.message() : "a file",
                             "a folder that can be made or is there");
  }
}

void synthesize(const SynthesizeOptions& options) {
  const fs::path folder = options.out;
  make_folder(folder);
  const golden::Relief relief({.size = options.size, .seed = options.seed});
  std::vector<golden::LitPicture> pictures;
  const auto directions = golden::spread_lights(options.lights);
  Progress progress("photographs", directions.size());
  for (const auto& direction : directions) {
    std::ostringstream name;
    name << "photo_" << std::setw(3) << std::setfill('0') << pictures.size() + 1 << ".png";
    pictures.push_back({.picture = folder / name.str(), .direction = direction});
    golden::write_picture(pictures.back().picture, relief.photograph(direction));
    progress.step();
  }
  // The list comes last: where it stands, all that it names stands too.
  const fs::path list = folder / "capture.lp";
  golden::write_light_positions(list, pictures);
  std::cout << pictures.size() << " photographs of " << options.size << " x " << options.size
            << " pixels: " << list.string() << '\n';
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
      ->check(CLI::Range(1, 999))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "another stone, another number")
      ->capture_default_str();
  command->callback([options] { synthesize(*options); });
}

}  // namespace ptm::testbench
