// Threads that do what may take long, with a queue that does not grow without end.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace rectilin::serve {

class Workers {
 public:
  Workers(std::size_t threads, std::size_t longest_queue);
  ~Workers() { finish(); }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// False if the queue is full or work is finished; the task is not done then. Tasks must not throw.
  bool add(std::function<void()> task);
  /// Does what is in the queue, then ends; nothing is taken any more.
  void finish();

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<std::function<void()>> queue_;
  std::size_t longest_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace rectilin::serve
