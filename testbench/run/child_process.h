#pragma once
#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace ptm::testbench {

/// Plain values and vectors of them, through an unnamed temporary file that two processes share.
class ResultFile {
 public:
  ResultFile();  ///< throws std::runtime_error, as put() and flush() do, where it cannot be written

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { write(&value, sizeof value); }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const std::vector<T>& values) {
    put(std::uint64_t{values.size()});
    write(values.data(), values.size() * sizeof(T));
  }
  void put(const std::string& text) { put(std::vector<char>(text.begin(), text.end())); }

  template <class T>
  [[nodiscard]] T get() {
    T value{};
    read(&value, sizeof value);
    return value;
  }
  template <class T>
  [[nodiscard]] std::vector<T> get_vector() {
    std::vector<T> values(get<std::uint64_t>());
    read(values.data(), values.size() * sizeof(T));
    return values;
  }

  void flush();
  void rewind();
  /// What was thrown when it could not be written, in full; empty before.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  [[noreturn]] void fail();
  void write(const void* data, std::size_t bytes);
  void read(void* data, std::size_t bytes);

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::string fault_;
};

/// Work in a process of its own: SystemC elaborates once a process, and a model that crashes takes
/// only its own process with it. Fork before any thread starts.
class ChildProcess {
 public:
  using Work = std::function<void(ResultFile&)>;

  /// Starts at once. `what` names the work in errors.
  ChildProcess(std::string what, const Work& work);
  ~ChildProcess();  ///< ends a child that nobody waited for
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for the end; the file stands at its beginning. Throws std::runtime_error with the
  /// child's own message if the work threw, and with the signal or status if it ended otherwise.
  ResultFile& wait();

 private:
  std::string what_;
  ResultFile file_;
  pid_t child_ = -1;
};

}  // namespace ptm::testbench
