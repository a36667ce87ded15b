#include "contract/generator/counters.h"

#include <algorithm>

#include "contract/generator/table.h"

namespace ptm::contract {
namespace {

/// The words of an index in names: its numbers, or what the table says.
std::vector<std::string> words_of(const Row& row) {
  if (row.has("words")) return row.texts("words");
  std::vector<std::string> words;
  for (std::int64_t n = 0; n < row.integer("count"); ++n) words.push_back(std::to_string(n));
  return words;
}

void replace(std::string& name, const std::string& index, const std::string& word) {
  const std::size_t at = name.find("{" + index + "}");
  if (at != std::string::npos) name.replace(at, index.size() + 2, word);
}

/// Adds the counters of a row from its repeat number `level` on.
void add(const Row& row, const CounterRow& made, std::size_t level, Counter counter,
         Counters& out) {
  const std::vector<Row> repeats = row.rows("repeat");
  if (level < repeats.size()) {
    const std::vector<std::string> words = words_of(repeats[level]);
    for (std::size_t n = 0; n < words.size(); ++n) {
      Counter one = counter;
      replace(one.name, repeats[level].text("index"), words[n]);
      one.number += static_cast<unsigned>(n) * made.repeats[level].stride;
      add(row, made, level + 1, one, out);
    }
    return;
  }
  for (const Counter& other : out.all) {
    if (other.name == counter.name) row.fail("name", "found '" + counter.name + "' a second time");
    if (other.number == counter.number) {
      row.fail("number", std::to_string(counter.number) + " is taken by '" + other.name + "'");
    }
  }
  out.all.push_back(counter);
}

}  // namespace

Counters read_counters(const std::filesystem::path& path,
                       const std::vector<std::string>& parameters) {
  const TableFile file(path);
  file.only({"counter"});
  Counters out;
  for (const Row& row : file.rows("counter")) {
    row.only({"number", "name", "meaning", "needs", "spared", "page", "repeat"});
    CounterRow made{row.text("name"), row.text("meaning"), row.text_or("needs", ""),
                    row.text_or("page", "")};
    const std::int64_t number = row.integer("number");
    if (number < 0 || number > 63) {
      row.fail("number", "found " + std::to_string(number) + ", expected 0 to 63");
    }
    made.number = static_cast<unsigned>(number);
    made.spared = row.flag_or("spared", false);
    if (!made.need.empty() &&
        std::find(parameters.begin(), parameters.end(), made.need) == parameters.end()) {
      row.fail("needs", "found '" + made.need + "', no parameter");
    }
    for (const Row& repeat : row.rows("repeat")) {
      repeat.only({"index", "count", "words", "stride"});
      made.repeats.push_back({repeat.text("index"), static_cast<unsigned>(words_of(repeat).size()),
                              static_cast<unsigned>(repeat.integer("stride"))});
    }
    add(row, made, 0, {made.name, made.need, made.number, made.spared}, out);
    out.rows.push_back(made);
  }
  std::sort(out.all.begin(), out.all.end(),
            [](const Counter& a, const Counter& b) { return a.number < b.number; });
  for (unsigned n = 0; n < out.all.size(); ++n) {
    if (out.all[n].number != n) {
      throw TableError(path.filename().string() + ": no counter has the number " +
                       std::to_string(n) + ", but '" + out.all[n].name + "' has " +
                       std::to_string(out.all[n].number));
    }
  }
  return out;
}

}  // namespace ptm::contract
