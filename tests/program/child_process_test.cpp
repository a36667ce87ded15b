// A model in a process of its own: its results come back, and so does whatever ends it.
#include "testbench/run/child_process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace ptm::testbench {
namespace {

std::string complaint(ChildProcess& child) {
  try {
    child.wait();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ChildProcess, EndsWhenTheProgramThatStartedItIsKilled) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t program = fork();
  ASSERT_GE(program, 0);
  if (program == 0) {
    ChildProcess child("waiting", [&](ResultFile&) {
      if (write(ends[1], "w", 1) == 1) pause();
    });
    pause();
  }
  close(ends[1]);
  char ready = 0;
  ASSERT_EQ(read(ends[0], &ready, 1), 1);
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  // Only the child holds the other end now: the pipe is closed when it has ended.
  pollfd closed{ends[0], POLLIN, 0};
  EXPECT_EQ(poll(&closed, 1, 20000), 1);
  EXPECT_EQ(read(ends[0], &ready, 1), 0);
  close(ends[0]);
}

TEST(ChildProcess, HandsBackValuesAndVectorsInOrder) {
  ChildProcess child("a model", [](ResultFile& file) {
    file.put(std::vector<int>{3, 1, 4});
    file.put(2.5);
    file.put(std::vector<char>{});
  });
  ResultFile& file = child.wait();
  EXPECT_EQ(file.get_vector<int>(), (std::vector<int>{3, 1, 4}));
  EXPECT_EQ(file.get<double>(), 2.5);
  EXPECT_TRUE(file.get_vector<char>().empty());
  EXPECT_THROW((void)file.get<int>(), std::runtime_error) << "there is no more";
}

TEST(ChildProcess, PassesOnWhatTheWorkThrewEvenAfterItWroteSomething) {
  ChildProcess child("a model", [](ResultFile& file) {
    file.put(std::vector<int>(1000, 7));
    throw std::runtime_error("pixel 5 never came");
  });
  EXPECT_EQ(complaint(child), "a model: pixel 5 never came");
}

TEST(ChildProcess, SaysWhereThereIsNoRoomForItsResultsWhenItWritesOrEnds) {
  std::signal(SIGXFSZ, SIG_IGN);
  for (const std::size_t room : {std::size_t{0}, std::size_t{100}, std::size_t{5000}}) {
    for (const std::size_t bytes : {std::size_t{200}, std::size_t{1} << 20}) {
      ChildProcess child("a model", [&](ResultFile& file) {
        const rlimit limit{room, room};
        setrlimit(RLIMIT_FSIZE, &limit);
        file.put(std::vector<char>(bytes));
      });
      if (bytes + 9 <= room) {
        EXPECT_EQ(child.wait().get_vector<char>().size(), bytes);
        continue;
      }
      const std::string said = complaint(child);
      EXPECT_NE(said.find("a model's results: found "), std::string::npos) << said;
    }
  }
}

TEST(ChildProcess, NamesTheSignalThatEndedIt) {
  ChildProcess child("a model", [](ResultFile&) { std::raise(SIGKILL); });
  EXPECT_EQ(complaint(child), "a model ended by signal 9");
}

}  // namespace
}  // namespace ptm::testbench
