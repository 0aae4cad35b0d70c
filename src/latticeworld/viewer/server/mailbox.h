#ifndef LATTICEWORLD_VIEWER_SERVER_MAILBOX_H_
#define LATTICEWORLD_VIEWER_SERVER_MAILBOX_H_

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <mutex>
#include <utility>

namespace latticeworld {

// A way to the server's thread that may outlive it: what comes too late is dropped.
class Mailbox {
 public:
  // Gives it the context of the server's thread; until then what is posted is dropped, too.
  void Open(boost::asio::io_context* context) {
    const std::lock_guard<std::mutex> lock(mutex_);
    context_ = context;
  }
  template <typename Function>
  void Post(Function&& function) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (context_ != nullptr) boost::asio::post(*context_, std::forward<Function>(function));
  }
  void Close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    context_ = nullptr;
  }

 private:
  std::mutex mutex_;
  boost::asio::io_context* context_ = nullptr;  // guarded by mutex_; null: closed
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_VIEWER_SERVER_MAILBOX_H_
