// SPDX-License-Identifier: Apache-2.0
// Worker threads that write finished frames while the next is rendered. Bounded: when all workers are busy and a few
// frames wait, push() waits, so memory stays bounded too.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "frame/frame.h"

namespace umbrage {

class WriteQueue {
public:
    struct Item {
        int frame = 0;
        std::unique_ptr<FramePixels> pixels, against;  // against: see writeFrameFiles()
        std::optional<int> sameAs;                     // an earlier frame, pushed before; then there are no pixels
    };
    struct Done {
        int frame = 0;
        double milliseconds = 0.0;
    };

    /// @param workerCount  0: one less than the processor has, at least one
    /// @param write  of a frame that is the same as another: called when that one is written
    WriteQueue(int workerCount, std::function<void(const Item&)> write);
    ~WriteQueue();

    /// @throws what a worker threw
    void push(Item item);
    /// Frames written since the last call, in no particular order. @throws what a worker threw
    std::vector<Done> takeDone();
    /// Waits for everything pushed. @throws what a worker threw
    std::vector<Done> finish();

private:
    void work();
    bool isReady() const;
    void rethrow();

    std::function<void(const Item&)> write_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Item> waiting_;
    std::vector<Done> done_;
    std::exception_ptr error_;
    std::vector<int> writing_;  // frames
    bool closed_ = false;
    std::vector<std::jthread> workers_;
};

}  // namespace umbrage
