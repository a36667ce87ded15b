// ptm_contract: makes from the tables of the contract what software, hardware, drivers and readers
// take from them.
#include <cstring>
#include <exception>
#include <iostream>

#include "contract/generator/emit.h"
#include "contract/generator/table.h"

namespace {

int usage() {
  std::cerr
      << "ptm_contract TABLES FOLDER              writes everything under FOLDER\n"
         "ptm_contract TABLES --refresh REPOSITORY  brings the committed files up to date\n"
         "ptm_contract TABLES --check REPOSITORY    says which of them are not: exit code 1\n";
  return 2;
}

int run(int argc, char** argv) {
  using namespace ptm::contract;
  if (argc < 3) return usage();
  const bool refresh = std::strcmp(argv[2], "--refresh") == 0;
  const bool check = std::strcmp(argv[2], "--check") == 0;
  if (argc != (refresh || check ? 4 : 3)) return usage();
  const Outputs outputs = all_outputs(read_tables(argv[1]));
  if (refresh) {
    refresh_committed(outputs, argv[3]);
  } else if (check) {
    const auto stale = stale_committed(outputs, argv[3]);
    for (const std::string& what : stale) std::cout << what << '\n';
    if (!stale.empty()) std::cout << "run scripts/contract\n";
    return stale.empty() ? 0 : 1;
  } else {
    write_outputs(outputs, argv[2]);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {  // TableError, or a file that cannot be written
    std::cerr << "ptm_contract: " << error.what() << '\n';
    return 3;
  }
}
