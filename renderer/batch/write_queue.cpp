// SPDX-License-Identifier: Apache-2.0
#include "batch/write_queue.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "error.h"

namespace umbrage {
namespace {

// A 4K frame with all AOVs is half a gigabyte: workers may be many, waiting frames not.
constexpr std::size_t kMostWaiting = 2;

}  // namespace

WriteQueue::WriteQueue(int workerCount, std::function<void(const Item&)> write) : write_(std::move(write)) {
    if (workerCount <= 0) workerCount = std::max(1, int(std::thread::hardware_concurrency()) - 1);
    try {
        for (int i = 0; i < workerCount; ++i) workers_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
        if (workers_.empty()) throw Error(ErrorKind::Output, "", "no thread can be started to write files");
    }
}

WriteQueue::~WriteQueue() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

void WriteQueue::rethrow() {
    if (error_) std::rethrow_exception(error_);
}

void WriteQueue::push(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < kMostWaiting || error_; });
    rethrow();
    waiting_.push_back(std::move(item));
    changed_.notify_all();
}

std::vector<WriteQueue::Done> WriteQueue::takeDone() {
    const std::lock_guard lock(mutex_);
    rethrow();
    return std::exchange(done_, {});
}

std::vector<WriteQueue::Done> WriteQueue::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return (waiting_.empty() && writing_.empty()) || error_; });
    rethrow();
    return std::exchange(done_, {});
}

bool WriteQueue::isReady() const {
    const std::optional<int>& other = waiting_.front().sameAs;
    return !other || std::ranges::find(writing_, *other) == writing_.end();
}

void WriteQueue::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return error_ || (waiting_.empty() ? closed_ : isReady()); });
        if (waiting_.empty() || error_) return;
        const Item item = std::move(waiting_.front());
        waiting_.pop_front();
        writing_.push_back(item.frame);
        changed_.notify_all();
        lock.unlock();
        const auto start = std::chrono::steady_clock::now();
        std::exception_ptr error;
        try {
            write_(item);
        } catch (...) {
            error = std::current_exception();
        }
        const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
        lock.lock();
        std::erase(writing_, item.frame);
        if (error) {
            if (!error_) error_ = error;
        } else {
            done_.push_back({item.frame, elapsed.count()});
        }
        changed_.notify_all();
    }
}

}  // namespace umbrage
