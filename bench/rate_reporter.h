#pragma once
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// A table of rates that holds on a shared machine.
///
/// Every row runs several times, the rows' turns shuffled, and is reported as best and median.
/// The best is the figure to hold against a requirement: the work of a row is the same each time,
/// so whatever else the machine does can only add time, and the fastest run is the one nearest to
/// what the program costs. The median says how disturbed the run was. The ratio to another row of
/// the same run tells a slower program from a slower machine.
namespace ptm::bench {

class RateReporter final : public benchmark::BenchmarkReporter {
 public:
  /// Rates are the counter of that name; a row `a/b` is set against `a/<base>`.
  RateReporter(std::string counter, std::string base)
      : counter_(std::move(counter)), base_(std::move(base)) {}

  [[nodiscard]] bool failed() const { return failed_; }

  bool ReportContext(const Context& /*context*/) override {
    std::printf("million %s a second of CPU time; the best is what counts\n", counter_.c_str());
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    const std::string& name = runs.front().run_name.function_name;
    for (const Run& run : runs) {
      if (run.error_occurred) {
        failed_ = true;
        std::printf("%s: %s\n", name.c_str(), run.error_message.c_str());
      } else if (run.run_type == Run::RT_Iteration) {
        rates_[name].push_back(run.counters.at(counter_) / 1e6);
      }
    }
  }

  /// The table; shuffled rows are reported in any order, so it waits for the last.
  void Finalize() override {
    std::printf("%-26s %8s %8s   best / best of %s\n", "", "best", "median", base_.c_str());
    for (auto& [name, rates] : rates_) {
      std::sort(rates.begin(), rates.end());
      std::printf("%-26s %8.2f %8.2f", name.c_str(), rates.back(), rates[rates.size() / 2]);
      const auto base = rates_.find(name.substr(0, name.find('/') + 1) + base_);
      if (base != rates_.end()) {
        std::printf("   %.3f",
                    rates.back() / *std::max_element(base->second.begin(), base->second.end()));
      }
      std::printf("\n");
    }
  }

 private:
  std::string counter_, base_;
  std::map<std::string, std::vector<double>> rates_;
  bool failed_ = false;
};

/// Runs what is registered, as BENCHMARK_MAIN() does, into that reporter. Returns the exit code.
/// What the command line says goes before the settings here.
inline int run_all(int argc, char** argv, RateReporter& reporter) {
  std::array settings{std::string("--benchmark_enable_random_interleaving=true"),
                      std::string("--benchmark_repetitions=25"),
                      std::string("--benchmark_min_time=0.05")};
  std::vector<char*> arguments{argv[0]};
  for (std::string& setting : settings) arguments.push_back(setting.data());
  for (int i = 1; i < argc; ++i) arguments.push_back(argv[i]);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return reporter.failed() ? 1 : 0;
}

}  // namespace ptm::bench
